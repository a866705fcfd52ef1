// Divides the surface stream into reports for the scanner.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "report.hpp"

namespace discmc::device {

class StreamReports {
 public:
  using Bytes = std::array<std::uint8_t, Report::bytes>;

  void put(const std::uint8_t* bytes, std::size_t count) {
    waiting_.insert(waiting_.end(), bytes, bytes + count);
  }

  /// Calls send(Bytes) with every full report; at the end also with the rest and the end.
  template <class Send>
  void send_full(Send send) {
    while (waiting_.size() >= Report::payload_bytes) send(part(Report::payload_bytes));
  }
  template <class Send>
  void send_all(Send send) {
    send_full(send);
    if (!waiting_.empty()) send(part(waiting_.size()));
    Bytes bytes;
    Report{Report::Kind::stream_end, 0, 0, number_, nullptr}.write(bytes.data());
    send(bytes);
  }

 private:
  Bytes part(std::size_t count) {
    Bytes bytes;
    Report{Report::Kind::stream, static_cast<std::uint8_t>(count), 0, number_++, waiting_.data()}
        .write(bytes.data());
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(count));
    return bytes;
  }

  std::vector<std::uint8_t> waiting_;
  std::uint32_t number_ = 0;
};

}  // namespace discmc::device

// The target of a device's stream: a file that grows during the scan, or standard output.
#pragma once

#include <discmc/encoder.hpp>
#include <fstream>
#include <string>

#include "streams/stream_output.hpp"

namespace discmc::device {

/// Written in place, so that the scanned part exists even if the program is killed.
class StreamTarget {
 public:
  /// path: "-" is standard output, which must not be a terminal. Throws std::runtime_error.
  explicit StreamTarget(const std::string& path);

  ByteOutput output() { return stream_.byte_output(); }

  /// Flushes everything. Throws std::runtime_error if a write has failed.
  void flush();

 private:
  std::string path_;
  std::ofstream file_;
  std::ostream* out_;
  command::StreamOutput stream_;
};

}  // namespace discmc::device

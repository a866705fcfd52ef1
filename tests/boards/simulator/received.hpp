// The streams of a device, decoded as they arrive.
#pragma once

#include <cstdint>
#include <discmc/decoder.hpp>
#include <discmc/extractor.hpp>
#include <map>
#include <memory>
#include <vector>

namespace discmc::simulator {

/// One stream, from its first header on.
class ReceivedStream {
 public:
  ReceivedStream();
  ReceivedStream(const ReceivedStream&) = delete;
  ReceivedStream& operator=(const ReceivedStream&) = delete;

  void push(const std::uint8_t* bytes, std::size_t count);
  void finish();
  SinkResult accept(const Event& event);

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  const StreamHeader& header() const { return decoder_.header(); }
  const StreamReport& report() const { return decoder_.report(); }
  /// Every region below this slice has arrived.
  std::uint32_t final_slices() const { return final_slices_; }
  /// The skipped rows, by their numbers over all slices, and their substitutes.
  const std::map<std::uint32_t, Substitute>& skipped() const { return skipped_; }

 private:
  Decoder decoder_;
  std::vector<std::uint8_t> bytes_;
  std::uint32_t final_slices_ = 0;
  std::map<std::uint32_t, Substitute> skipped_;
};

/// All received bytes. A device that is reset begins a new stream within the old one. The new
/// stream begins where the first frame recurs, byte by byte.
class Received {
 public:
  Received();

  void push(const std::uint8_t* bytes, std::size_t count);

  /// Returns the stream of the last scan.
  const ReceivedStream& stream() const { return *streams_.back(); }
  /// Returns all streams in order; all but the last are incomplete.
  const std::vector<std::unique_ptr<ReceivedStream>>& streams() const { return streams_; }

 private:
  std::vector<std::unique_ptr<ReceivedStream>> streams_;
};

}  // namespace discmc::simulator

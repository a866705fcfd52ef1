// Streams (.dmc), read through a decoder.
#ifndef DISCMC_MESH_STREAMS_STREAM_READER_HPP
#define DISCMC_MESH_STREAMS_STREAM_READER_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <vector>

#include <discmc/slices/surface_decoder.hpp>

#include "scan_filter.hpp"
#include "stream_census.hpp"

namespace discmc::meshing {

/// Which stream of a link, and which surface of it.
struct StreamChoice {
  std::uint8_t channel = any_channel;  ///< as of the SurfaceDecoder
  std::optional<std::uint16_t> scan;   ///< else the first

  bool is_any() const { return channel == any_channel && !scan; }
};

/// A stream of either kind.
class StreamReader {
 public:
  /// sink: it must not return "busy".
  explicit StreamReader(const Sink& sink, const StreamChoice& choice = {});
  /// As of the Decoder.
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    decoder_.set_packet_passthrough(sink);
  }
  /// Any number of bytes; a sink gets what they complete. Throws std::runtime_error when the
  /// stream's version is unknown, or when it claims more lost rows than can be skipped in some
  /// seconds. Limit: not after that.
  void push(const std::uint8_t* bytes, std::size_t count);
  /// Ends the stream: no bytes follow. Throws as push().
  void finish();
  /// All of a stream. progress: called now and then with the bytes read so far. Throws as push().
  void read(std::istream& in, const std::function<void(std::uint64_t)>& progress = {});

  const StreamHeader& header() const { return decoder_.header(); }
  const StreamReport& report() const { return decoder_.report(); }
  /// The voxels of the scan. Along z: the slices in the trailer, otherwise the planned ones,
  /// otherwise as many as any scan has.
  std::array<std::uint32_t, 3> dims() const;
  /// The channel that was read.
  std::uint8_t channel() const {
    return choice_.channel == any_channel ? header().channel : choice_.channel;
  }
  /// The headers of all streams of the link.
  const std::vector<StreamHeader>& headers() const { return census_.headers(); }

 private:
  void decode(const std::uint8_t* bytes, std::size_t count);
  void require_ok() const;
  Status give_memory();
  Status go_on_skipping();

  StreamChoice choice_;
  std::optional<ScanFilter> filter_;
  StreamCensus census_;
  SurfaceDecoder decoder_{};
  std::unique_ptr<std::uint8_t[]> memory_;  // for a stream of slices
  Status status_ = Status::ok;
  std::uint64_t skipped_ = 0;  // how much work the lost rows were so far
};

}  // namespace discmc::meshing

#endif

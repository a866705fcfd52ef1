// Reads streams (.dmc) through a decoder.
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

/// The choice of a stream on a link, and of its surface.
struct StreamChoice {
  std::uint8_t channel = any_channel;  ///< as for SurfaceDecoder
  std::optional<std::uint16_t> scan;   ///< default: the first

  bool is_any() const { return channel == any_channel && !scan; }
};

/// Reads a stream of either kind.
class StreamReader {
 public:
  /// sink: must not return "busy".
  explicit StreamReader(const Sink& sink, const StreamChoice& choice = {});
  /// As Decoder::set_packet_passthrough().
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    decoder_.set_packet_passthrough(sink);
  }
  /// Decodes any number of bytes; the sink receives the events that they complete. Throws
  /// std::runtime_error if the stream's version is unknown, or if it claims too many lost rows to
  /// skip in some seconds. Limit: not after an exception.
  void push(const std::uint8_t* bytes, std::size_t count);
  /// Ends the stream. Throws like push().
  void finish();
  /// Reads a whole stream. progress: called regularly with the number of bytes read. Throws like
  /// push().
  void read(std::istream& in, const std::function<void(std::uint64_t)>& progress = {});

  const StreamHeader& header() const { return decoder_.header(); }
  const StreamReport& report() const { return decoder_.report(); }
  /// Returns the extents of the scan in voxels. Along z: the slices in the trailer, else the
  /// planned ones, else the maximum.
  std::array<std::uint32_t, 3> dims() const;
  /// Returns the channel that is read.
  std::uint8_t channel() const {
    return choice_.channel == any_channel ? header().channel : choice_.channel;
  }
  /// Returns the headers of all streams on the link.
  const std::vector<StreamHeader>& headers() const { return census_.headers(); }

 private:
  void decode(const std::uint8_t* bytes, std::size_t count);
  void require_ok() const;
  Status set_memory();
  Status skip_lost_rows();

  StreamChoice choice_;
  std::optional<ScanFilter> filter_;
  StreamCensus census_;
  SurfaceDecoder decoder_{};
  std::unique_ptr<std::uint8_t[]> memory_;  // for a stream of slices
  Status status_ = Status::ok;
  std::uint64_t skipped_ = 0;  // work for lost rows so far
};

}  // namespace discmc::meshing

#endif

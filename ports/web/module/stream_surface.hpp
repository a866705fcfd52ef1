// The surface of a stream (.dmc), whatever of it arrived.
#ifndef DISCMC_WEB_STREAM_SURFACE_HPP
#define DISCMC_WEB_STREAM_SURFACE_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/surface_decoder.hpp>

#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::web {

/// Of a stream of regions or of slices; of a link with several, the first.
class StreamSurface {
 public:
  StreamSurface();
  StreamSurface(const StreamSurface&) = delete;
  StreamSurface& operator=(const StreamSurface&) = delete;

  /// Throws std::runtime_error where the version of the stream is not known, or it claims to be of
  /// rows without end.
  void push(const std::uint8_t* bytes, std::size_t count);
  /// Limit: the last call.
  void finish();

  const StreamHeader& header() const { return decoder_.header(); }
  /// Regions that came in pieces of which some did not are among the lost ones.
  StreamReport report() const;
  const std::vector<host::Polygon>& polygons() const { return builder_.surface().polygons; }

 private:
  void give_memory();
  void count_skipped();

  host::SurfaceBuilder builder_;
  host::GrowingJoiner joiner_;
  SurfaceDecoder decoder_;
  std::vector<std::uint8_t> memory_;  // for a stream of slices
  std::uint64_t skipped_ = 0;         // how much work the lost rows were so far
};

}  // namespace discmc::web

#endif

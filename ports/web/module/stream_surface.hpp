// The surface of a stream (.dmc), whatever of it arrived.
#ifndef DISCMC_WEB_STREAM_SURFACE_HPP
#define DISCMC_WEB_STREAM_SURFACE_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "streams/stream_file.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::web {

/// Of a stream of either kind and of any version; of a link with several, one surface.
class StreamSurface {
 public:
  explicit StreamSurface(const host::StreamChoice& choice);
  StreamSurface(const StreamSurface&) = delete;
  StreamSurface& operator=(const StreamSurface&) = delete;

  /// Throws as StreamReader::push().
  void push(const std::uint8_t* bytes, std::size_t count) { reader_.push(bytes, count); }
  /// Limit: the last call. Throws as StreamReader::finish().
  void finish();

  const host::StreamReader& reader() const { return reader_; }
  /// Regions that came in pieces of which some did not are among the lost ones.
  StreamReport report() const;
  const std::vector<host::Polygon>& polygons() const { return builder_.surface().polygons; }

 private:
  host::SurfaceBuilder builder_;
  host::GrowingJoiner joiner_;
  host::StreamReader reader_;
};

}  // namespace discmc::web

#endif

#include "stream_surface.hpp"

#include <stdexcept>

#include "require.hpp"

namespace discmc::web {

StreamSurface::StreamSurface() : joiner_(sink_to(builder_)) {
  host::require(decoder_.start({}, sink_to(joiner_)));
}

void StreamSurface::push(const std::uint8_t* bytes, std::size_t count) {
  constexpr std::uint64_t most_skips = 1024;  // some seconds
  do {
    const Decoded decoded = decoder_.push(bytes, count);
    bytes += decoded.bytes;
    count -= decoded.bytes;
    if (decoded.status == Status::too_little_memory && memory_.empty())
      give_memory();
    else if (decoded.status == Status::wrong_version)
      throw std::runtime_error("the stream is of a version that this page does not know");
    else if (decoded.status != Status::more)
      host::require(decoded.status);
    else if (++skips_ > most_skips)
      throw std::runtime_error("the stream claims that millions of rows were lost");
    else if (count == 0)
      continue;
  } while (count > 0);
}

void StreamSurface::finish() {
  while (decoder_.finish() == Status::more) {
  }
  joiner_.finish();
}

StreamReport StreamSurface::report() const {
  StreamReport report = decoder_.report();
  report.lost_pieces += builder_.incomplete_regions();
  return report;
}

void StreamSurface::give_memory() {
  const StreamHeader& header = decoder_.header();
  constexpr std::uint64_t for_chains = std::uint64_t{64} << 20;  // what has no room is joined
  memory_.resize(
      minimum_surface_bytes({header.width, header.height, header.border}, header.surfaces()) +
      for_chains);
  host::require(decoder_.give_memory({memory_.data(), memory_.size()}));
}

}  // namespace discmc::web

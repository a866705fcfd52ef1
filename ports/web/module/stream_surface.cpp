#include "stream_surface.hpp"

#include <stdexcept>

#include "require.hpp"

namespace discmc::web {

StreamSurface::StreamSurface() : joiner_(sink_to(builder_)) {
  host::require(decoder_.start({}, sink_to(joiner_)));
}

void StreamSurface::push(const std::uint8_t* bytes, std::size_t count) {
  Status status = Status::more;
  while (status != Status::ok || count > 0) {
    const Decoded decoded = decoder_.push(bytes, count);
    bytes += decoded.bytes;
    count -= decoded.bytes;
    status = decoded.status;
    if (status == Status::too_little_memory && memory_.empty())
      give_memory();
    else if (status == Status::wrong_version)
      throw std::runtime_error("the stream is of a version that this page does not know");
    else if (status == Status::more)
      count_skipped();
    else
      host::require(status);
  }
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

// The sink takes everything: there are lost rows to be skipped.
void StreamSurface::count_skipped() {
  constexpr std::uint64_t most = std::uint64_t{1} << 34;  // some seconds
  skipped_ += SurfaceDecoder::most_skipped_rows * (decoder_.header().width + std::uint64_t{1000});
  if (skipped_ > most)
    throw std::runtime_error("it claims that more rows were lost than a scanner has");
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

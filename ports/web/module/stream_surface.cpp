#include "stream_surface.hpp"

namespace discmc::web {

StreamSurface::StreamSurface(const host::StreamChoice& choice)
    : joiner_(sink_to(builder_)), reader_(sink_to(joiner_), choice) {}

void StreamSurface::finish() {
  reader_.finish();
  joiner_.finish();
}

StreamReport StreamSurface::report() const {
  StreamReport report = reader_.report();
  report.lost_pieces += builder_.incomplete_regions();
  return report;
}

}  // namespace discmc::web

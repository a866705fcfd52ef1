// Prints a stream of regions or slices as text, one line per region: its normal, then each ring,
// the outer one first. A ring has its start and its runs. A run is a direction in the region's
// plane and a length. Coordinates are in half-steps: voxel (i, j, k) is at (2i, 2j, 2k).
//
//   firmware | print_regions
//   ( 0 -1 -1)  from (42 36 9): 3x1 0x2 1x1 2x2
//   fragment of ( 1  0  0)  from (41 36 12) by 7: 0x4 1x2
//
// A loose fragment is a part of a ring that was sent early for lack of memory. This one continues
// the fragment that ends at its start with a run of direction 7.
#include <cinttypes>
#include <cstdio>
#include <discmc/receiver.hpp>
#include <vector>

using namespace discmc;

namespace {

class Printer {
 public:
  SinkResult accept(const Event& event) {
    switch (event.kind) {
      case Event::Kind::region:
        print_normal(event.incidence);
        break;
      case Event::Kind::fragment:
        std::printf("fragment of ");
        print_normal(event.incidence);
        print_start(event.start);
        std::printf(" by %d:", event.incoming_direction);
        break;
      case Event::Kind::ring:
        print_start(event.start);
        std::printf(":");
        break;
      case Event::Kind::run:
        std::printf(" %dx%" PRIu32, event.run.direction(), event.run.length());
        break;
      case Event::Kind::region_end:
        ++regions_;
        std::printf("\n");
        break;
      case Event::Kind::fragment_end:
        ++fragments_;
        std::printf("\n");
        break;
      case Event::Kind::lost:
        std::printf(" ... lost\n");
        break;
      case Event::Kind::start:
      case Event::Kind::skipped:
      case Event::Kind::layer:
      case Event::Kind::application:
      case Event::Kind::fractions:
      case Event::Kind::finish:
        break;
    }
    return SinkResult::accepted;
  }

  // The report counts these only for a stream of regions.
  uint64_t regions() const { return regions_; }
  uint64_t fragments() const { return fragments_; }

 private:
  static void print_normal(Incidence incidence) {
    const Vertex n = incidence_normal(incidence);
    std::printf("(%2d %2d %2d)", n.x, n.y, n.z);
  }
  static void print_start(const Vertex& start) {
    std::printf("  from (%" PRId32 " %" PRId32 " %" PRId32 ")", start.x, start.y, start.z);
  }

  uint64_t regions_ = 0;
  uint64_t fragments_ = 0;
};

// Status::suspended: more lost rows are to be skipped.
Status push_all(Receiver& receiver, const uint8_t* bytes, size_t count) {
  Decoded decoded{Status::suspended, 0};
  for (size_t taken = 0; decoded.status == Status::suspended; taken += decoded.bytes)
    decoded = receiver.push(bytes + taken, count - taken);
  return decoded.status;
}

}  // namespace

int main() {
  Printer printer;
  std::vector<uint8_t> memory(16 << 20);  // to extract the surface of slices
  Receiver receiver;
  Status status = receiver.start({memory.data(), memory.size()}, make_sink(printer));
  uint8_t bytes[4096];
  size_t count = 0;
  while (status == Status::ok && (count = std::fread(bytes, 1, sizeof(bytes), stdin)) > 0)
    status = push_all(receiver, bytes, count);
  if (status == Status::ok || status == Status::finished)  // finished: the first scan is over
    while ((status = receiver.finish()) == Status::suspended) continue;
  const StreamReport& report = receiver.report();
  std::fprintf(stderr,
               "%" PRIu64 " regions, %" PRIu64 " loose fragments in %" PRIu64 " bytes, %s\n",
               printer.regions(), printer.fragments(), report.bytes,
               status != Status::ok   ? to_string(status)
               : report.is_complete() ? "complete"
                                      : "not complete");
  return status == Status::ok && report.is_complete() ? 0 : 1;
}

// Prints a stream as text, one line a region: its normal, then for each ring (the outer one first)
// where it starts and its runs, each as the direction in the region's plane and how often it is
// taken. Coordinates are in half-steps: voxel (i, j, k) is at (2i, 2j, 2k).
//
//   firmware | print_regions
//   ( 0 -1 -1)  from (42 36 9): 3x1 0x2 1x1 2x2
//   fragment 0 of ( 1  0  0): 0x4 1x2      a part of a ring, sent early: where #0 stands, it goes
#include <cinttypes>
#include <cstdio>
#include <discmc/decoder.hpp>

using namespace discmc;

namespace {

class Printer {
 public:
  Answer take(const Event& event) {
    switch (event.kind) {
      case Event::Kind::region:
        print_normal(event.incidence);
        break;
      case Event::Kind::fragment:
        std::printf("fragment %" PRIu32 " of ", event.number);
        print_normal(event.incidence);
        std::printf(":");
        break;
      case Event::Kind::ring:
        std::printf("  from (%" PRId32 " %" PRId32 " %" PRId32 "):", event.start.x, event.start.y,
                    event.start.z);
        break;
      case Event::Kind::run:
        print_run(event.run);
        break;
      case Event::Kind::region_end:
      case Event::Kind::fragment_end:
        std::printf("\n");
        break;
      case Event::Kind::lost:
        std::printf(" ... lost\n");
        break;
      case Event::Kind::skipped:
      case Event::Kind::layer:
      case Event::Kind::finish:
        break;
    }
    return Answer::taken;
  }

 private:
  static void print_normal(Incidence incidence) {
    const Vertex n = normal(incidence);
    std::printf("(%2d %2d %2d)", n.x, n.y, n.z);
  }
  static void print_run(Run run) {
    if (run.is_fragment())
      std::printf(" #%" PRIu32, run.fragment_number());
    else
      std::printf(" %dx%" PRIu32, run.direction(), run.length());
  }
};

}  // namespace

int main() {
  Printer printer;
  Decoder decoder;
  Status status = decoder.start(sink_to(printer));
  uint8_t bytes[4096];
  size_t count = 0;
  while (status == Status::ok && (count = std::fread(bytes, 1, sizeof(bytes), stdin)) > 0)
    status = decoder.push(bytes, count).status;
  if (status == Status::ok) status = decoder.finish();
  const StreamReport& report = decoder.report();
  std::fprintf(stderr, "%" PRIu64 " regions in %" PRIu64 " bytes, %s\n", report.regions,
               report.bytes, report.is_complete() ? "complete" : "not complete");
  return status == Status::ok && report.is_complete() ? 0 : 1;
}

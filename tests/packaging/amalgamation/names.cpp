// A program of one file that includes the library between declarations of similar names, with the
// header included as in C.
struct Event {
  int at;
};
static int version(Event event) {
  return event.at;
}

extern "C" {
#include "discmc.h"
}
#include "discmc.cpp"

struct Run {
  uint32_t length;
};
static uint32_t c(Run run) {
  return run.length;
}
namespace wire {
static const int version = 7;
}

int main() {
  const discmc::Run run = discmc::Run::straight(3, 5);
  if (run.length() != c(Run{5})) return 1;
  if (version(Event{wire::version}) != 7) return 2;
  return discmc_packed_bytes(DISCMC_RAW10, 5) == discmc::packed_bytes(discmc::Packing::raw10, 5)
             ? 0
             : 3;
}

// Twice the work takes twice the time, for each part of the library. Basic blocks are counted for
// families of volumes at two sizes. Work is voxels, events, links and bytes. If work doubles,
// blocks may grow by a factor of 2.3; quadratic time would grow by 4.

#include <charconv>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <vector>

#include "proofs/doubling/families.hpp"
#include "proofs/doubling/pipelines.hpp"

using namespace discmc::doubling;

namespace {

constexpr const char* usage =
    R"(usage: doubling [FACTOR] [NAME]

Counts the basic blocks that each part of the library executes for families of volumes, at two
sizes, the second twice the first. Prints the parts whose blocks grow faster than their work.
FACTOR multiplies all sizes (default 1). NAME selects a family, and prints all its counts.

Exit status: 0, or 1 if a part grows by more than 2.3 per doubling of work, or 2 for an argument
that is not understood.
)";

constexpr double max_growth = 2.3;  // per doubling of the work
constexpr int sizes = 2;

constexpr const char* part_names[] = {"extractor", "encoder", "decoder", "joiner"};

// Returns the factor by which blocks grow if the work doubles.
double growth(const Effort& before, const Effort& after) {
  const auto ratio = [](uint64_t a, uint64_t b) {
    return std::log2(static_cast<double>(b) / static_cast<double>(a));
  };
  return std::exp2(ratio(before.blocks, after.blocks) / ratio(before.work, after.work));
}

// Whether a part does so little work that its fixed costs dominate.
bool is_small(const Effort& effort) {
  return effort.blocks < 1000000;
}

bool check(const Family& family, const Pipeline& pipeline, const Efforts (&efforts)[sizes],
           bool prints_all) {
  bool holds = true;
  for (int part = 0; part < tests; ++part) {
    const Effort &before = efforts[0].by_part[part], &after = efforts[1].by_part[part];
    if (before.work == 0) continue;
    const double grows = growth(before, after);
    const bool is_bad = grows > max_growth && !is_small(after);
    holds = holds && !is_bad;
    if (!is_bad && !prints_all) continue;
    std::printf("%-26s %-22s %-9s %5.2f%s", family.name, pipeline.name, part_names[part], grows,
                is_bad ? " !" : "  ");
    for (const Efforts& effort : efforts)
      std::printf(" %12" PRIu64 " / %-9" PRIu64, effort.by_part[part].blocks,
                  effort.by_part[part].work);
    std::printf("\n");
    std::fflush(stdout);
  }
  return holds;
}

bool check(const Family& family, uint32_t factor, bool prints_all) {
  bool holds = true;
  std::vector<discmc::reference::BitVolume> volumes;
  for (uint32_t size = 0; size < sizes; ++size)
    volumes.push_back(family.make(factor * family.size << size));
  for (size_t i = 0; i < pipeline_count; ++i) {
    Efforts efforts[sizes];
    for (uint32_t size = 0; size < sizes; ++size) efforts[size] = run(pipelines[i], volumes[size]);
    holds = check(family, pipelines[i], efforts, prints_all) && holds;
  }
  return holds;
}

}  // namespace

int main(int count, char** arguments) {
  uint32_t factor = 1;
  const char* name = nullptr;
  for (int i = 1; i < count; ++i) {
    const char* const end = arguments[i] + std::strlen(arguments[i]);
    const auto read = std::from_chars(arguments[i], end, factor);
    if (read.ec != std::errc() || read.ptr != end) name = arguments[i];
  }
  bool holds = true, was_found = false;
  for (size_t i = 0; i < family_count; ++i) {
    if (name != nullptr && std::strcmp(name, families[i].name) != 0) continue;
    was_found = true;
    holds = check(families[i], factor, name != nullptr) && holds;
  }
  if (!was_found) {
    std::fputs(usage, stderr);
    return 2;
  }
  return holds ? 0 : 1;
}

// same_regions A.dmc B.dmc: compares the polygons of two streams, ring for ring. Prints the first
// difference with exit code 1. The code is 2 if a stream cannot be read.
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "command/hand_made.hpp"
#include "oracle/region.hpp"
#include "streams/stream_reader.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"

namespace {

std::vector<discmc::reference::Region> regions_in(const std::string& path) {
  discmc::meshing::SurfaceBuilder builder;
  discmc::meshing::GrowingJoiner joiner(discmc::make_sink(builder));
  discmc::meshing::StreamReader reader(discmc::make_sink(joiner));
  std::ifstream file(path, std::ios::binary);
  reader.read(file);
  joiner.finish();
  if (!reader.report().is_complete() || builder.incomplete_regions() > 0)
    throw std::runtime_error(path + ": incomplete");
  return hand_made::regions_of(builder.surface());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fputs("usage: same_regions A.dmc B.dmc\n", stderr);
    return 2;
  }
  try {
    const std::string difference =
        discmc::reference::describe_difference(regions_in(argv[1]), regions_in(argv[2]));
    if (difference.empty()) return 0;
    std::fprintf(stderr, "%s and %s: %s\n", argv[1], argv[2], difference.c_str());
    return 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "same_regions: %s\n", error.what());
    return 2;
  }
}

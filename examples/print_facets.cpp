// Prints the lookup table: a configuration as a cell, its loops and its facets. Figures 3 and 4 of
// the paper (Montani, Scateni, Scopigno 1994) show them in the same way.
//
//   print_facets 61
//   print_facets 0x3D 0xC2
//   print_facets            all 256

#include <charconv>
#include <cstdio>
#include <discmc/geometry/facet_table.hpp>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

using namespace discmc;

namespace {

constexpr int exit_failure = 1;
constexpr int exit_usage = 2;

constexpr const char* usage =
    R"(usage: print_facets [CONFIGURATION...]

Prints the facets of each configuration of a cell: a number from 0 to 255, in decimal or as 0x00 to
0xFF; all 256 if none is given. Bit c says that corner c is on:

      6-------7
     /|      /|        z
    4-------5 |        | y
    | 2-----|-3        |/
    |/      |/         o-- x
    0-------1

Drawn cells show on corners as @ and off corners as o. Points are in half-steps: the cell spans 0 to
2, its centroid is (1 1 1). Loops and facets are listed counter-clockwise seen from the off side. An
incidence is a facet's normal reduced to signs; it points from on to off.

Exit status: 0, or 1 if the output could not be written, or 2 for an argument that is not understood.
)";

constexpr const char* cell_picture =
    "      6-------7\n"
    "     /|      /|\n"
    "    4-------5 |\n"
    "    | 2-----|-3\n"
    "    |/      |/\n"
    "    0-------1\n";

std::string drawn_cell(Configuration configuration) {
  std::string picture = cell_picture;
  for (char& c : picture)
    if (c >= '0' && c <= '7') c = (configuration >> (c - '0') & 1) != 0 ? '@' : 'o';
  return picture;
}

void print_points(const CellPoint* points, int count) {
  for (int i = 0; i < count; ++i) {
    const Vertex p = position(points[i]);
    std::printf(" (%d %d %d)", p.x, p.y, p.z);
  }
  std::printf("\n");
}

void print_loops(Configuration configuration) {
  const Loops loops = detail::derive::loops(configuration);
  for (int i = 0; i < loops.count; ++i) {
    const Loop& loop = loops.loop[i];
    std::printf("  loop of %d            ", loop.count);
    print_points(loop.point, loop.count);
  }
}

void print_facet(Facet facet) {
  const Vertex n = incidence_normal(incidence_of(facet));
  const FacetRing& ring = facet_rings.ring[facet];
  std::printf("  facet (%2d %2d %2d) shape %d", n.x, n.y, n.z, shape_of(facet));
  print_points(ring.point, ring.count);
}

void print_configuration(Configuration configuration) {
  const int first = facet_table.first[configuration];
  const int end = facet_table.first[configuration + 1];
  std::printf("configuration %d (0x%02X), facets: %d\n\n", configuration, configuration,
              end - first);
  std::printf("%s\n", drawn_cell(configuration).c_str());
  print_loops(configuration);
  for (int i = first; i < end; ++i) print_facet(facet_table.facet[i]);
  std::printf("\n");
}

// Returns the configuration, or -1 for text that is none.
int parsed_configuration(std::string_view text) {
  const bool hexadecimal = text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X";
  if (hexadecimal) text.remove_prefix(2);
  unsigned value = configurations;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value, hexadecimal ? 16 : 10);
  const bool is_whole = result.ec == std::errc() && result.ptr == end;
  return is_whole && value < configurations ? static_cast<int>(value) : -1;
}

// Standard output may be a full disk: report it.
int finished_writing() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
  std::fprintf(stderr, "print_facets: the output cannot be written; is the disk full?\n");
  return exit_failure;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  std::vector<Configuration> chosen;
  for (const std::string_view argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      std::printf("%s", usage);
      return finished_writing();
    }
    const int configuration = parsed_configuration(argument);
    if (configuration < 0) {
      std::fprintf(stderr,
                   "print_facets: \"%s\" is not a configuration; give a number from 0 to 255 or "
                   "0x00 to 0xFF, or --help\n",
                   std::string(argument).c_str());
      return exit_usage;
    }
    chosen.push_back(static_cast<Configuration>(configuration));
  }
  if (chosen.empty())
    for (int c = 0; c < configurations; ++c) chosen.push_back(static_cast<Configuration>(c));
  for (const Configuration configuration : chosen) print_configuration(configuration);
  return finished_writing();
}

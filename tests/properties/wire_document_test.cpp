// WIRE.md is true: its worked example is what the encoder makes, its tables are those of the code.
#include <doctest/doctest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "oracle/stream.hpp"

using namespace discmc;
using namespace discmc::test;

namespace {

std::vector<std::string> document() {
  std::ifstream file(std::string(DISCMC_SOURCE_DIR) + "/lib/WIRE.md");
  REQUIRE(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// The words of the block that begins with ```name, without the remarks behind semicolons.
std::vector<std::string> words_of_block(const std::string& name) {
  std::vector<std::string> words;
  bool is_inside = false;
  for (const std::string& line : document()) {
    if (is_inside && line == "```") break;
    if (is_inside) {
      std::istringstream text(line.substr(0, line.find(';')));
      for (std::string word; text >> word;) words.push_back(word);
    }
    is_inside = is_inside || line == "```" + name;
  }
  return words;
}

Bytes single_voxel() {
  const reference::BitVolume voxel = reference::from_bits({1, 1, 1}, 1);
  return encode(events_of(voxel), header_of(voxel));
}

// Notes every decision as the document writes it.
struct TracingCoder {
  RangeDecoder range;
  std::vector<std::string>* trace;
  bool bit(uint32_t context, bool) {
    const bool is_even = context == context::even;
    const Probability one = region_model[context];
    const bool bit = range.decode(one);
    trace->push_back(is_even ? "E" : std::to_string(context));
    trace->push_back(std::to_string(one));
    trace->push_back(bit ? "1" : "0");
    return bit;
  }
};

std::string text_of(const Vertex& vertex) {
  return std::to_string(vertex.x) + " " + std::to_string(vertex.y) + " " + std::to_string(vertex.z);
}

std::string row_of(Incidence incidence) {
  std::string row = "| " + std::to_string(incidence) + " | " + text_of(normal(incidence)) + " |";
  for (uint8_t d = 0; d < direction_count(incidence); ++d)
    row += (d == 0 ? " " : ", ") + text_of(direction_vector(incidence, d));
  return row + " |";
}

}  // namespace

TEST_CASE("the dump in WIRE.md is the stream of a single voxel") {
  Bytes dump;
  for (const std::string& word : words_of_block("hex"))
    dump.push_back(static_cast<uint8_t>(std::stoul(word, nullptr, 16)));
  CHECK(dump == single_voxel());
}

TEST_CASE("the decisions in WIRE.md are those of the first record and the first region") {
  const Packet packet = packet_of(frames_of(single_voxel())[1]);
  std::vector<std::string> trace;
  RegionModel<TracingCoder> model(
      TracingCoder{{packet.payload.data(), packet.payload.size()}, &trace});
  CHECK(model.record_kind(RecordKind::end) == RecordKind::layer);
  CHECK(model.layer(1) == 0);
  CHECK(model.record_kind(RecordKind::end) == RecordKind::region);
  CHECK(model.incidence(no_incidence) == 0);
  CHECK(model.ring_count(0) == 1);
  CHECK(model.start({0, 0, 0}, Chain::first) == Vertex{-1, 0, 0});
  CHECK_FALSE(model.parallelogram(false));
  CHECK(model.run_count(2) == 3);
  CHECK(model.direction(0) == 0);
  CHECK(model.length(1) == 1);
  CHECK(model.direction(0) == 2);
  CHECK(model.direction(0) == 4);
  CHECK(trace == words_of_block("decisions"));
}

TEST_CASE("the directions in WIRE.md are those of the code") {
  std::vector<std::string> rows, expected;
  bool is_inside = false;
  for (const std::string& line : document()) {
    if (is_inside && line.empty()) break;
    if (is_inside && line.rfind("| ", 0) == 0) rows.push_back(line);
    is_inside = is_inside || line.rfind("| code | normal |", 0) == 0;
  }
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence)
    if (incidence != no_incidence) expected.push_back(row_of(incidence));
  CHECK(rows == expected);
}

TEST_CASE("the contexts in WIRE.md are those of the code") {
  using namespace context;
  const std::pair<uint32_t, const char*> rows[] = {{region_follows, "region_follows"},
                                                   {fragment_follows, "fragment_follows"},
                                                   {other_kind, "other_kind"},
                                                   {component_zero, "component_zero"},
                                                   {component_sign, "component_sign"},
                                                   {one_ring, "one_ring"},
                                                   {start_z, "start_z"},
                                                   {start_y, "start_y"},
                                                   {start_x, "start_x"},
                                                   {start_hole, "start_hole"},
                                                   {fragment_z, "fragment_z"},
                                                   {fragment_y, "fragment_y"},
                                                   {fragment_x, "fragment_x"},
                                                   {first_direction, "first_direction"},
                                                   {parallelogram, "parallelogram"},
                                                   {context::run_count, "run_count"},
                                                   {next_turn, "next_turn"},
                                                   {run_length, "run_length"},
                                                   {is_backwards, "is_backwards"},
                                                   {fragment_direction, "fragment_direction"},
                                                   {z_is_odd, "z_is_odd"},
                                                   {y_is_odd, "y_is_odd"},
                                                   {fragment_turn, "fragment_turn"},
                                                   {context::is_last_link, "is_last_link"},
                                                   {fragment_length, "fragment_length"},
                                                   {item_kind, "item_kind"},
                                                   {part_kind, "part_kind"}};
  const std::vector<std::string> lines = document();
  size_t at = 0;
  for (const auto& [first, context_name] : rows) {
    const std::string row = "| " + std::to_string(first) + " | ";
    const std::string name = std::string(" | ") + context_name + " | ";
    while (at < lines.size() && lines[at].find(name) == std::string::npos) ++at;
    REQUIRE_MESSAGE(at < lines.size(), name);
    CHECK_MESSAGE(lines[at].rfind(row, 0) == 0, lines[at]);
  }
  CHECK(context::count == 903);
}

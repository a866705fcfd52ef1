// WIRE.md is correct: its worked example is the output of the encoder, and its tables are those of
// the code.
#include <fstream>
#include <iterator>
#include <sstream>

#include "oracle/slice_stream.hpp"
#include "oracle/symbol_contexts.hpp"
#include "test.hpp"

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

// Returns the words of the block that begins with ```name, without comments after semicolons.
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

// Records every symbol and all raw bits as the document writes them.
struct TracingCoder {
  static constexpr bool writes = false;
  detail::stream::SymbolReader reader;
  std::vector<std::string>* trace;

  uint32_t symbol(uint32_t context, uint32_t) {
    const uint32_t symbol = reader.symbol(context, 0);
    const uint8_t* const below = detail::stream::cumulative_frequencies + context + symbol;
    note(std::to_string(context), symbol, (below[1] - below[0]) & 0xFF);
    return symbol;
  }
  uint32_t raw_bits(uint32_t bits, uint32_t) {
    const uint32_t value = reader.raw_bits(bits, 0);
    note("R", value, bits);
    return value;
  }

 private:
  void note(const std::string& context, uint32_t value, int frequency) {
    trace->insert(trace->end(), {context, std::to_string(value), std::to_string(frequency)});
  }
  void note(const std::string& context, uint32_t value, uint32_t bits) {
    note(context, value, static_cast<int>(bits));
  }
};

Bytes bytes_of_block(const std::string& name) {
  Bytes bytes;
  for (const std::string& word : words_of_block(name))
    bytes.push_back(static_cast<uint8_t>(std::stoul(word, nullptr, 16)));
  return bytes;
}

// The volume of section 14.
reference::BitVolume two_slices() {
  reference::BitVolume volume({4, 3, 2});
  for (const auto& [y, z] : {std::pair{1U, 0U}, {2U, 0U}, {1U, 1U}})
    for (const uint32_t x : {1U, 2U}) volume.on[volume.index(x, y, z)] = 1;
  return volume;
}

// Records every decision of a row as the document writes it.
struct TracingRowReader {
  detail::slices::RowReader reader;
  const LearntProbability* first;
  std::vector<std::string>* trace;

  bool code_bit(LearntProbability& probability, bool) {
    const uint32_t one = probability.of_one();
    const bool bit = reader.code_bit(probability, false);
    note(std::to_string(&probability - first), one, bit);
    return bit;
  }
  uint32_t raw_bits(uint32_t bits, uint32_t) {
    const uint32_t value = reader.raw_bits(bits, 0);
    while (bits > 0) note("R", 128, (value >> --bits & 1) != 0);
    return value;
  }

 private:
  void note(const std::string& context, uint32_t one, bool bit) {
    trace->push_back(context);
    trace->push_back(std::to_string(one));
    trace->push_back(bit ? "1" : "0");
  }
};

std::string text_of(const Vertex& vertex) {
  return std::to_string(vertex.x) + " " + std::to_string(vertex.y) + " " + std::to_string(vertex.z);
}

std::string row_of(Incidence incidence) {
  std::string row =
      "| " + std::to_string(incidence) + " | " + text_of(incidence_normal(incidence)) + " |";
  for (uint8_t d = 0; d < direction_count(incidence); ++d)
    row += (d == 0 ? " " : ", ") + text_of(direction_vector(incidence, d));
  return row + " |";
}

}  // namespace

TEST_CASE("the dump in WIRE.md equals the stream of a single voxel") {
  CHECK(bytes_of_block("hex") == single_voxel());
}

TEST_CASE("the symbols in WIRE.md equal the symbols of the first record and the first region") {
  const Packet packet = packet_of(frames_of(single_voxel())[1]);
  std::vector<std::string> trace;
  detail::stream::RecordModel<TracingCoder> model(
      {{RangeDecoder(packet.payload.data(), packet.payload.size())}, &trace});
  CHECK(model.record_kind(detail::stream::RecordKind::end) == detail::stream::RecordKind::layer);
  CHECK(model.layer(1) == 0);
  CHECK(model.record_kind(detail::stream::RecordKind::end) == detail::stream::RecordKind::region);
  CHECK(model.start({0, 0, 0}) == Vertex{-1, 0, 0});
  CHECK(model.incidence(no_incidence) == 0);
  CHECK(model.corners(0) == 8);
  CHECK(model.ring_direction(9) == 1);
  CHECK(model.length(detail::stream::contexts::lengths, 0, 9) == 1);
  CHECK(trace == words_of_block("symbols"));
}

TEST_CASE("the dump of slices in WIRE.md equals the stream of its volume after the header") {
  const std::vector<Bytes> frames = frames_of(encode_slices(two_slices()));
  REQUIRE(frames.size() == 3);
  CHECK(bytes_of_block("slices") == joined({frames[1], frames[2]}));
  Packet header = packet_of(frames_of(bytes_of_block("hex"))[0]);
  header.payload[4] = 4;   // width
  header.payload[6] = 3;   // height
  header.payload[8] = 2;   // depth
  header.payload[28] = 2;  // flags
  CHECK(frame_of(header) == frames[0]);
}

TEST_CASE("the decisions of slices in WIRE.md match their volume and decode to its voxels") {
  const reference::BitVolume volume = two_slices();
  const Packet packet = packet_of(frames_of(encode_slices(volume))[1]);
  Bytes memory(SliceDecoder::minimum_bytes({4, 3}));
  Arena arena(memory_of(memory));
  detail::slices::CodedSurfaces surfaces;
  surfaces.start(arena, header_of(volume), detail::slices::rows_kept(3, false));
  surfaces.clear();
  surfaces.begin_key_slice();
  std::vector<std::string> trace;
  const RangeDecoder code(packet.payload.data() + detail::wire::key_slice_head,
                          packet.payload.size() - detail::wire::key_slice_head);
  TracingRowReader reader{{code}, &surfaces.note(), &trace};
  Bytes on;
  for (uint32_t row = 0; row < 6; ++row) {
    CHECK_FALSE(reader.code_bit(surfaces.note(), false));
    if (row == 3) surfaces.begin_following_slice();
    detail::slices::RowCode voxels;
    surfaces.begin_row(voxels, 0, 4);
    while (!voxels.is_done()) REQUIRE(voxels.step(reader, surfaces[0].model));
    uint8_t bits = 0;
    surfaces.rows().write_bits(&bits);
    for (uint32_t x = 0; x < 4; ++x) on.push_back(bits >> x & 1);
    surfaces.next_row();
  }
  CHECK(reader.code_bit(surfaces.note(), false));
  CHECK(reader.raw_bits(detail::slices::note_bits, 0) == 0);
  CHECK(on == volume.on);
  CHECK(trace == words_of_block("slice-decisions"));
}

TEST_CASE("the directions in WIRE.md equal the directions in the code") {
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

TEST_CASE("the contexts in WIRE.md equal the contexts in the code") {
  std::map<std::string, std::vector<reference::SymbolContexts>> contexts;
  for (const reference::SymbolContexts& of : reference::symbol_contexts())
    contexts[of.name].push_back(of);
  std::vector<std::string> lines = document();
  const auto begin = std::find(lines.begin(), lines.end(), "## 8 Contexts");
  lines = {begin, std::find(begin, lines.end(), "## 9 Records")};
  for (const auto& [name, of_classes] : contexts) {
    const std::string cell = " | " + name + " | ";
    const auto line = std::find_if(lines.begin(), lines.end(), [&](const std::string& text) {
      return text.find(cell) != std::string::npos;
    });
    REQUIRE_MESSAGE(line != lines.end(), cell);
    std::string first = "| ";
    for (const reference::SymbolContexts& of : of_classes)
      first += std::to_string(of.first) + " | ";
    CHECK_MESSAGE(line->rfind(first, 0) == 0, *line);
    if (of_classes.size() > 1) continue;
    const std::string sizes =
        std::to_string(of_classes[0].count) + " | " + std::to_string(of_classes[0].symbols);
    CHECK_MESSAGE(line->find(first + sizes + cell) == 0, *line);
  }
  CHECK(contexts.size() == 11 + 6);
  CHECK(std::size(detail::stream::cumulative_frequencies) == 556);
}

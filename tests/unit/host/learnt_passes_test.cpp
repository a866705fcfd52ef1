// Passes that are remembered are those that are worked out, in memory of any size.
#include <discmc/host/learnt_passes.hpp>

#include <doctest/doctest.h>

#include <discmc/trace/derived_passes.hpp>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "oracle/volume.hpp"

using namespace discmc;
using namespace discmc::reference;
using trace::CornerPass;
using trace::LearntPasses;

namespace {

// Nine rows: the middle one is swept.
class Rows {
 public:
  // volume: three rows in each of three slices.
  explicit Rows(const BitVolume& volume)
      : width_(volume.width), words_(trace::row_words(width_)), bits_(size_t{9} * words_) {
    for (uint32_t row = 0; row < 9; ++row)
      for (uint32_t word = 0; word < words_; ++word)
        for (uint32_t bit = 0; bit < 32; ++bit) {
          const uint32_t x = trace::column_of(word, bit);
          if (x < width_ && volume.on[size_t{row} * width_ + x] != 0)
            bits_[size_t{row} * words_ + word] |= uint32_t{1} << bit;
        }
  }
  // absent_rows: of the four rows of cells around, a bit each.
  trace::SweptRow swept(uint32_t absent_rows = 0, bool has_open_ends = false) const {
    trace::SweptRow row{};
    for (uint32_t i = 0; i < 9; ++i) row.around.row[i / 3][i % 3] = &bits_[size_t{i} * words_];
    row.words = words_;
    row.width = width_;
    row.y = 7;
    row.z = 5;
    row.absent_rows = absent_rows;
    row.has_open_ends = has_open_ends;
    row.set_absent_quadrants();
    return row;
  }

 private:
  uint32_t width_;
  uint32_t words_;
  std::vector<uint32_t> bits_;
};

// Corner passes as they come, each with where its corner is, its ports, and of what kind it is; and
// the parts of cells, facets and triangles.
struct Found {
  std::vector<std::vector<uint64_t>> passes;
  std::vector<uint32_t> counts;

  void add(const trace::SweepCounts& parts) {
    counts.resize(sizeof parts / sizeof counts[0]);
    std::memcpy(counts.data(), &parts, sizeof parts);
  }
};
bool operator==(const Found& a, const Found& b) {
  return a.passes == b.passes && a.counts == b.counts;
}

std::vector<uint64_t> described(uint64_t at, const CornerPass& pass) {
  return {at + pass.corner, pass.in, pass.out, pass.if_straight == -1, pass.joins};
}

Found derived_passes(const trace::SweptRow& row) {
  Found found;
  trace::DerivedPasses passes;
  trace::SweepCounts counts;
  passes.clear();
  while (passes.find(row, counts))
    for (; passes.has_next(); passes.advance()) {
      const Vertex at = passes.vertex();
      const int axis = (at.x & 1) != 0 ? 0 : (at.y & 1) != 0 ? 1 : 2;
      const Vertex voxel{at.x & ~1, at.y & ~1, at.z & ~1};
      CornerPass made[CornerPass::max_of_pass] = {};
      const uint32_t count = trace::corner_passes(passes.pass(), axis, made);
      for (uint32_t i = 0; i < count; ++i)
        found.passes.push_back(described(trace::CornerCode::position(voxel), made[i]));
    }
  found.add(counts);
  return found;
}

Found learnt_passes(LearntPasses& passes, const trace::SweptRow& row) {
  Found found;
  trace::SweepCounts counts;
  if (passes.begin_row(row))
    while (passes.find(row, counts)) {
      CHECK(passes.edges() > 0);
      CHECK(passes.edges() <= LearntPasses::max_edges);
      for (const trace::FoundPass at : passes)
        found.passes.push_back(described(at, passes.numbered()[at]));
    }
  found.add(counts);
  return found;
}

void check_like_derived(LearntPasses& passes, const trace::SweptRow& row) {
  const Found expected = derived_passes(row);
  CHECK(learnt_passes(passes, row) == expected);
  CHECK(learnt_passes(passes, row) == expected);
}

// Rows of noise and of stripes, and such of which most words are alike.
std::vector<Rows> rows_of(uint32_t width) {
  std::vector<Rows> all;
  const Size size{width, 3, 3};
  for (const uint32_t density : {5U, 60U, 128U, 240U})
    all.emplace_back(random(size, density, width + density));
  all.emplace_back(checkerboard(size));
  BitVolume stripes(size);
  for (size_t i = 0; i < stripes.voxels(); ++i) stripes.on[i] = i % width % 2;
  all.emplace_back(stripes);
  for (const Vertex& middle : {Vertex{0, 1, 1}, Vertex{0, 2, 1}, Vertex{0, 1, 2}}) {
    const auto last = static_cast<int32_t>(width) - 1;
    all.emplace_back(box(size, middle, {last, middle.y, middle.z}));
    all.emplace_back(box(size, {last, middle.y, middle.z}, {last, middle.y, middle.z}));
    all.emplace_back(box(size, {last / 2, middle.y, middle.z}, {last / 2, middle.y, middle.z}));
  }
  return all;
}

}  // namespace

TEST_CASE("in rows of any width the passes are those that are worked out") {
  std::vector<uint8_t> memory(20000);
  const auto passes = std::make_unique<LearntPasses>();
  for (const uint32_t width : {1U, 2U, 28U, 29U, 30U, 31U, 58U, 59U, 60U, 61U, 89U, 90U, 200U})
    for (const Rows& rows : rows_of(width)) {
      CAPTURE(width);
      passes->learn_in({memory.data(), memory.size()});
      check_like_derived(*passes, rows.swept());
    }
}

TEST_CASE("they are wherever rows of cells or the cells at the ends take no part") {
  std::vector<uint8_t> memory(20000);
  const auto passes = std::make_unique<LearntPasses>();
  passes->learn_in({memory.data(), memory.size()});
  for (const uint32_t width : {2U, 40U})
    for (const Rows& rows :
         {Rows(random({width, 3, 3}, 128, 5)), Rows(checkerboard({width, 3, 3}))})
      for (uint32_t absent = 0; absent < 16; ++absent)
        for (const bool has_open_ends : {false, true}) {
          CAPTURE(absent);
          check_like_derived(*passes, rows.swept(absent, has_open_ends));
        }
}

TEST_CASE("they are with memory of any size, wherever it lies, again and again") {
  const Rows noise(random({40, 3, 3}, 80, 5)), crowd(checkerboard({40, 3, 3}));
  std::vector<uint8_t> memory(2000);
  for (size_t bytes = 0; bytes < memory.size(); bytes += 117) {
    const auto passes = std::make_unique<LearntPasses>();
    passes->learn_in({memory.data() + bytes % 8, bytes - bytes % 8});
    for (const Rows* rows : {&noise, &crowd, &noise}) check_like_derived(*passes, rows->swept());
  }
}

namespace {

size_t max_at_a_vertex(const trace::SweptRow& row) {
  size_t most = 0;
  trace::DerivedPasses passes;
  trace::SweepCounts counts;
  passes.clear();
  while (passes.find(row, counts)) {
    size_t here = 0;
    CornerPass made[CornerPass::max_of_pass] = {};
    const Vertex at = passes.vertex();
    const int axis = (at.x & 1) != 0 ? 0 : (at.y & 1) != 0 ? 1 : 2;
    for (; passes.has_next(); passes.advance())
      here += trace::corner_passes(passes.pass(), axis, made);
    most = std::max(most, here);
  }
  return most;
}

// Whether nothing of a row that has come by is worked out again: takes the counts, which are the
// second word of four, out of the memory, and counts once more. There is so much memory that no two
// neighbourhoods of the rows below ask for the same.
bool is_remembered(const trace::SweptRow& row) {
  std::vector<uint32_t> memory(4 << 16);
  const auto passes = std::make_unique<LearntPasses>();
  passes->learn_in({memory.data(), memory.size() * sizeof memory[0]});
  const Found found = learnt_passes(*passes, row);
  for (size_t i = 1; i < memory.size(); i += 4) memory[i] = 0;
  const Found again = learnt_passes(*passes, row);
  REQUIRE(again.passes == found.passes);
  REQUIRE(found.counts[0] > 0);
  return again.counts == std::vector<uint32_t>{0, 0, 0};
}

}  // namespace

TEST_CASE("up to seven passes are not worked out again where their neighbourhood comes by again") {
  const Rows seven(random({60, 3, 3}, 128, 30)), eight(random({60, 3, 3}, 128, 2));
  REQUIRE(max_at_a_vertex(seven.swept()) == 7);
  CHECK(is_remembered(seven.swept()));
  REQUIRE(max_at_a_vertex(eight.swept()) == 8);
  CHECK_FALSE(is_remembered(eight.swept()));
}

TEST_CASE("nor are those between open ends, but those at the ends are") {
  BitVolume volume = random({60, 3, 3}, 100, 2);
  const Rows all(volume);
  for (int64_t row = 0; row < 9; ++row)
    for (const int64_t x : {0, 1, 58, 59}) volume.on[volume.index(x, row % 3, row / 3)] = 0;
  const Rows between(volume);
  REQUIRE(max_at_a_vertex(all.swept()) <= 7);
  CHECK(is_remembered(all.swept()));
  CHECK_FALSE(is_remembered(all.swept(0, true)));
  CHECK(is_remembered(between.swept(0, true)));
}

TEST_CASE("where no edge crosses nothing is found, and a row with one edge begins") {
  const auto passes = std::make_unique<LearntPasses>();
  for (const uint32_t width : {1U, 28U, 31U, 58U, 62U, 200U}) {
    CAPTURE(width);
    const auto last = static_cast<int32_t>(width) - 1;
    const auto line = [&](const Vertex& from, const Vertex& to) {
      return Rows(box({width, 3, 3}, from, to));
    };
    CHECK(learnt_passes(*passes, Rows(BitVolume({width, 3, 3})).swept()).passes.empty());
    // Edges go to the rows behind and above, to no others.
    CHECK(learnt_passes(*passes, line({0, 0, 0}, {last, 2, 0}).swept()).passes.empty());
    for (const Vertex& at : {Vertex{last, 1, 1}, Vertex{last, 2, 1}, Vertex{last, 1, 2}}) {
      const Rows rows = line(at, at);
      CHECK(passes->begin_row(rows.swept()));
      CHECK(learnt_passes(*passes, rows.swept()).passes.size() > 0);
    }
  }
}

TEST_CASE("passes are remembered in the largest power of two of entries that has room") {
  constexpr size_t entry = 16;
  constexpr size_t lost = Arena::alignment - 1;
  const auto cleared = [](size_t bytes) {
    std::vector<uint8_t> memory(bytes + entry, 0xA5);
    const auto passes = std::make_unique<LearntPasses>();
    passes->learn_in({memory.data(), bytes});
    return static_cast<size_t>(std::count(memory.begin(), memory.end(), 0)) / sizeof(uint32_t);
  };
  CHECK(cleared(0) == 0);
  for (size_t entries = 2; entries < 2000; entries *= 2) {
    CHECK(cleared(entries * entry + lost - 1) == entries / 2 * (entries > 2 ? 1 : 0));
    CHECK(cleared(entries * entry + lost) == entries);
    CHECK(cleared(2 * entries * entry + lost - 1) == entries);
  }
  CHECK(cleared((entry << 21) + lost) == 1U << 20);
}

TEST_CASE("nothing is written behind the memory, nor into too little of it") {
  const Rows rows(random({40, 3, 3}, 80, 5));
  for (size_t bytes = 0; bytes < 64; ++bytes) {
    std::vector<uint8_t> memory(bytes + 32, 0xA5);
    const auto passes = std::make_unique<LearntPasses>();
    passes->learn_in({memory.data(), bytes});
    (void)learnt_passes(*passes, rows.swept());
    const auto is_written = [](uint8_t byte) { return byte != 0xA5; };
    const auto end = memory.begin() + static_cast<std::ptrdiff_t>(bytes);
    CHECK(std::any_of(memory.begin(), end, is_written) == (bytes >= 2 * 16 + 3));
    CHECK(std::none_of(end, memory.end(), is_written));
  }
}

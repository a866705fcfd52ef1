#include <discmc/compiler.hpp>
#include <discmc/host/learnt_passes.hpp>

namespace discmc::trace {

namespace {

constexpr uint32_t axis_shift = 27;
constexpr uint32_t all_voxels = (1U << axis_shift) - 1;

// From a voxel to the next one.
constexpr uint64_t next_voxel = CornerCode::vector({2, 0, 0});

uint64_t two_words(const uint32_t* words) {
  return words[0] | uint64_t{words[1]} << 32;
}

// Passes by words in which no edge crosses, two at a time.
DISCMC_ALWAYS_INLINE uint32_t pass_by(const SweptRow& row, uint32_t word) {
  constexpr uint64_t own = own_columns * 0x100000001;
  const uint32_t* const here = row.around.row[1][1];
  const uint32_t* const behind = row.around.row[1][2];
  const uint32_t* const above = row.around.row[2][1];
  for (; word + 2 <= row.words; word += 2) {
    const uint64_t on = two_words(here + word);
    const uint64_t along_y = on ^ two_words(behind + word);
    const uint64_t along_z = on ^ two_words(above + word);
    if ((((on ^ on >> 1) | along_y | along_z) & own) != 0) break;
  }
  return word;
}

// The nine rows around a row, in one word: and from them the 27 voxels around each voxel of it.
class BlockWord {
 public:
  BlockWord(const RowBlock& rows, uint32_t word) {
    const auto& row = rows.row;
    const auto pair = [word](const uint32_t* lower, const uint32_t* upper) {
      return lower[word] | uint64_t{upper[word]} << 32;
    };
    rows_0_1_ = pair(row[0][0], row[0][1]);
    rows_2_3_ = pair(row[0][2], row[1][0]);
    rows_4_5_ = pair(row[1][1], row[1][2]);
    rows_6_7_ = pair(row[2][0], row[2][1]);
    row_8_ = row[2][2][word];
  }
  // Bit 3 * place(row) + i: the voxel at x - 1 + i of a row.
  uint32_t voxels(uint32_t bit) const {
    const auto lines = [shift = bit - 1](uint64_t rows) { return rows >> shift & 0x700000007; };
    uint64_t block = lines(row_8_);
    block = lines(rows_6_7_) + 8 * block;
    block = lines(rows_4_5_) + 8 * block;
    block = lines(rows_2_3_) + 8 * block;
    block = lines(rows_0_1_) + 8 * block;
    return static_cast<uint32_t>(block | block >> 17);
  }
  // row: 3 * layer + row, as in RowBlock.
  static constexpr int place(int row) { return row / 2 + (row % 2 != 0 ? 5 : 0); }

 private:
  uint64_t rows_0_1_, rows_2_3_, rows_4_5_, rows_6_7_, row_8_;
};

// The voxels of the four cells around the edge along an axis from the voxel in the middle.
constexpr uint32_t voxels_around_edge(int axis) {
  uint32_t voxels = 0;
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) {
        const int along = axis == 0 ? x : axis == 1 ? y : z;
        if (along > 0) voxels |= 1U << (3 * BlockWord::place(3 * z + y) + x);
      }
  return voxels;
}

}  // namespace

void LearntPasses::learn_in(Memory memory) {
  // What it takes to align the entries is lost.
  constexpr size_t lost = Arena::alignment - 1;
  const size_t entries = memory.bytes < lost ? 0 : (memory.bytes - lost) / sizeof(Learnt);
  uint32_t bits = 1;
  while (bits < max_entry_bits && size_t{2} << bits <= entries) ++bits;
  further_bits_ = bits - 1;
  learnt_ = Arena(memory).take<Learnt>(uint32_t{1} << bits);
  for (uint32_t i = 0; learnt_ != nullptr && i < uint32_t{1} << bits; ++i) learnt_[i].known = 0;
}

bool LearntPasses::begin_row(const SweptRow& row) {
  word_ = pass_by(row, 0);
  return word_ < row.words;
}

bool LearntPasses::find(const SweptRow& row, SweepCounts& counts) {
  first_word_ = word_;
  while (word_ < row.words) {
    edges_ = collect(row);
    look_up(row, counts);
    if (count_ > 0) return true;
  }
  return false;
}

// Collects the edges of as many words as there is room for, and returns how many there are.
uint32_t LearntPasses::collect(const SweptRow& row) {
  constexpr uint32_t around[] = {voxels_around_edge(0), voxels_around_edge(1),
                                 voxels_around_edge(2)};
  const uint64_t origin = CornerCode::position({-2, 2 * row.y, 2 * row.z});
  Edge* edge = edge_;
  uint32_t word = word_;
  for (; word < row.words && edge <= edge_ + (max_edges - 3 * columns_per_word);
       word = pass_by(row, word + 1)) {
    Crossings crossings;
    if (!crossings.find(row, word)) continue;
    const BlockWord block(row.around, word);
    for (uint32_t left = crossings.voxels(); left != 0; left &= left - 1) {
      const uint32_t bit = trailing_zeros(left);
      const uint64_t voxel = origin + next_voxel * (column_of(word, bit) + 1);
      const uint32_t voxels = block.voxels(bit);
      DISCMC_UNROLL(3)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        edge->voxel = voxel;
        edge->key = (voxels & around[axis]) | axis << axis_shift;
        edge += crossings.of[axis] >> bit & 1;
      }
    }
  }
  word_ = word;
  mark_incomplete(row, edge);
  return static_cast<uint32_t>(edge - edge_);
}

// Marks the edges around which cells may be absent: nothing is learnt of these.
void LearntPasses::mark_incomplete(const SweptRow& row, Edge* end) {
  const bool has_all_rows = row.absent_quadrants[0] == 0;
  if (has_all_rows && !row.has_open_ends) return;
  const uint64_t first = CornerCode::position({0, 2 * row.y, 2 * row.z});
  const uint64_t last = first + next_voxel * (row.width - 1);
  Edge* edge = edge_;
  for (; edge != end && (edge->voxel == first || !has_all_rows); ++edge) edge->key |= all_voxels;
  for (; edge != end && (end - 1)->voxel == last; --end) (end - 1)->key |= all_voxels;
}

// Finds the passes of the edges.
void LearntPasses::look_up(const SweptRow& row, SweepCounts& counts) {
  static constexpr Learnt nothing[2] = {};
  const Learnt* const learnt = learnt_ != nullptr ? learnt_ : nothing;
  const uint32_t shift = 31 - further_bits_;
  FoundPass* found = pass_;
  SweepCounts sum = counts;
  for (const Edge *edge = edge_, *const end = edge_ + edges_; edge != end; ++edge) {
    const uint64_t voxel = edge->voxel;
    // Multiplication spreads neighbouring keys: see Holes.
    const uint32_t place = edge->key * 0x9E3779B1U >> shift;
    const Learnt& entry = learnt[place];
    const uint32_t count = entry.known ^ edge->key << count_bits;
    if (count > max_learnt) {
      const Derived derived = derive(row, *edge, place, found);
      found += derived.count;
      sum.add(derived.parts);
      continue;
    }
    // Four, whatever the count.
    DISCMC_UNROLL(4)
    for (uint32_t k = 0; k < passes_an_entry; ++k) found[k] = voxel + entry.pass[k];
    sum.add(entry.parts);
    if (count > passes_an_entry)
      for (uint32_t k = 0; k < passes_an_entry; ++k)
        found[passes_an_entry + k] = voxel + learnt[place ^ 1].pass[k];
    found += count;
  }
  count_ = static_cast<uint32_t>(found - pass_);
  counts = sum;
}

// Works out the passes at a vertex, and learns them where all cells take part.
DISCMC_NOINLINE LearntPasses::Derived LearntPasses::derive(const SweptRow& row, const Edge& edge,
                                                           uint32_t place, FoundPass* found) {
  const auto axis = static_cast<int>(edge.key >> axis_shift);
  // The voxel may be the one before the row.
  const Vertex next = CornerCode(edge.voxel + next_voxel).vertex();
  const auto column = static_cast<uint32_t>(next.x) / 2;
  PassList list;
  derive_passes({row.around, column / columns_per_word, column % columns_per_word + 1, axis},
                row.absent_at(axis, column - 1), list);
  uint32_t count = 0;
  for (uint32_t i = 0; i < list.count; ++i) {
    const NumberedPasses::Numbers numbers = numbered_.of(list.pass[i], axis);
    for (uint32_t k = 0; k < numbers.count; ++k) found[count++] = edge.voxel + numbers.first + k;
  }
  const bool is_complete = (edge.key & all_voxels) != all_voxels;
  if (learnt_ != nullptr && is_complete && count <= max_learnt) {
    // What does not fit into an entry stands in the one beside it, which then is of no other use.
    Learnt& entry = learnt_[place];
    Learnt& beside = learnt_[place ^ 1];
    if (count > passes_an_entry || beside.count() > passes_an_entry) beside.known = 0;
    entry.known = edge.key << count_bits | count;
    entry.parts = list.parts;
    for (uint32_t i = 0; i < count; ++i)
      (i < passes_an_entry ? entry : beside).pass[i % passes_an_entry] =
          static_cast<uint16_t>(found[i]);
  }
  return {count, list.parts};
}

}  // namespace discmc::trace

#include <discmc/compiler.hpp>
#include <discmc/trace/learnt_passes.hpp>

namespace discmc::trace {

namespace {

constexpr uint32_t axis_shift = 27;

// The nine rows around a row, in one word: and from them the 27 voxels around each voxel of it.
class BlockWord {
 public:
  BlockWord(const RowBlock& rows, uint32_t word) {
    const auto& row = rows.row;
    const auto pair = [word](const uint32_t* lower, const uint32_t* upper) {
      return lower[word] | uint64_t{upper[word]} << 32;
    };
    pair_[0] = pair(row[0][0], row[0][1]);
    pair_[1] = pair(row[0][2], row[1][0]);
    pair_[2] = pair(row[1][1], row[1][2]);
    pair_[3] = pair(row[2][0], row[2][1]);
    last_ = row[2][2][word];
  }
  // Bit 3 * place(row) + i: the voxel at x - 1 + i of a row.
  uint32_t voxels(uint32_t bit) const {
    const uint32_t shift = bit - 1;
    const auto lines = [shift](uint64_t pair) { return pair >> shift & 0x700000007; };
    const uint64_t block = lines(pair_[0]) | lines(pair_[1]) << 3 | lines(pair_[2]) << 6 |
                           lines(pair_[3]) << 9 | lines(last_) << 12;
    return static_cast<uint32_t>(block | block >> 17);
  }
  // row: 3 * layer + row, as in RowBlock.
  static constexpr int place(int row) { return row / 2 + (row % 2 != 0 ? 5 : 0); }

 private:
  uint64_t pair_[4];  // rows 0 and 1, 2 and 3, ...
  uint64_t last_;
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
  // What it may take to align the two arrays.
  constexpr size_t lost = 2 * (Arena::alignment - 1);
  constexpr size_t entry = sizeof(Known) + sizeof(Learnt);
  const size_t entries = memory.bytes < lost ? 0 : (memory.bytes - lost) / entry;
  uint32_t bits = 1;
  while (bits < most_entry_bits && size_t{2} << bits <= entries) ++bits;
  shift_ = 32 - bits;
  Arena arena(memory);
  known_ = arena.take<Known>(uint32_t{1} << bits);
  learnt_ = arena.take<Learnt>(uint32_t{1} << bits);
  if (arena.is_exhausted()) known_ = nullptr;
  for (uint32_t i = 0; known_ != nullptr && i < uint32_t{1} << bits; ++i) known_[i] = {0, 0};
}

bool LearntPasses::find(const SweptRow& row, SweepCounts& counts) {
  do {
    const uint32_t edges = collect(row);
    if (edges == 0) {
      clear();
      return false;
    }
    look_up(edges, row, counts);
  } while (passes_ == 0);
  return true;
}

// Collects the edges of as many words as there is room for, and returns how many there are.
uint32_t LearntPasses::collect(const SweptRow& row) {
  constexpr uint32_t around[] = {voxels_around_edge(0), voxels_around_edge(1),
                                 voxels_around_edge(2)};
  uint32_t count = 0;
  Crossings crossings;
  for (; word_ < row.words && count <= most_edges - 3 * columns_per_word; ++word_) {
    if (!crossings.find(row, word_)) continue;
    const BlockWord block(row.rows, word_);
    for (uint32_t left = crossings.voxels(); left != 0; left &= left - 1) {
      const uint32_t bit = trailing_zeros(left);
      const uint32_t voxels = block.voxels(bit);
      const uint32_t x = column_of(word_, bit);
#pragma GCC unroll 3
      for (uint32_t axis = 0; axis < 3; ++axis) {
        edge_[count] = {(voxels & around[axis]) | axis << axis_shift, x};
        count += crossings.of[axis] >> bit & 1;
      }
    }
  }
  return count;
}

// Replaces the edges by their passes.
void LearntPasses::look_up(uint32_t edges, const SweptRow& row, SweepCounts& counts) {
  const Known* const known = known_;
  const Learnt* const learnt = learnt_;
  const uint32_t shift = shift_;
  const Vertex first[] = {row.vertex(0, 0), row.vertex(1, 0), row.vertex(2, 0)};
  SweepCounts sum = counts;
  uint32_t passes = 0;
  uint32_t vertices = 0;
  for (uint32_t i = 0; i < edges; ++i) {
    const Edge edge = edge_[i];
    const auto axis = static_cast<int>(edge.key >> axis_shift);
    const uint32_t absent = row.absent(axis, edge.x);
    // Multiplication spreads neighbouring keys: see Holes.
    const uint32_t place = edge.key * 0x9E3779B1U >> shift;
    vertex_[vertices] = first[axis];
    vertex_[vertices].x += 2 * static_cast<int32_t>(edge.x);
    uint32_t count =
        known != nullptr ? known[place].code ^ edge.key << count_bits : most_learnt + 1;
    if (absent == 0 && count <= most_learnt) {
      // Four, whatever the count.
      __builtin_memcpy(pass_ + passes, learnt + place, sizeof(Learnt));
      __builtin_memset(of_ + passes, static_cast<uint8_t>(vertices), most_learnt);
      sum.add(known[place].parts);
    } else {
      PassList list;
      derive(row, edge, absent, list);
      count = list.count;
      for (uint32_t k = 0; k < count; ++k) pass_[passes + k] = list.pass[k];
      __builtin_memset(of_ + passes, static_cast<uint8_t>(vertices), count);
      sum.add(list.parts);
      if (known != nullptr && absent == 0) learn(edge.key, place, list);
    }
    passes += count;
    vertices += count != 0 ? 1 : 0;
  }
  passes_ = passes;
  next_ = 0;
  if (row.work == RowWork::take_passes) counts = sum;
}

void LearntPasses::derive(const SweptRow& row, const Edge& edge, uint32_t absent,
                          PassList& passes) const {
  const uint32_t column = edge.x + 1;
  derive_passes({row.rows, column / columns_per_word, column % columns_per_word + 1,
                 static_cast<int>(edge.key >> axis_shift)},
                absent, passes);
}

void LearntPasses::learn(uint32_t key, uint32_t place, const PassList& passes) {
  if (passes.count > most_learnt) return;
  known_[place] = {key << count_bits | passes.count, passes.parts};
  for (uint32_t i = 0; i < passes.count; ++i) learnt_[place].pass[i] = passes.pass[i];
}

}  // namespace discmc::trace

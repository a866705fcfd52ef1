#include "edges.hpp"
#include <discmc/base/checks.hpp>
#include <discmc/base/compiler.hpp>
#include "corner_code.hpp"

namespace discmc::host {

namespace {

using detail::trace::columns_per_word;
using detail::trace::SweptRow;

// The vector from a voxel to the next one.
constexpr uint64_t next_voxel = CornerCode::vector({2, 0, 0});

uint64_t two_words(const uint32_t* words) {
  return words[0] | uint64_t{words[1]} << 32;
}

// The columns of two words, without the copies of neighbouring columns.
constexpr uint64_t own_columns = detail::trace::own_columns * uint64_t{0x100000001};

// One word of each of the nine rows around a row.
class BlockWord {
 public:
  BlockWord(const detail::trace::RowBlock& rows, uint32_t word) {
    const auto& row = rows.row;
    const auto pair = [word](const uint32_t* lower, const uint32_t* upper) {
      return lower[word] | uint64_t{upper[word]} << 32;
    };
    rows_0_5_ = pair(row[0][0], row[1][2]);
    rows_1_6_ = pair(row[0][1], row[2][0]);
    rows_2_7_ = pair(row[0][2], row[2][1]);
    rows_3_8_ = pair(row[1][0], row[2][2]);
    row_4_ = row[1][1][word];
  }
  // Returns RayTable::lines of all voxels around one.
  uint64_t lines(uint32_t bit) const {
    const auto columns = [shift = bit - 1](uint64_t rows) { return rows >> shift & 0x700000007; };
    uint64_t block = columns(row_4_);
    block = columns(rows_3_8_) + 8 * block;
    block = columns(rows_2_7_) + 8 * block;
    block = columns(rows_1_6_) + 8 * block;
    block = columns(rows_0_5_) + 8 * block;
    // Bit x + 3 y + 9 z: the voxel at x - 1, y - 1, z - 1 from here.
    const auto voxels = static_cast<uint32_t>(block | block >> 17);
    return ray_table.lines[0][voxels & 511] | ray_table.lines[1][voxels >> 9 & 511] |
           ray_table.lines[2][voxels >> 18];
  }

 private:
  uint64_t rows_0_5_, rows_1_6_, rows_2_7_, rows_3_8_, row_4_;
};

}  // namespace

void Edges::clear() {
  word_ = 0;
  count_ = 0;
}

bool Edges::collect(const SweptRow& row, int32_t row_z) {
  const uint32_t* const here = row.around.row[1][1];
  const uint32_t* const behind = row.around.row[1][2];
  const uint32_t* const above = row.around.row[2][1];
  const uint32_t words = row.words;
  const uint32_t last = (row.is_own() ? max_edges : max_at_seam) - max_in_word;
  const uint64_t origin = CornerCode::position({-4, 2 * row.y, 2 * row_z});
  const uint64_t mask_y = row.has_y ? own_columns : 0, mask_z = row.has_z ? own_columns : 0;
  for (uint32_t word = word_;; ++word) {
    uint64_t x, y, z;
    // Most words have no crossing edge: skips two words at a time.
    for (; word + 2 <= words; word += 2) {
      const uint64_t on = two_words(here + word);
      x = (on ^ on >> 1) & own_columns;
      y = (on ^ two_words(behind + word)) & mask_y;
      z = (on ^ two_words(above + word)) & mask_z;
      if ((x | y | z) != 0) break;
    }
    if (word + 2 > words) {
      if (word == words) break;
      const uint64_t on = here[word];
      x = (on ^ on >> 1) & detail::trace::own_columns;
      y = (on ^ behind[word]) & mask_y;
      z = (on ^ above[word]) & mask_z;
      if ((x | y | z) == 0) break;
    } else if (static_cast<uint32_t>(x | y | z) == 0) {
      x >>= 32, y >>= 32, z >>= 32;
      ++word;
    }
    if (count_ > last) {
      word_ = word;
      return true;
    }
    collect_word(row, origin, word, x, y, z);
  }
  word_ = 0;
  return false;
}

// Collects the crossing edges of a word. x, y, z: a bit per voxel with an edge along that axis.
inline void Edges::collect_word(const SweptRow& row, uint64_t row_origin, uint32_t word, uint64_t x,
                                uint64_t y, uint64_t z) {
  constexpr uint32_t axis_bits = RayTable::axis_bits;
  const BlockWord block(row.around, word);
  const uint64_t origin = row_origin + next_voxel * (uint64_t{columns_per_word} * word);
  if (row.has_open_ends) x &= detail::trace::inner_columns(word, row.width);
  Edge* const first = edge_ + count_;
  Edge* edge = first;
  for (auto voxels = static_cast<uint32_t>(x | y | z); voxels != 0; voxels &= voxels - 1) {
    const uint32_t bit = trailing_zeros(voxels);
    const uint64_t voxel = origin + next_voxel * bit;
    const uint64_t lines = block.lines(bit);
    *edge = {voxel, static_cast<uint32_t>(lines), 0};
    edge += x >> bit & 1;
    *edge = {voxel, static_cast<uint32_t>(lines >> axis_bits), 1};
    edge += y >> bit & 1;
    *edge = {voxel, static_cast<uint32_t>(lines >> 2 * axis_bits), 2};
    edge += z >> bit & 1;
  }
  count_ = static_cast<uint32_t>(edge - edge_);
  DISCMC_LIMIT(count_ <= (row.is_own() ? max_edges : max_at_seam));
  const bool is_end = row.has_open_ends && (word == 0 || word + 1 == row.words);
  if (is_end || row.absent_rows != 0) mark_special(row, row_origin, first);
}

// Marks the edges from `first` on that have absent cells, and all edges of context slices.
DISCMC_NOINLINE void Edges::mark_special(const SweptRow& row, uint64_t row_origin, Edge* first) {
  for (Edge* edge = first; edge != edge_ + count_; ++edge) {
    // The position of bit 0 belongs to column -2.
    const auto x = static_cast<uint32_t>((edge->voxel - row_origin) / next_voxel) - 2;
    const uint32_t absent = row.absent_at(static_cast<int>(edge->axis), x);
    if (!row.is_own() || absent != 0)
      edge->axis |= (row.is_own() ? Edge::special : Edge::special | Edge::at_seam) |
                    absent << Edge::special_shift;
  }
}

}  // namespace discmc::host

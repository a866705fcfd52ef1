#include <discmc/compiler.hpp>
#include <discmc/host/corner_code.hpp>
#include <discmc/host/edges.hpp>

namespace discmc::host {

namespace {

using trace::columns_per_word;
using trace::Crossings;
using trace::SweptRow;

// From a voxel to the next one.
constexpr uint64_t next_voxel = CornerCode::vector({2, 0, 0});

uint64_t two_words(const uint32_t* words) {
  return words[0] | uint64_t{words[1]} << 32;
}

// Passes by words in which no edge crosses, two at a time.
DISCMC_ALWAYS_INLINE uint32_t pass_by(const SweptRow& row, uint32_t word) {
  constexpr uint64_t own = trace::own_columns * 0x100000001;
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

// A word of each of the nine rows around a row.
class BlockWord {
 public:
  BlockWord(const trace::RowBlock& rows, uint32_t word) {
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
  // RayTable::lines of all voxels around one.
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

bool Edges::collect(const SweptRow& row) {
  const uint64_t origin = CornerCode::position({-4, 2 * row.y, 2 * row.z});
  const Edge* const last = edge_ + (max_edges_of(row) - max_in_word);
  Edge* const first = edge_ + count_;
  Edge* edge = first;
  uint32_t word = word_;
  for (word = pass_by(row, word); word < row.words; word = pass_by(row, word + 1)) {
    Crossings crossings;
    if (!crossings.find(row, word)) continue;
    if (edge > last) break;
    const BlockWord block(row.around, word);
    const uint64_t start = origin + next_voxel * (columns_per_word * word);
    for (uint32_t left = crossings.voxels(); left != 0; left &= left - 1) {
      const uint32_t bit = trailing_zeros(left);
      const uint64_t voxel = start + next_voxel * bit;
      const uint64_t lines = block.lines(bit);
      DISCMC_UNROLL(3)
      for (uint32_t axis = 0; axis < 3; ++axis) {
        *edge = {voxel, static_cast<uint32_t>(lines >> axis * RayTable::axis_bits), axis};
        edge += crossings.of[axis] >> bit & 1;
      }
    }
  }
  word_ = word;
  mark_special(row, first, edge);
  count_ = static_cast<uint32_t>(edge - edge_);
  if (word < row.words) return true;
  word_ = 0;
  return false;
}

// Marks the edges around which cells are absent, and all of context slices.
void Edges::mark_special(const SweptRow& row, Edge* first, Edge* end) const {
  const uint64_t first_voxel = CornerCode::position({0, 2 * row.y, 2 * row.z});
  const uint64_t last_voxel = first_voxel + next_voxel * (row.width - 1);
  const auto mark = [&](Edge& edge) {
    const auto x = static_cast<uint32_t>((edge.voxel - first_voxel) / next_voxel);
    const uint32_t absent = row.absent_at(static_cast<int>(edge.axis), x);
    if (!row.is_own() || absent != 0)
      edge.axis |= (row.is_own() ? Edge::special : Edge::special | Edge::at_seam) |
                   absent << Edge::special_shift;
  };
  if (!row.is_own() || row.absent_rows != 0) {
    for (; first != end; ++first) mark(*first);
  } else if (row.has_open_ends) {
    for (; first != end && first->voxel == first_voxel; ++first) mark(*first);
    for (; first != end && (end - 1)->voxel == last_voxel; --end) mark(*(end - 1));
  }
}

}  // namespace discmc::host

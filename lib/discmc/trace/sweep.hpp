// The sweep: rows of bits in, vertex by vertex, passes to the fragments.
#ifndef DISCMC_TRACE_SWEEP_HPP
#define DISCMC_TRACE_SWEEP_HPP

#include <discmc/trace/bit_rows.hpp>
#include <discmc/trace/delivery.hpp>

namespace discmc::trace {

/// The lines around the three edges that begin at a voxel, from the 27 voxels around it.
class Neighbourhood {
 public:
  /// column: of the voxel within the words, 1 to 30.
  Neighbourhood(const RowBlock& rows, uint32_t word, uint32_t bit) {
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 3; ++j) row_[k][j] = rows.row[k][j][word] >> (bit - 1) & 7;
  }
  bool is_on() const { return (row_[1][1] & 2) != 0; }

  uint32_t around_x() const {
    constexpr int order[8][2] = {{1, 2}, {2, 2}, {2, 1}, {2, 0}, {1, 0}, {0, 0}, {0, 1}, {0, 2}};
    uint32_t lines = 0;
    for (int i = 0; i < 8; ++i) lines |= (row_[order[i][0]][order[i][1]] >> 1) << 2 * i;
    return lines;
  }
  uint32_t around_y() const {
    return pair(row_[2][1], row_[2][2], spread.first) | pair(row_[1][1], row_[1][2], spread.second) |
           pair(row_[0][1], row_[0][2], spread.third);
  }
  uint32_t around_z() const {
    return pair(row_[1][1], row_[2][1], spread.fourth) | pair(row_[1][2], row_[2][2], spread.fifth) |
           pair(row_[1][0], row_[2][0], spread.sixth);
  }

 private:
  struct Spread {
    uint16_t first[8], second[8], third[8], fourth[8], fifth[8], sixth[8];
  };
  // line: of the voxels to the left, in the middle and to the right; 8 for none.
  static constexpr void fill(uint16_t (&spread)[8], int left, int middle, int right) {
    const int line[3] = {left, middle, right};
    for (int bits = 0; bits < 8; ++bits)
      for (int i = 0; i < 3; ++i)
        if ((bits >> i & 1) != 0 && line[i] < 8)
          spread[bits] = static_cast<uint16_t>(spread[bits] | 1 << 2 * line[i]);
  }
  static constexpr Spread derive_spread() {
    Spread spread{};
    fill(spread.first, 7, 0, 1);
    fill(spread.second, 6, 8, 2);
    fill(spread.third, 5, 4, 3);
    fill(spread.fourth, 4, 8, 0);
    fill(spread.fifth, 3, 2, 1);
    fill(spread.sixth, 5, 6, 7);
    return spread;
  }
  static const Spread spread;
  static uint32_t pair(uint32_t low, uint32_t high, const uint16_t (&spread)[8]) {
    return spread[low] | uint32_t{spread[high]} << 1;
  }

  uint32_t row_[3][3];
};

inline constexpr Neighbourhood::Spread Neighbourhood::spread = Neighbourhood::derive_spread();

template <class Index, class Normal>
class Sweep {
 public:
  template <class Normals>
  bool sweep_row(const BitRows& rows, int32_t y, bool is_first, bool is_last, const Normals& normals,
                 const Sink& sink, Statistics& statistics) {
    const RowBlock block = rows.around(y);
    const int32_t z = static_cast<int32_t>(rows.slices()) - 1;
    (void)is_first; (void)is_last;
    for (; word_ < rows.words(); ++word_) {
      const uint32_t here = block.row[1][1][word_];
      const uint32_t cross_x = here ^ here >> 1;
      const uint32_t cross_y = here ^ block.row[1][2][word_];
      const uint32_t cross_z = here ^ block.row[2][1][word_];
      if (!is_begun_) {
        vertices_ = (cross_x | cross_y | cross_z) & 0x7FFFFFFE;
        is_begun_ = true;
        kind_ = 0; pass_ = 0;
      }
      for (; vertices_ != 0; vertices_ &= vertices_ - 1) {
        const uint32_t bit = static_cast<uint32_t>(__builtin_ctz(vertices_));
        const Neighbourhood around(block, word_, bit);
        const int32_t x = static_cast<int32_t>(word_ * columns_per_word + bit) - 2;
        for (; kind_ < 3; ++kind_, pass_ = 0) {
          const uint32_t cross = kind_ == 0 ? cross_x : kind_ == 1 ? cross_y : cross_z;
          if ((cross >> bit & 1) == 0) continue;
          const uint32_t lines = kind_ == 0 ? around.around_x() : kind_ == 1 ? around.around_y() : around.around_z();
          const Vertex vertex{2 * x + (kind_ == 0), 2 * y + (kind_ == 1), 2 * z + (kind_ == 2)};
          Passes passes({int(kind_), around.is_on(), lines}, 0);
          Pass pass;
          for (uint32_t i = 0; passes.next(pass); ++i) {
            if (i < pass_) continue;
            fragments_.take(pass, vertex, normals);
            ++pass_;
            if (!delivery_.settle(fragments_, sink, statistics)) return false;
          }
        }
        kind_ = 0;
      }
      is_begun_ = false;
    }
    word_ = 0;
    return true;
  }
  void clear() { fragments_.clear(); delivery_.clear(); word_ = 0; is_begun_ = false; }
  Fragments<Index, Normal> fragments_;
  Delivery<Index, Normal> delivery_;
  uint32_t word_ = 0, vertices_ = 0, kind_ = 0, pass_ = 0;
  bool is_begun_ = false;
};

}  // namespace discmc::trace

#endif

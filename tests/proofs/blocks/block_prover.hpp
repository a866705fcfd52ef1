// Sweeps every block of 3 x 3 x 3 voxels that begins with a given slice, and checks each.
//
// Rows are the digits of a number. Before each row the extractor, its memory, the sink and the
// reference are saved; the next value of the row begins from there. Every block is thus a whole
// scan, but blocks with the same first rows share their work.
#pragma once

#include <array>
#include <cstdint>
#include <discmc/extractor.hpp>
#include <stdexcept>
#include <vector>

#include "forest.hpp"
#include "region_check.hpp"

namespace discmc::prove {

constexpr uint32_t side = 3;  ///< voxels a row, rows a slice, slices
constexpr uint32_t rows = side * side;
constexpr uint32_t row_values = 1U << side;
constexpr uint32_t slice_values = 1U << side * side;  ///< and blocks have as many first slices

/// What blocks are checked with: made once, for all threads.
struct Tables {
  Border border;
  Lattice lattice;
  GroupTable groups;

  explicit Tables(Border of_border)
      : border(of_border),
        lattice(of_border),
        groups(static_cast<int32_t>(of_border == Border::closed ? side + 1 : side - 1),
               of_border == Border::closed ? -1 : 0) {}
};

/// A block whose surface is wrong, and how.
struct Disproved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class BlockProver {
 public:
  explicit BlockProver(const Tables& tables);
  BlockProver(const BlockProver&) = delete;
  BlockProver& operator=(const BlockProver&) = delete;

  /// Checks the blocks that begin with the slice, those of one in `share` second slices. Returns
  /// their number. Errors: throws Disproved.
  uint64_t prove(uint32_t slice, uint32_t share);

 private:
  // What the scan came to before a row.
  struct Saved {
    std::array<uint8_t, sizeof(Extractor16)> extractor;  // its bytes: it stays where it is
    std::vector<uint8_t> memory;
    RegionCheck::Sum sum;
    Forest::Mark forest;
  };

  void take_rows(uint32_t row);
  void save(Saved& saved) const;
  void put_back(const Saved& saved);
  void push_row(uint32_t row, uint32_t value);
  void add_cells(uint32_t row);
  void add_cell_row(int32_t y, int32_t z);
  void check_block();
  void check_reference() const;
  const char* flaw() const;
  uint32_t voxels(int32_t y, int32_t z) const;
  uint64_t block() const;

  const Tables& tables_;
  Forest forest_;
  RegionCheck check_;
  std::vector<uint8_t> memory_;
  Extractor16 extractor_;
  std::array<Saved, rows> saved_;
  std::array<uint8_t, rows> value_{};  // of the block's rows
  uint32_t share_ = 1;
  uint64_t proved_ = 0;
};

}  // namespace discmc::prove

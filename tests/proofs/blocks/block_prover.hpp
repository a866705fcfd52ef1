// Sweeps every block of 3 x 3 x 3 voxels that begins with a given slice, and checks each.
//
// Rows are the digits of a number. Before each row, the extractor, its memory, the sink and the
// reference are saved; the next value of the row starts from there. So every block is a whole scan,
// but blocks with the same first rows share their work.
#pragma once

#include <array>
#include <cstdint>
#include <discmc/extractor.hpp>
#include <stdexcept>
#include <vector>

#include "forest.hpp"
#include "region_check.hpp"

namespace discmc::prove {

constexpr uint32_t side = 3;  ///< voxels per row, rows per slice, slices
constexpr uint32_t rows = side * side;
constexpr uint32_t row_values = 1U << side;
constexpr uint32_t slice_values = 1U << side * side;  ///< number of values of a slice

/// The tables with which all threads check blocks.
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

/// A block whose surface is wrong, and the fault.
struct Disproved : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class BlockProver {
 public:
  explicit BlockProver(const Tables& tables);
  BlockProver(const BlockProver&) = delete;
  BlockProver& operator=(const BlockProver&) = delete;

  /// Checks all blocks whose first slice is `slice`, and whose second slice is one in `share`.
  /// Returns their number. Errors: throws Disproved.
  uint64_t prove(uint32_t slice, uint32_t share);

 private:
  // The state of a scan before a row.
  struct Saved {
    std::array<uint8_t, sizeof(Extractor16)> extractor;  // its bytes; restored at the same address
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
  std::array<uint8_t, rows> value_{};  // of the rows of the block
  uint32_t share_ = 1;
  uint64_t proved_ = 0;
};

}  // namespace discmc::prove

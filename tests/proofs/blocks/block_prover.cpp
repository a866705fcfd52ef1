#include "block_prover.hpp"

#include <cstring>
#include <string>

#include "oracle/agreement.hpp"
#include "oracle/scan.hpp"

namespace discmc::prove {

using reference::require_ok;

namespace {

// Enough slots that no fragment is sent early.
constexpr Capacities capacities{512, 8};

// The maximum number of slots in use per block. A leaked slot would exceed it in some block.
constexpr uint32_t max_slots = 112;

// Compares the reference with the paper's Merge for one block in this many. The number is prime, so
// all values of all rows occur.
constexpr uint64_t sample = 4093;

}  // namespace

BlockProver::BlockProver(const Tables& tables)
    : tables_(tables), forest_(tables.groups), check_(tables.lattice) {
  const Limits limits{side, side, tables.border};
  memory_.resize(Extractor16::bytes_for(limits, capacities));
  require_ok(extractor_.start(limits, capacities, 1, memory_of(memory_), make_sink(check_)));
}

uint64_t BlockProver::prove(uint32_t slice, uint32_t share) {
  share_ = share;
  proved_ = 0;
  Saved& begin = saved_[0];
  save(begin);
  for (uint32_t row = 0; row < side; ++row) push_row(row, slice >> side * row & (row_values - 1));
  take_rows(side);
  put_back(begin);
  return proved_;
}

// Limit: the rows of the block before this one have been added.
void BlockProver::take_rows(uint32_t row) {
  if (row == 2 * side && block() % share_ != 0) return;
  if (row == rows) return check_block();
  Saved& saved = saved_[row];
  save(saved);
  for (uint32_t value = 0; value < row_values; ++value) {
    push_row(row, value);
    take_rows(row + 1);
    put_back(saved);
  }
  value_[row] = 0;
}

void BlockProver::save(Saved& saved) const {
  std::memcpy(saved.extractor.data(), &extractor_, sizeof extractor_);
  const auto end = static_cast<std::ptrdiff_t>(extractor_.bytes_used());
  saved.memory.assign(memory_.begin(), memory_.begin() + end);
  saved.sum = check_.sum();
  saved.forest = forest_.mark();
}

// All pointers stay valid, because every part is restored at its own address.
void BlockProver::put_back(const Saved& saved) {
  std::memcpy(static_cast<void*>(&extractor_), saved.extractor.data(), sizeof extractor_);
  std::copy(saved.memory.begin(), saved.memory.end(), memory_.begin());
  check_.go_back(saved.sum);
  forest_.go_back(saved.forest);
}

void BlockProver::push_row(uint32_t row, uint32_t value) {
  value_[row] = static_cast<uint8_t>(value);
  try {
    require_ok(extractor_.push_bits(&value_[row]).status);
  } catch (const std::runtime_error& error) {
    throw Disproved("a block that begins with " + std::to_string(block()) + ": " + error.what());
  }
  add_cells(row);
}

// Adds the rows of cells that this row of voxels completes.
void BlockProver::add_cells(uint32_t row) {
  const auto y = static_cast<int32_t>(row % side);
  const auto z = static_cast<int32_t>(row / side);
  const bool is_closed = tables_.border == Border::closed;
  const int32_t back = is_closed ? 0 : 1;  // the first row of an open volume completes no cells
  if (y >= back && z >= back) add_cell_row(y - back, z - back);
  if (is_closed && row % side == side - 1) add_cell_row(y + 1, z);
}

// Cells are numbered from 0, including those of the halo.
void BlockProver::add_cell_row(int32_t y, int32_t z) {
  const bool is_closed = tables_.border == Border::closed;
  const int32_t first = is_closed ? -1 : 0;
  const uint32_t around[] = {voxels(y + first, z + first), voxels(y + first + 1, z + first),
                             voxels(y + first, z + first + 1),
                             voxels(y + first + 1, z + first + 1)};
  for (int32_t x = 0; x < tables_.groups.side(); ++x) {
    uint32_t configuration = 0;
    for (int i = 0; i < 4; ++i)
      configuration |= ((is_closed ? around[i] << 1 : around[i]) >> x & 3) << 2 * i;
    forest_.add(x, y, z, static_cast<Configuration>(configuration));
  }
}

uint32_t BlockProver::voxels(int32_t y, int32_t z) const {
  constexpr auto end = static_cast<int32_t>(side);
  if (y < 0 || z < 0 || y >= end || z >= end) return 0;
  return value_[static_cast<size_t>(z * end + y)];
}

void BlockProver::check_block() {
  const bool is_closed = tables_.border == Border::closed;
  std::string what;
  try {
    require_ok(extractor_.finish());
    if (is_closed)
      for (int32_t y = 0; y < tables_.groups.side(); ++y) add_cell_row(y, side);
    if (flaw() != nullptr) what = flaw();
  } catch (const std::runtime_error& error) {
    what = error.what();
  }
  if (what.empty()) {
    if (block() % sample == 0) check_reference();
    ++proved_;
    return;
  }
  throw Disproved((is_closed ? "closed border, block " : "open border, block ") +
                  std::to_string(block()) + ": " + what);
}

// Returns the fault of the block's surface, or nullptr.
const char* BlockProver::flaw() const {
  const RegionCheck::Sum& sum = check_.sum();
  if (sum.unpaired != 0) return "an inner link that is used in one direction only";
  if (sum.fingerprint != forest_.fingerprint()) return "other regions than the facets make";
  if (sum.links != forest_.links()) return "a boundary with a slit";
  if (extractor_.peaks().slots > max_slots) return "a slot that is not given back";
  return nullptr;
}

// Compares the reference with the paper's Merge, a slow, independent implementation.
void BlockProver::check_reference() const {
  const bool is_closed = tables_.border == Border::closed;
  const reference::BitVolume volume = reference::from_bits({side, side, side}, block());
  const std::vector<reference::Region> merged = reference::merge(volume, is_closed);
  if (reference::fingerprint(merged) != forest_.fingerprint() ||
      reference::link_count(merged) != forest_.links())
    throw Disproved("block " + std::to_string(block()) + ": the references differ");
}

// Returns the block as a number: bit x + 3 y + 9 z is voxel (x, y, z).
uint64_t BlockProver::block() const {
  uint64_t bits = 0;
  for (uint32_t row = 0; row < rows; ++row) bits |= uint64_t{value_[row]} << side * row;
  return bits;
}

}  // namespace discmc::prove

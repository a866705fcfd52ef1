// A flash memory that checks its rules of use, and whose power can fail at any moment.
#pragma once

#include <algorithm>
#include <cstdint>
#include <discmc/checkpoint_store.hpp>
#include <random>
#include <vector>

namespace discmc::reference {

/// Programming sets bits from 1 to 0; the units of a block are programmed in order, each once.
/// Erasing the block sets its bits to 1. The first contents are arbitrary.
class SimulatedFlash {
 public:
  enum class Kind : uint8_t { flash, fram };

  explicit SimulatedFlash(const FlashGeometry& geometry, uint32_t seed = 1, Kind kind = Kind::flash)
      : bytes(size_t{geometry.block_bytes} * geometry.blocks),
        erasures(geometry.blocks),
        geometry_(geometry),
        kind_(kind),
        programmed_(geometry.blocks, geometry.units_per_block()),
        random_(seed) {
    for (uint8_t& byte : bytes) byte = any_byte();
  }

  FlashDevice device() {
    return {this, read, program, kind_ == Kind::fram ? nullptr : erase, sync, geometry_};
  }

  // ---- failures ----

  /// The power fails after a number of steps: bytes programmed, and quarters of a block erased. An
  /// interrupted step leaves random bits.
  void cut_after(uint64_t left) { steps_left_ = left; }
  void power_on() { cut_after(UINT64_MAX); }
  bool is_off() const { return steps_left_ == 0; }
  /// Makes the call of this number, from 0 on, fail without an effect: a read, programming, erasure
  /// or sync.
  void fail_call(uint64_t number) { failing_call_ = calls + number; }
  /// From now on, bits of this unit stay 1.
  void wear_out(size_t unit) { worn_unit_ = unit; }

  // ---- counts ----

  std::vector<uint8_t> bytes;
  std::vector<uint32_t> erasures;  // per block
  uint64_t calls = 0;
  uint64_t units = 0;  // number programmed
  uint64_t steps = 0;
  bool has_broken_rules = false;

 private:
  static SimulatedFlash& of(void* context) { return *static_cast<SimulatedFlash*>(context); }

  static int read(void* context, uint32_t block, uint32_t offset, void* buffer, uint32_t count) {
    SimulatedFlash& flash = of(context);
    if (flash.fails() || !flash.holds(block, offset, count)) return -5;
    std::copy_n(flash.at(block, offset), count, static_cast<uint8_t*>(buffer));
    return 0;
  }
  static int program(void* context, uint32_t block, uint32_t offset, const void* buffer,
                     uint32_t count) {
    SimulatedFlash& flash = of(context);
    if (flash.fails() || !flash.holds(block, offset, count)) return -5;
    flash.program_unit(block, offset, static_cast<const uint8_t*>(buffer));
    return flash.is_off() ? -5 : 0;
  }
  static int erase(void* context, uint32_t block) {
    SimulatedFlash& flash = of(context);
    if (flash.fails() || !flash.holds(block, 0, flash.geometry_.program_bytes)) return -5;
    flash.erase_block(block);
    return flash.is_off() ? -5 : 0;
  }
  static int sync(void* context) { return of(context).fails() ? -5 : 0; }

  bool fails() { return calls++ == failing_call_ || is_off(); }

  bool holds(uint32_t block, uint32_t offset, uint32_t count) {
    const bool is_unit = block < geometry_.blocks && offset < geometry_.block_bytes &&
                         offset % geometry_.program_bytes == 0 && count == geometry_.program_bytes;
    if (!is_unit) has_broken_rules = true;
    return is_unit;
  }

  void program_unit(uint32_t block, uint32_t offset, const uint8_t* data) {
    uint8_t* const unit = at(block, offset);
    const uint32_t number = offset / geometry_.program_bytes;
    if (kind_ == Kind::fram)
      std::fill_n(unit, geometry_.program_bytes, uint8_t{0xFF});
    else if (number < programmed_[block])
      has_broken_rules = true;
    programmed_[block] = number + 1;
    ++units;
    for (uint32_t i = 0; i < geometry_.program_bytes; ++i) {
      const bool is_cut = !takes_step();
      const bool is_worn =
          static_cast<size_t>(unit - bytes.data()) / geometry_.program_bytes == worn_unit_;
      if (is_cut && i == 0 && any_byte() % 2 == 0) return;  // nothing has happened
      if (!is_worn) unit[i] &= is_cut ? static_cast<uint8_t>(data[i] | any_byte()) : data[i];
    }
  }

  // A partly erased block must be erased again before programming.
  void erase_block(uint32_t block) {
    const uint32_t quarter = (geometry_.block_bytes + 3) / 4;
    programmed_[block] = geometry_.units_per_block();
    ++erasures[block];
    for (uint32_t i = 0; i < geometry_.block_bytes; ++i) {
      if (i % quarter == 0) (void)takes_step();
      uint8_t& byte = *at(block, i);
      byte = is_off() ? static_cast<uint8_t>(byte | any_byte()) : 0xFF;
    }
    if (!is_off()) programmed_[block] = 0;
  }

  bool takes_step() {
    if (steps_left_ == UINT64_MAX) return ++steps != 0;
    if (steps_left_ > 0) --steps_left_;
    return steps_left_ > 0;
  }

  uint8_t* at(uint32_t block, uint32_t offset) {
    return bytes.data() + size_t{block} * geometry_.block_bytes + offset;
  }
  uint8_t any_byte() { return static_cast<uint8_t>(random_() >> 8); }

  FlashGeometry geometry_;
  Kind kind_;
  std::vector<uint32_t> programmed_;  // per block: the next unit that may be programmed
  std::minstd_rand random_;
  uint64_t steps_left_ = UINT64_MAX;
  uint64_t failing_call_ = UINT64_MAX;
  size_t worn_unit_ = SIZE_MAX;
};

}  // namespace discmc::reference

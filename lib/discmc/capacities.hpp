// The memory of a scan, as constant expressions.
//
//   // What exceeds minimum_bytes() becomes slots:
//   static uint8_t memory[Extractor16::minimum_bytes(limits) + 5 * 1024];
//
// The memory contains rows of bits, whose size follows from the limits, and slots for the
// boundaries that are not complete yet. Fewer slots make the stream longer; the surface is
// unchanged. docs/memory.md has figures.
#ifndef DISCMC_CAPACITIES_HPP
#define DISCMC_CAPACITIES_HPP

#include <discmc/base/arena.hpp>
#include <discmc/trace/intake.hpp>
#include <discmc/trace/sector_table.hpp>

namespace discmc {

/// Whether a type can be the index of slots.
template <class Index>
constexpr bool is_index = false;
template <>
inline constexpr bool is_index<uint16_t> = true;
template <>
inline constexpr bool is_index<uint32_t> = true;

/// The capacities of an extractor. A boundary that gets no slot is sent as loose fragments.
struct Capacities {
  /// Each slot holds the open end of a boundary, or up to three of its runs; a waiting hole needs
  /// two. A slot has 8 bytes with 16-bit indices, 14 with normals, and 16 with 32-bit indices.
  uint32_t slots;
  /// The most holes that wait for their outer ring at once, in the slots. They limit the work per
  /// region.
  uint32_t holes;
};

// ---- Internal constants.

namespace detail::sizing {

/// The number of lists that hold holes: a power of two, or none if holes are in a tree.
template <class Index>
constexpr uint32_t hole_lists = sizeof(Index) == 4 ? 0 : 16;

constexpr uint32_t lesser(uint32_t a, uint32_t b) {
  return a < b ? a : b;
}

/// Bytes of one slot.
template <class Index, class Intake>
constexpr uint32_t slot_bytes = sizeof(Index) == 4      ? 16
                                : Intake::holds_samples ? 14
                                                        : 8;

/// The most slots that an index can count.
template <class Index>
constexpr uint32_t max_slots = static_cast<Index>(~Index{0}) / 2 - 8;

/// The most slots that a cell can need: an end and a run for each link of the rings of its facets.
constexpr uint32_t slots_per_cell = 2 * 17;

}  // namespace detail::sizing

// ---- Capacities and memory.

/// The least capacities, which suffice for every volume.
constexpr Capacities minimum_capacities() {
  return {4, 0};
}

/// Capacities that suffice for every volume of this many slices: no loose fragment is sent. Real
/// volumes need far fewer. Results beyond uint32_t are clamped. Limit: valid limits.
constexpr Capacities worst_case_capacities(const Limits& limits, uint32_t slices) {
  // In 32 bits: no 64-bit division on small machines.
  const uint32_t cells = (limits.width + 1) * (limits.height + 1);
  const uint32_t max_cells = UINT32_MAX / detail::sizing::slots_per_cell;
  const uint32_t all = slices < max_cells / cells ? cells * (slices + 1) : max_cells;
  const uint32_t slots = all * detail::sizing::slots_per_cell;
  return {slots, slots};
}

// ---- Internal: the functions of the same names of extractors. Index: their index type. Intake:
// BitIntake, or GradientIntake<Sample>.

namespace detail::sizing {

template <class Index, class Intake = detail::trace::BitIntake>
constexpr uint64_t bytes_for(const Limits& limits, const Capacities& capacities) {
  static_assert(is_index<Index>, "an index must be uint16_t or uint32_t");
  return Intake::bytes_for(limits) +
         trace::bit_row_bytes(limits.width, trace::swept_rows(limits.height)) +
         Arena::bytes_of(trace::queue_count, 2 * sizeof(Index)) +
         Arena::bytes_of(hole_lists<Index>, sizeof(Index)) +
         Arena::bytes_of(capacities.slots, slot_bytes<Index, Intake>) + Arena::alignment - 1;
}

/// Whether an index of this width can count the slots.
template <class Index>
constexpr bool is_valid(const Capacities& capacities) {
  return capacities.slots >= minimum_capacities().slots && capacities.slots <= max_slots<Index>;
}

template <class Index, class Intake = detail::trace::BitIntake>
constexpr uint64_t minimum_bytes(const Limits& limits) {
  return bytes_for<Index, Intake>(limits, minimum_capacities());
}

template <class Index, class Intake = detail::trace::BitIntake>
constexpr Capacities default_capacities(const Limits& limits, uint64_t bytes) {
  const Capacities minimum = minimum_capacities();
  const uint64_t used = minimum_bytes<Index, Intake>(limits) + Arena::alignment;
  const uint64_t spare = bytes > used ? bytes - used : 0;
  // In 32 bits: small processors need no 64-bit division, and more than 4 GiB has no use.
  const uint32_t affordable =
      static_cast<uint32_t>(spare < UINT32_MAX ? spare : UINT32_MAX) / slot_bytes<Index, Intake>;
  const uint32_t slots = minimum.slots + lesser(affordable, max_slots<Index> - minimum.slots);
  return {slots, slots / 16};
}

}  // namespace detail::sizing

}  // namespace discmc

#endif

// The common part of all classes that accept rows of samples.
#ifndef DISCMC_ROW_INPUT_HPP
#define DISCMC_ROW_INPUT_HPP

#include <discmc/status.hpp>

namespace discmc {

/// Whether the library accepts samples of this type.
template <class Sample>
constexpr bool is_sample = false;
template <>
inline constexpr bool is_sample<uint8_t> = true;
template <>
inline constexpr bool is_sample<uint16_t> = true;
template <>
inline constexpr bool is_sample<int16_t> = true;

/// A number that distinguishes the types of samples.
template <class Sample>
constexpr uint32_t sample_type = 2 * sizeof(Sample) + (static_cast<Sample>(-1) < 0 ? 1 : 0);

/// How many of the given samples belong to the current row, which already has `column` samples.
constexpr uint32_t samples_of_row(uint32_t given, uint32_t column, uint32_t width) {
  const uint32_t room = width - column;
  return given < room ? given : room;
}

/// The replacement of a missing row: voxels that are off, or the previous row. If there is no
/// previous row, the voxels are off.
enum class Substitute : uint8_t { off, previous_row };

/// The result of push().
struct [[nodiscard]] PushResult {
  Status status;
  uint32_t samples;  ///< the samples accepted, counted from the first; push only the others again
};

}  // namespace discmc

#endif

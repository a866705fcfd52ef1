// What those that take rows of samples have in common.
#ifndef DISCMC_ROW_INPUT_HPP
#define DISCMC_ROW_INPUT_HPP

#include <discmc/status.hpp>

namespace discmc {

/// Whether samples of a type can be pushed.
template <class Sample>
constexpr bool is_sample = false;
template <>
inline constexpr bool is_sample<uint8_t> = true;
template <>
inline constexpr bool is_sample<uint16_t> = true;
template <>
inline constexpr bool is_sample<int16_t> = true;

/// Tells the types of samples apart.
template <class Sample>
constexpr uint32_t sample_type = 2 * sizeof(Sample) + (static_cast<Sample>(-1) < 0 ? 1 : 0);

/// How many of the samples given belong to the row that arrives, of which `column` are there.
constexpr uint32_t samples_of_row(uint32_t given, uint32_t column, uint32_t width) {
  const uint32_t room = width - column;
  return given < room ? given : room;
}

/// What stands in for a row that never came.
enum class Substitute : uint8_t { off, previous_row };

/// The result of push(), and how many of the samples it took. The rest must be pushed again.
struct [[nodiscard]] PushResult {
  Status status;
  uint32_t samples;
};

}  // namespace discmc

#endif

// What those that take rows of samples have in common: Extractor and SliceEncoder.
#ifndef DISCMC_ROW_INPUT_HPP
#define DISCMC_ROW_INPUT_HPP

#include <discmc/status.hpp>

namespace discmc {

/// What stands in for a row that never came.
enum class Substitute : uint8_t { off, previous_row };

/// The result of push(), and how many of the samples it took. The rest must be pushed again.
struct [[nodiscard]] PushResult {
  Status status;
  uint32_t samples;
};

}  // namespace discmc

#endif

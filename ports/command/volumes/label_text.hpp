// The values of labels from text.
#ifndef DISCMC_COMMAND_VOLUMES_LABEL_TEXT_HPP
#define DISCMC_COMMAND_VOLUMES_LABEL_TEXT_HPP

#include <cstdint>
#include <optional>
#include <string_view>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "text/whole_number.hpp"

namespace discmc::command {

/// Nothing where the text is no whole number of 64 bits.
inline std::optional<LabelValue> label_value(std::string_view text) {
  if (const auto value = whole_number<std::uint64_t>(text)) return LabelValue(*value);
  if (const auto value = whole_number<std::int64_t>(text)) return LabelValue(*value);
  return std::nullopt;
}

}  // namespace discmc::command

#endif

// Units of length, by the names that files give them.
#pragma once

#include <optional>
#include <string_view>

namespace discmc::command {

/// Returns how many millimetres a unit has; nothing if the name is that of no length. Symbols,
/// and words in British or American spelling, one or several, in any case: "um", "Microns".
std::optional<double> millimetres_in(std::string_view unit);

}  // namespace discmc::command

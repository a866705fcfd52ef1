// Units of length, as files spell them.
#ifndef DISCMC_COMMAND_VOLUMES_LENGTH_UNIT_HPP
#define DISCMC_COMMAND_VOLUMES_LENGTH_UNIT_HPP

#include <optional>
#include <string_view>

namespace discmc::command {

/// Returns how many millimetres a unit is; nothing where it is none of length.
std::optional<double> millimetres_in(std::string_view unit);

}  // namespace discmc::command

#endif

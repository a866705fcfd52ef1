// The kind of an input by its first bytes, if its name does not decide.
#ifndef DISCMC_COMMAND_CLI_INPUT_CONTENT_HPP
#define DISCMC_COMMAND_CLI_INPUT_CONTENT_HPP

#include <optional>
#include <string>

#include "replayed_input.hpp"

namespace discmc::command {

/// Whether a file, or standard input by the name "-", begins like a volume. What cannot be opened
/// may be a pattern of names, and counts as a volume: its reader reports the fault. A pipe does
/// not, as its first bytes cannot be returned. replayed: returns those of standard input again.
bool begins_like_volume(const std::string& input, std::optional<ReplayedInput>& replayed);

}  // namespace discmc::command

#endif

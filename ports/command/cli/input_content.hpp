// What an input is by its first bytes, where its name does not tell.
#ifndef DISCMC_COMMAND_CLI_INPUT_CONTENT_HPP
#define DISCMC_COMMAND_CLI_INPUT_CONTENT_HPP

#include <optional>
#include <string>

#include "replayed_input.hpp"

namespace discmc::command {

/// Whether a file, or standard input by the name "-", begins like a volume. What cannot be opened
/// may be a pattern of names, and is one: the volume's reader says what is wrong. A pipe is none,
/// as its first bytes cannot be given back. replayed: gives those of standard input again.
bool begins_like_volume(const std::string& input, std::optional<ReplayedInput>& replayed);

}  // namespace discmc::command

#endif

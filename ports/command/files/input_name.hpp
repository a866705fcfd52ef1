// What an input is called.
#ifndef DISCMC_COMMAND_FILES_INPUT_NAME_HPP
#define DISCMC_COMMAND_FILES_INPUT_NAME_HPP

#include <string>

namespace discmc::command {

/// The last part of a path: the name of the file, or of the folder, also where a slash follows it.
std::string input_name(const std::string& input);

}  // namespace discmc::command

#endif

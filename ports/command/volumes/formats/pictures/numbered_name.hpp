// Names as the texts between their numbers, and these.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_NUMBERED_NAME_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_NUMBERED_NAME_HPP

#include <filesystem>
#include <string>
#include <vector>

namespace discmc::command {

/// The name of a file, without its folder.
struct NumberedName {
  explicit NumberedName(const std::filesystem::path& file);

  std::vector<std::string> texts;    ///< before, between and after the numbers
  std::vector<std::string> digits;   ///< the numbers as they are written
  std::vector<std::string> numbers;  ///< the same without leading zeros
};

}  // namespace discmc::command

#endif

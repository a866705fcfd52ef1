// Whether names of pictures are those of one stack.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_NAMES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_NAMES_HPP

#include <filesystem>
#include <vector>

namespace discmc::command {

/// Throws where the names are those of several stacks, with a pattern of one of them: where they
/// differ in more than their numbers, and where no number counts the files by itself. source: what
/// was named. files: in natural order.
void require_one_stack(const std::filesystem::path& source,
                       const std::vector<std::filesystem::path>& files);

}  // namespace discmc::command

#endif

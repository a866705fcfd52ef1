// Whether names of pictures are those of one stack.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_NAMES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_STACK_NAMES_HPP

#include <filesystem>
#include <vector>

namespace discmc::command {

/// Throws if the names belong to several stacks, with a pattern of one of them. They do if they
/// differ in more than their numbers, or if no number counts the files by itself. source: what was
/// named. files: in natural order.
void require_one_stack(const std::filesystem::path& source,
                       const std::vector<std::filesystem::path>& files);

}  // namespace discmc::command

#endif

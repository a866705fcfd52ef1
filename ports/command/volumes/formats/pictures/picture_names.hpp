// The names of picture files, and their order.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PICTURE_NAMES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PICTURE_NAMES_HPP

#include <filesystem>
#include <vector>

#include "volumes/gaps.hpp"

namespace discmc::command {

bool is_png_name(const std::filesystem::path& file);

/// Whether the name is that of a PNG or TIFF file.
bool is_picture_name(const std::filesystem::path& file);

/// Returns the pictures of a folder; what is in further folders in it is left.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder);

/// Orders by names in which numbers count as such: slice2 before slice10.
void sort_naturally(std::vector<std::filesystem::path>& files);

/// Returns where names are missing, of files in their natural order: those that are alike but for
/// one number that grows by even steps, and in places by a multiple of them. Other numbers count
/// nothing, and leave no gaps.
std::vector<Gap> gaps_of_names(const std::vector<std::filesystem::path>& files);

}  // namespace discmc::command

#endif

// The names of picture files, and their order.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "volumes/gaps.hpp"

namespace discmc::command {

enum class PictureKind { none, png, tiff, jpeg, bmp };

/// For people: "PNG".
std::string_view name(PictureKind kind);

/// The kind that a file is named as.
PictureKind kind_of_name(const std::filesystem::path& file);

/// Whether the name is that of a picture.
bool is_picture_name(const std::filesystem::path& file);

/// The kind of a file that begins with these bytes. Limit: picture_magic_bytes of them, fewer where
/// there are no more.
PictureKind kind_of_head(std::string_view head);
constexpr std::size_t picture_magic_bytes = 8;

/// Whether a system keeps such files beside others: ._a.png, Thumbs.db.
bool is_system_name(const std::filesystem::path& file);

/// Returns the pictures of a folder; what is in further folders in it is left.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder);

/// Orders by names in which numbers count as such: slice2 before slice10.
void sort_naturally(std::vector<std::filesystem::path>& files);

/// Returns where names are missing in a natural order of files. The names are alike but for one
/// number that grows by even steps, and in places by a multiple of them. Other numbers count
/// nothing, and leave no gaps.
std::vector<Gap> gaps_of_names(const std::vector<std::filesystem::path>& files);

/// The name of a file, without its folder.
struct NumberedName {
  explicit NumberedName(const std::filesystem::path& file);

  std::vector<std::string> texts;    ///< before, between and after the numbers
  std::vector<std::string> digits;   ///< the numbers as they are written
  std::vector<std::string> numbers;  ///< the same without leading zeros
};

}  // namespace discmc::command

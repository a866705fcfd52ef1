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

/// Returns a name for people: "PNG".
std::string_view name(PictureKind kind);

/// Returns the kind by the name of the file.
PictureKind kind_of_name(const std::filesystem::path& file);

/// Whether the name is a picture's.
bool is_picture_name(const std::filesystem::path& file);

/// Returns the kind of a file by its first bytes. Limit: picture_magic_bytes bytes, fewer in a
/// shorter file.
PictureKind kind_of_head(std::string_view head);
constexpr std::size_t picture_magic_bytes = 8;

/// Whether an operating system puts such files beside others: ._a.png, Thumbs.db.
bool is_system_name(const std::filesystem::path& file);

/// Returns the pictures of a folder, without its subfolders.
std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder);

/// Sorts names with their numbers in numeric order: slice2 before slice10.
void sort_naturally(std::vector<std::filesystem::path>& files);

/// Sorts names by the only number in which they differ, if it has decimals or a sign, and even
/// steps: z_-0.5 before z_0.0. Returns false, and changes nothing, if the names differ otherwise.
bool sort_by_decimals(std::vector<std::filesystem::path>& files);

/// Returns the gaps between names in order. Names must differ in only one number, which
/// grows by an even step, and in gaps by a multiple of it. Other numbers leave no gaps.
std::vector<Gap> gaps_of_names(const std::vector<std::filesystem::path>& files);

/// The name of a file, without its folder.
struct NumberedName {
  explicit NumberedName(const std::filesystem::path& file);

  /// Returns the texts, with the extension in lower case: a1.PNG and a2.png are of one kind.
  std::vector<std::string> kind() const;

  std::vector<std::string> texts;    ///< text before, between and after the numbers
  std::vector<std::string> digits;   ///< numbers as written
  std::vector<std::string> numbers;  ///< numbers without leading zeros
};

}  // namespace discmc::command

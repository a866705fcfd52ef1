#include "picture_names.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>

#include "volumes/volume_format.hpp"

namespace discmc::host {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Takes a number off the front, without its leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

bool is_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view left = take_number(a);
      const std::string_view right = take_number(b);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (a[0] != b[0]) return a[0] < b[0];
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace

bool is_png_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".png";
}

bool is_picture_name(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".png" || extension == ".tif" || extension == ".tiff";
}

std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_picture_name(entry.path())) files.push_back(entry.path());
  return files;
}

void sort_naturally(std::vector<std::filesystem::path>& files) {
  // Equal but for zeros: by the plain order, for the same one everywhere.
  std::sort(files.begin(), files.end());
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return is_before(a.native(), b.native()); });
}

}  // namespace discmc::host

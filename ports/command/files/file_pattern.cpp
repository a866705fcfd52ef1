#include "file_pattern.hpp"

#include <filesystem>
#include <stdexcept>

#include "output_file.hpp"
#include "text/words.hpp"

namespace discmc::command {
namespace {

// Shortens a name between two characters of UTF-8, so that it fits a file name with the pattern's
// other text.
std::string shortened(std::string name) {
  constexpr std::size_t max_bytes = 100;  // file systems allow 255 bytes
  if (name.size() <= max_bytes) return name;
  const auto continues = [&name](std::size_t at) {
    return (static_cast<unsigned char>(name[at]) & 0xC0U) == 0x80;
  };
  std::size_t end = max_bytes;
  while (end > max_bytes - 4 && continues(end)) --end;
  return name.substr(0, end);
}

// Replaces separators of paths and control characters.
std::string in_file_names(const std::string& text) {
  constexpr std::string_view forbidden = "/\\:*?\"<>|";
  std::string result;
  for (const char c : text) {
    const bool is_usable = !is_control(c) && forbidden.find(c) == std::string_view::npos;
    result += is_usable ? c : '_';
  }
  return result;
}

std::string as_file_name(const std::string& name) {
  std::string result = in_file_names(name);
  if (result.empty() || result.front() == '.') result.insert(0, "_");
  return shortened(std::move(result));
}

}  // namespace

std::string FilePattern::first_in_braces(std::string_view but_for) const {
  for (std::size_t at = pattern_.find('{'); at != std::string::npos;
       at = pattern_.find('{', at + 1)) {
    const std::size_t end = pattern_.find('}', at);
    if (end == std::string::npos) break;
    const std::string_view found = std::string_view(pattern_).substr(at, end + 1 - at);
    if (found != but_for) return std::string(found);
  }
  return {};
}

std::string FilePattern::file_for(const std::string& name, const std::string& addition) const {
  const std::string_view mark = placeholder;
  std::string file = pattern_;
  const std::string text = as_file_name(name) + in_file_names(addition);
  for (std::size_t at = file.find(mark); at != std::string::npos;
       at = file.find(mark, at + text.size()))
    file.replace(at, mark.size(), text);
  return file;
}

void FilePattern::require_folder() const {
  if (std::filesystem::path(pattern_).parent_path().string().find(placeholder) != std::string::npos)
    throw std::invalid_argument(
        pattern_ + ": {name} is not allowed in the name of a folder; put it after the last /");
  command::require_folder(std::filesystem::path(pattern_).parent_path());
}

std::string input_name(const std::string& input) {
  const std::filesystem::path path = std::filesystem::path(input).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace discmc::command

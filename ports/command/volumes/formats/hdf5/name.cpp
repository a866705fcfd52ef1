#include "name.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <system_error>

#include "text/words.hpp"

namespace discmc::command {

Hdf5Name hdf5_name(const std::filesystem::path& name) {
  const std::string& text = name.native();
  const auto is_file = [&text](std::size_t end) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(text.substr(0, end), ignored);
  };
  std::error_code ignored;
  const std::size_t first = text.find(":/");
  if (first == std::string::npos || std::filesystem::exists(name, ignored)) return {name, {}};
  std::size_t colon = first;  // folders may have it in their names, datasets too
  while (colon != std::string::npos && !is_file(colon)) colon = text.find(":/", colon + 1);
  if (colon == std::string::npos) colon = first;
  return {text.substr(0, colon), text.substr(colon + 1)};
}

bool has_hdf5_name(const std::filesystem::path& name) {
  constexpr std::string_view extensions[] = {".h5", ".hdf5", ".nxs"};
  const Hdf5Name parts = hdf5_name(name);
  const std::string extension = lower(parts.file.extension().string());
  return !parts.dataset.empty() ||
         std::find(std::begin(extensions), std::end(extensions), extension) != std::end(extensions);
}

}  // namespace discmc::command

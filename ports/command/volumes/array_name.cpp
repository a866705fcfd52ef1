#include "array_name.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>

#include "byte_source.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

// Returns a line such as "/exchange/data (512 x 512 x 100)", with x first.
std::string listed(const NamedArray& array) {
  std::string text;
  for (auto size = array.sizes.rbegin(); size != array.sizes.rend(); ++size)
    text += (text.empty() ? "" : " x ") + std::to_string(*size);
  return without_control(array.name) + " (" + text + ")";
}

std::string list_of(const std::vector<NamedArray>& arrays) {
  constexpr std::size_t max_listed = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(arrays.size(), max_listed); ++i)
    text += (i > 0 ? ", " : "") + listed(arrays[i]);
  return text + (arrays.size() > max_listed ? ", ..." : "");
}

}  // namespace

ArrayName array_name(const std::filesystem::path& name) {
  const std::string& text = name.native();
  std::error_code ignored;
  const std::size_t first = text.find(":/");
  if (first == std::string::npos || std::filesystem::exists(name, ignored)) return {name, {}};
  std::size_t colon = first;  // names of folders and arrays may contain colons
  while (colon != std::string::npos && !is_file(text.substr(0, colon)))
    colon = text.find(":/", colon + 1);
  if (colon == std::string::npos) colon = first;
  return {text.substr(0, colon), text.substr(colon + 1)};
}

void fail_no_array(const std::filesystem::path& file, const std::string& asked,
                   const std::vector<NamedArray>& arrays) {
  fail(file,
       "there is no array " + shown(asked) + " of numbers with two or more dimensions in the file",
       arrays.empty() ? "give a file that holds a volume" : "choose one of " + list_of(arrays));
}

std::string only_array(const std::filesystem::path& file, const std::vector<NamedArray>& arrays) {
  std::vector<NamedArray> volumes;
  std::copy_if(arrays.begin(), arrays.end(), std::back_inserter(volumes),
               [](const NamedArray& array) { return array.sizes.size() >= 3; });
  if (volumes.empty()) volumes = arrays;
  if (volumes.empty())
    fail(file, "the file holds no array of numbers with two or more dimensions",
         "give a file that holds a volume");
  if (volumes.size() > 1)
    fail(file, "the file holds " + std::to_string(volumes.size()) + " arrays: " + list_of(volumes),
         "choose one by its name after the name of the file, as in " + file.filename().string() +
             ":" + without_control(volumes.front().name));
  return volumes.front().name;
}

}  // namespace discmc::command

// Files that hold several arrays: what names one of them, and which it is where none is named.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace discmc::command {

/// scan.h5:/exchange/data taken apart.
struct ArrayName {
  std::filesystem::path file;
  std::string array;  ///< "/exchange/data"; empty where none is named
};
ArrayName array_name(const std::filesystem::path& name);

/// An array of numbers with at least two axes.
struct NamedArray {
  std::string name;                 ///< "/exchange/data"
  std::vector<std::int64_t> sizes;  ///< x is the last one
};

/// Returns the name of the only array of three axes or more, or else of two. Throws VolumeError
/// where there is none, and with a list of them where there are several.
std::string only_array(const std::filesystem::path& file, const std::vector<NamedArray>& arrays);

/// Throws the refusal of a name that no array has.
[[noreturn]] void fail_no_array(const std::filesystem::path& file, const std::string& asked,
                                const std::vector<NamedArray>& arrays);

}  // namespace discmc::command

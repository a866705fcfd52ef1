// Chooses one of several arrays in a file, by name or as the only candidate.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace discmc::command {

/// The parts of a name such as scan.h5:/exchange/data.
struct ArrayName {
  std::filesystem::path file;
  std::string array;  ///< "/exchange/data"; empty if the user names none
};
ArrayName array_name(const std::filesystem::path& name);

/// An array of numbers with at least two axes.
struct NamedArray {
  std::string name;                 ///< "/exchange/data"
  std::vector<std::int64_t> sizes;  ///< the last one is x
};

/// Returns the name of the only array of three axes or more, otherwise of two. Throws VolumeError
/// if there is none; if there are several, its text lists them.
std::string only_array(const std::filesystem::path& file, const std::vector<NamedArray>& arrays);

/// Throws VolumeError for a name that no array has.
[[noreturn]] void fail_no_array(const std::filesystem::path& file, const std::string& asked,
                                const std::vector<NamedArray>& arrays);

}  // namespace discmc::command

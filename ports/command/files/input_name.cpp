#include "input_name.hpp"

#include <filesystem>

namespace discmc::command {

std::string input_name(const std::string& input) {
  const std::filesystem::path path = std::filesystem::path(input).lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

}  // namespace discmc::command

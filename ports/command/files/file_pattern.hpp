// Names of inputs and outputs.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace discmc::command {

/// The name of an output in which the name of a surface replaces {name}: "out/{name}.stl".
class FilePattern {
 public:
  explicit FilePattern(std::string pattern) : pattern_(std::move(pattern)) {}

  bool has_name() const { return pattern_.find(placeholder) != std::string::npos; }

  /// Returns the first text in braces, with the braces, or an empty string.
  std::string first_placeholder() const { return first_in_braces({}); }

  /// Returns the first text in braces that is not {name}, with the braces, or an empty string.
  std::string unknown_placeholder() const { return first_in_braces(placeholder); }

  /// Returns the file for a name. Characters that no file name can contain become underscores. A
  /// long name is shortened, but not the addition that makes it unique.
  std::string file_for(const std::string& name, const std::string& addition = {}) const;

  /// Checks the folder before any work is done. Throws std::invalid_argument if {name} is part of
  /// the folder, and like command::require_folder().
  void require_folder() const;

 private:
  static constexpr const char* placeholder = "{name}";

  std::string first_in_braces(std::string_view but_for) const;

  std::string pattern_;
};

/// Returns the last part of a path, the name of a file or folder, even if a slash follows it.
std::string input_name(const std::string& input);

}  // namespace discmc::command

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

  /// The first text in braces, with them; empty where there is none.
  std::string first_placeholder() const { return first_in_braces({}); }

  /// The first text in braces that is not {name}, with them; empty where there is none.
  std::string unknown_placeholder() const { return first_in_braces(placeholder); }

  /// What no name of a file can have becomes an underscore; a long name is cut, but not the
  /// addition that makes it unique.
  std::string file_for(const std::string& name, const std::string& addition = {}) const;

  /// Throws, before work is done, std::invalid_argument where {name} is in the name of a folder,
  /// and as command::require_folder().
  void require_folder() const;

 private:
  static constexpr const char* placeholder = "{name}";

  std::string first_in_braces(std::string_view but_for) const;

  std::string pattern_;
};

/// The last part of a path: the name of the file, or of the folder, also where a slash follows it.
std::string input_name(const std::string& input);

}  // namespace discmc::command

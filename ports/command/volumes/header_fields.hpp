// The fields of headers that are text, and their values.
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace discmc::command {

class HeaderFields {
 public:
  /// file: the file of the header, for errors.
  explicit HeaderFields(std::filesystem::path file) : file_(std::move(file)) {}

  const std::filesystem::path& file() const { return file_; }

  /// Throws VolumeError if the field exists already.
  void add(const std::string& name, std::string_view text);
  /// Limit: has(name).
  void replace(std::string_view name, std::string text);

  bool has(std::string_view name) const { return fields_.find(name) != fields_.end(); }

  /// Returns the value of the first name that exists; empty if none does.
  std::string_view text(std::initializer_list<std::string_view> names) const;
  std::string_view text(std::string_view name) const { return text({name}); }

  /// Throw VolumeError if the field is missing or empty.
  std::string_view needed(std::string_view name) const;
  std::vector<std::int64_t> needed_integers(std::string_view name) const;

  /// Throw VolumeError if the text is not such a number.
  std::int64_t integer(std::string_view name, std::int64_t otherwise) const;
  std::vector<double> reals(std::initializer_list<std::string_view> names) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string, std::less<>> fields_;
};

/// Return the number that is the whole text; a real may be nan or infinite. Throw VolumeError
/// otherwise. file, field: for the error.
std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text);
double real(const std::filesystem::path& file, std::string_view field, std::string_view text);
/// Likewise returns several numbers between blanks.
std::vector<double> reals(const std::filesystem::path& file, std::string_view field,
                          std::string_view text);

/// Whether a path may leave its folder.
bool leads_out(std::string_view name);

/// Returns the file or folder that a header names, beside the header or in a subfolder. Throws if
/// the text is not a path, or may leave the folder: headers from strangers must not choose among
/// all files of the user.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace discmc::command

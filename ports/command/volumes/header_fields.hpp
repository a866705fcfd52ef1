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
  /// file: that has the header, for errors.
  explicit HeaderFields(std::filesystem::path file) : file_(std::move(file)) {}

  const std::filesystem::path& file() const { return file_; }

  /// Throws VolumeError when the field is there already.
  void add(const std::string& name, std::string_view text);
  /// Limit: has(name).
  void replace(std::string_view name, std::string text);

  bool has(std::string_view name) const { return fields_.find(name) != fields_.end(); }

  /// The value of the first name that is there; empty if none is.
  std::string_view text(std::initializer_list<std::string_view> names) const;
  std::string_view text(std::string_view name) const { return text({name}); }

  /// Throw VolumeError when the field is not there, or is empty.
  std::string_view needed(std::string_view name) const;
  std::vector<std::int64_t> needed_integers(std::string_view name) const;

  /// Throw VolumeError when the text is no such number.
  std::int64_t integer(std::string_view name, std::int64_t otherwise) const;
  std::vector<double> reals(std::initializer_list<std::string_view> names) const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string, std::less<>> fields_;
};

/// Return the number when the text is one and nothing else; a real may be nan or infinite. The file
/// and the name of the field are for the VolumeError thrown otherwise.
std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text);
double real(const std::filesystem::path& file, std::string_view field, std::string_view text);
/// The same of several numbers between blanks.
std::vector<double> reals(const std::filesystem::path& file, std::string_view field,
                          std::string_view text);

/// Whether a name is not of something in a folder or the folders in it.
bool leads_out(std::string_view name);

/// Returns the file or folder that the text of a header names, beside the header or in a folder
/// there. Throws when that is no name, or one that leads out: headers come from strangers, who must
/// not choose among all files of the user.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace discmc::command

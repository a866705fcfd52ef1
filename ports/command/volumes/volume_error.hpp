// The error of a volume that cannot be read.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace discmc::command {

/// Its text is "file: fault; remedy".
class VolumeError : public std::runtime_error {
 public:
  VolumeError(const std::string& file, const std::string& fault, const std::string& remedy);

  const std::string& file() const { return file_; }
  const std::string& fault() const { return fault_; }
  const std::string& remedy() const { return remedy_; }

 private:
  std::string file_;
  std::string fault_, remedy_;
};

/// A remedy for damaged files.
inline constexpr const char* copy_or_export = "copy or export the file again";

/// Throws a VolumeError.
[[noreturn]] void fail(const std::string& file, const std::string& fault,
                       const std::string& remedy);

/// Throws VolumeError for a sample type, given by the file's name for it.
[[noreturn]] void fail_type(const std::string& file, std::string_view type);

/// Throws if all slices have been read.
void require_slice_left(const std::string& file, std::size_t read, std::size_t slices);

/// Returns text from a file in quotes, shortened for a message, without control bytes.
std::string shown(std::string_view text);

}  // namespace discmc::command

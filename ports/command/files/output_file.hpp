// The file that a command writes.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>

namespace discmc::command {

/// Throws std::runtime_error with the reason if the folder cannot hold a new file.
void require_folder(const std::filesystem::path& folder);

/// Whether an output of this name is standard output: "-", or "-." with the extension of a format.
bool is_standard_output(const std::filesystem::path& path);

/// Returns the name of an output for messages.
std::string output_display_name(const std::filesystem::path& path);

/// A file that gets its name only by commit(). An earlier failure, or a terminating signal, leaves
/// no incomplete file. A power failure after commit() loses nothing. Until then the file has a
/// random name beside its target. A link stays, and its target is replaced; a replaced file keeps
/// its permissions. Standard output, pipes and devices are written in place. Limit: of several
/// files, a signal removes only the last.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  std::ostream& stream();
  /// Whether the stream can seek; pipes, devices and standard output cannot.
  bool can_seek() const { return !is_in_place(); }
  /// Throws std::runtime_error if some bytes could not be written.
  void commit();

 private:
  bool is_standard_output() const { return command::is_standard_output(path_); }
  bool is_in_place() const { return target_.empty(); }
  void open_beside(const std::filesystem::file_status& replaced);
  void discard();

  std::filesystem::path path_;       // as the caller names it
  std::filesystem::path target_;     // after following links; empty if written in place
  std::filesystem::path temporary_;  // beside the target, until commit()
  int descriptor_ = -1;
  std::unique_ptr<std::streambuf> buffer_;
  std::ostream stream_{nullptr};
};

}  // namespace discmc::command

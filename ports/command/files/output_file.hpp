// The file that a command writes.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>

namespace discmc::command {

/// Throws std::runtime_error with the reason if no file can be made in the folder.
void require_folder(const std::filesystem::path& folder);

/// Whether an output of this name is standard output: "-", or "-." with the extension of a format.
bool is_standard_output(const std::filesystem::path& path);

/// What an output of this name is called in messages.
std::string output_for_people(const std::filesystem::path& path);

/// A file that appears under its name only when commit() is reached. An earlier failure, or a
/// signal that ends the program, leaves no half-written file. A power failure after commit() loses
/// nothing. Until then it lies beside its target under a random name. A link stays, and its target
/// is written; a file that is replaced keeps its permissions. Standard output, pipes and devices
/// are written in place. Limit: of several, a signal removes the last.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  std::ostream& stream();
  /// Whether the stream can seek: no pipe, device or standard output can.
  bool can_seek() const { return !is_in_place(); }
  /// Throws std::runtime_error when not everything could be written.
  void commit();

 private:
  bool is_standard_output() const { return command::is_standard_output(path_); }
  bool is_in_place() const { return target_.empty(); }
  void open_beside(const std::filesystem::file_status& replaced);
  void discard();

  std::filesystem::path path_;       // as given
  std::filesystem::path target_;     // of links; empty in place
  std::filesystem::path temporary_;  // beside it, as long as it is there
  int descriptor_ = -1;
  std::unique_ptr<std::streambuf> buffer_;
  std::ostream stream_{nullptr};
};

}  // namespace discmc::command

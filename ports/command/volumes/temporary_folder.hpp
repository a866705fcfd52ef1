// Files that are there as long as they are read.
#ifndef DISCMC_COMMAND_VOLUMES_TEMPORARY_FOLDER_HPP
#define DISCMC_COMMAND_VOLUMES_TEMPORARY_FOLDER_HPP

#include <sys/types.h>

#include <filesystem>

namespace discmc::command {

/// A folder of its own, removed at its end with its contents, and also when a signal ends the
/// program. Patients' data must not stay. A process that waits for that end removes it.
class TemporaryFolder {
 public:
  /// Throws VolumeError where there can be none.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  void leave_to_remover();
  [[noreturn]] void remove_at_end(int end, int alive) const;

  std::filesystem::path path_;
  pid_t remover_ = 0;
  int alive_ = -1;
};

}  // namespace discmc::command

#endif

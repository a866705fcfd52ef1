#include "temporary_folder.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <set>
#include <string>
#include <system_error>

#include "volume_error.hpp"

namespace discmc::command {
namespace {

// The ends of pipes that close when this program ends. Removers inherit those made before.
std::set<int>& others_alive() {
  static std::set<int> ends;
  return ends;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  std::string name =
      (std::filesystem::temp_directory_path(error) / "discmc-unpacked-XXXXXX").string();
  if (error || mkdtemp(name.data()) == nullptr)
    fail(name, "there is no folder for temporary files",
         "set TMPDIR to a folder that can be written");
  path_ = name;
  leave_to_remover();
}

TemporaryFolder::~TemporaryFolder() {
  close(alive_);
  others_alive().erase(alive_);
  waitpid(remover_, nullptr, 0);
}

void TemporaryFolder::leave_to_remover() {
  int ends[2];
  if (pipe(ends) != 0 || (remover_ = fork()) < 0) {
    rmdir(path_.c_str());
    fail(path_, "the process that removes unpacked files cannot be started",
         "unpack it and give the file or the folder");
  }
  if (remover_ == 0) remove_at_end(ends[0], ends[1]);
  close(ends[0]);
  alive_ = ends[1];
  others_alive().insert(alive_);
}

void TemporaryFolder::remove_at_end(int end, int alive) const {
  setsid();  // signals of the terminal are not for it
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) close(standard);
  for (const int other : others_alive()) close(other);
  close(alive);
  char nothing = 0;
  while (read(end, &nothing, 1) < 0 && errno == EINTR) {
  }
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  _exit(0);
}

}  // namespace discmc::command

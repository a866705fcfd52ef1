#include "qemu.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace discmc::simulator {
namespace {

std::vector<std::string> command(const std::string& firmware, const Qemu::Files& files) {
  const auto socket = [](const char* id, const std::string& path) {
    return std::string("socket,id=") + id + ",path=" + path;
  };
  const std::pair<const char*, std::string> options[] = {
      {"-M", "mps2-an386"},
      {"-display", "none"},
      {"-chardev", socket("stream", files.stream)},
      {"-chardev", socket("rows", files.rows)},
      {"-chardev", socket("monitor", files.monitor)},
      {"-serial", "chardev:stream"},  // the first UART
      {"-serial", "chardev:rows"},    // the second UART
      {"-mon", "chardev=monitor"},
      {"-semihosting-config", "enable=on,target=native"},
      {"-kernel", firmware},
  };
  std::vector<std::string> words{"qemu-system-arm"};
  for (const auto& [name, value] : options) words.insert(words.end(), {name, value});
  return words;
}

// Runs in the child: starts the command, which ends with the simulator.
[[noreturn]] void become(std::vector<std::string>& words, const std::string& console, int failure) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  std::vector<char*> arguments(words.size() + 1, nullptr);
  std::transform(words.begin(), words.end(), arguments.begin(),
                 [](std::string& word) { return word.data(); });
  const int output = open(console.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  execvp(arguments[0], arguments.data());
  const int error = errno;
  const ssize_t ignored = write(failure, &error, sizeof error);
  _exit(ignored > 0 ? 127 : 126);
}

}  // namespace

Qemu::Qemu(const std::string& firmware, const Files& files) {
  if (!std::filesystem::is_regular_file(firmware))
    throw std::runtime_error(firmware +
                             ": no such file: ports/boards/README.md describes how to build it");
  std::vector<std::string> words = command(firmware, files);
  int failure[2];
  if (pipe2(failure, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  process_ = fork();
  if (process_ == 0) become(words, files.console, failure[1]);
  close(failure[1]);
  // Nothing can be read from the pipe after QEMU has started.
  int error = process_ < 0 ? errno : 0;
  const bool failed = process_ < 0 || read(failure[0], &error, sizeof error) > 0;
  close(failure[0]);
  if (!failed) return;
  throw std::runtime_error(words[0] + ": " + std::strerror(error) +
                           ": install it (Debian: qemu-system-arm)");
}

Qemu::~Qemu() {
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

std::optional<int> Qemu::wait(std::chrono::milliseconds patience) {
  const auto until = std::chrono::steady_clock::now() + patience;
  int status = 0;
  while (waitpid(process_, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > until) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace discmc::simulator

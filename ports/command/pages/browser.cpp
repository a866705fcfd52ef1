#include "browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>

namespace discmc::command {
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

// Returns an empty string if there is no desktop.
std::string opener() {
  if (is_set("BROWSER")) return std::getenv("BROWSER");
#ifdef __APPLE__
  return "open";
#else
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") ? "xdg-open" : std::string();
#endif
}

}  // namespace

bool open_in_browser(const std::string& page) {
  std::string program = opener(), argument = page;
  if (program.empty()) return false;
  char* const arguments[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int each : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, each, "/dev/null", O_WRONLY, 0);
  // The browser must not inherit the signals that are blocked here.
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0;
}

}  // namespace discmc::command

// Firmware in QEMU, on a board with additional UARTs.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

namespace discmc::simulator {

/// A process of QEMU, ended with the object at the latest.
class Qemu {
 public:
  /// The paths of the sockets to which QEMU connects, and of the file with the firmware's output.
  struct Files {
    std::string stream, rows, monitor, console;
  };

  /// Throws std::runtime_error if QEMU is not installed.
  Qemu(const std::string& firmware, const Files& files);
  Qemu(const Qemu&) = delete;
  Qemu& operator=(const Qemu&) = delete;
  ~Qemu();

  /// Returns the exit code of the firmware; none if it does not end.
  std::optional<int> wait(std::chrono::milliseconds patience);

 private:
  pid_t process_ = -1;
};

}  // namespace discmc::simulator

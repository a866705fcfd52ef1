// A line of bytes to a device: what a UART is at the host's end.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace discmc::simulator {

/// A Unix socket at which the device, QEMU, calls; or the character device of a serial port.
/// Nothing here waits but connect().
class Line {
 public:
  /// Listens at the path, or opens it where it is a character device. Throws std::runtime_error.
  explicit Line(std::string path);
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line();

  /// Waits until the device has called. Throws std::runtime_error when it does not.
  void connect(std::chrono::milliseconds patience);

  /// The descriptor to poll; negative once the device has hung up.
  int descriptor() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }

  /// Reads available bytes, `count` at most. Returns their number.
  std::size_t read(std::uint8_t* bytes, std::size_t count);

  /// Sends bytes as soon as the line takes them.
  void send(const std::uint8_t* bytes, std::size_t count);
  /// Sends what has waited so far.
  void flush();
  /// Forgets what still waits.
  void discard() { waiting_.clear(); }
  bool is_busy() const { return !waiting_.empty(); }

 private:
  void hang_up();

  std::string path_;
  int listener_ = -1;
  int descriptor_ = -1;
  std::vector<std::uint8_t> waiting_;
};

}  // namespace discmc::simulator

// A line of bytes to a device: the host's end of a UART.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace discmc::simulator {

/// A Unix socket to which the device (QEMU) connects, or the character device of a serial port.
/// Only connect() waits.
class Line {
 public:
  /// Listens at the path, or opens it if it is a character device. Throws std::runtime_error.
  explicit Line(std::string path);
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line();

  /// Waits until the device has connected. Throws std::runtime_error on a timeout.
  void connect(std::chrono::milliseconds patience);

  /// The descriptor to poll; negative after the device has closed the line.
  int descriptor() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }

  /// Reads available bytes, at most `count`. Returns their number.
  std::size_t read(std::uint8_t* bytes, std::size_t count);

  /// Sends bytes as soon as the line accepts them.
  void send(const std::uint8_t* bytes, std::size_t count);
  /// Sends waiting bytes.
  void flush();
  /// Discards waiting bytes.
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

// A scanner's HID device, by hidapi.
#pragma once

#include <hidapi.h>

#include <array>
#include <chrono>
#include <memory>
#include <ostream>
#include <string>

#include "report.hpp"

namespace discmc::device {

/// Writes a line for every device that is there: path, vendor:product, names. Returns how many.
std::size_t list_hid_devices(std::ostream& out);

class HidDevice {
 public:
  using Bytes = std::array<std::uint8_t, Report::bytes>;

  /// name: a path, or vendor:product in hexadecimal digits as `list` shows them, of which the first
  /// device is taken. Throws std::runtime_error.
  explicit HidDevice(const std::string& name);

  /// Waits for a report; returns its bytes, 0 when the timeout is over or a signal came. Throws
  /// DeviceGone when the device is no longer there.
  std::size_t read(Bytes& report, std::chrono::milliseconds timeout);

  /// Throws DeviceGone when the device takes no report.
  void write(const Bytes& report);

 private:
  struct Close {
    void operator()(hid_device* device) const { hid_close(device); }
  };
  std::string name_;
  std::unique_ptr<hid_device, Close> device_;
};

}  // namespace discmc::device

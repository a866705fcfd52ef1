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

/// Writes a line for every device: path, vendor:product, names. Returns their number.
std::size_t list_hid_devices(std::ostream& out);

class HidDevice {
 public:
  using Bytes = std::array<std::uint8_t, Report::bytes>;

  /// name: a path, or vendor:product in hexadecimal digits as in `list`, which selects the first
  /// such device. Throws std::runtime_error.
  explicit HidDevice(const std::string& name);

  /// Waits for a report. Returns its size; 0 after a timeout or a signal. Throws DeviceGone if the
  /// device has disappeared.
  std::size_t read(Bytes& report, std::chrono::milliseconds timeout);

  /// Throws DeviceGone if the device accepts no report.
  void write(const Bytes& report);

 private:
  struct Close {
    void operator()(hid_device* device) const { hid_close(device); }
  };
  std::string name_;
  std::unique_ptr<hid_device, Close> device_;
};

}  // namespace discmc::device

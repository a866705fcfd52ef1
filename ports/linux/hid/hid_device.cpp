#include "hid_device.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "common/device_gone.hpp"
#include "common/stop_signal.hpp"

namespace discmc::device {
namespace {

// Characters that are not ASCII become question marks.
std::string narrow(const wchar_t* text) {
  std::string narrow;
  for (; text != nullptr && *text != 0; ++text)
    narrow += *text >= 32 && *text < 127 ? static_cast<char>(*text) : '?';
  return narrow;
}

std::string vendor_and_product(const hid_device_info& info) {
  char text[16];
  std::snprintf(text, sizeof text, "%04x:%04x", info.vendor_id, info.product_id);
  return text;
}

hid_device* open(const std::string& name) {
  unsigned short vendor = 0;
  unsigned short product = 0;
  char rest = 0;
  const bool is_number = std::sscanf(name.c_str(), "%4hx:%4hx%c", &vendor, &product, &rest) == 2;
  return is_number ? hid_open(vendor, product, nullptr) : hid_open_path(name.c_str());
}

}  // namespace

std::size_t list_hid_devices(std::ostream& out) {
  const std::unique_ptr<hid_device_info, void (*)(hid_device_info*)> all(hid_enumerate(0, 0),
                                                                         hid_free_enumeration);
  std::set<std::string> paths;  // hidapi lists a device once for each of its usages
  for (const hid_device_info* info = all.get(); info != nullptr; info = info->next)
    if (paths.insert(info->path).second)
      out << info->path << ' ' << vendor_and_product(*info) << ' '
          << narrow(info->manufacturer_string) << ' ' << narrow(info->product_string) << '\n';
  return paths.size();
}

HidDevice::HidDevice(const std::string& name) : name_(name), device_(open(name)) {
  if (device_ == nullptr)
    throw std::runtime_error(
        "HID device '" + name +
        "' cannot be opened; check its name with discmc-hid list, and the permissions of its path");
}

std::size_t HidDevice::read(Bytes& report, std::chrono::milliseconds timeout) {
  const int count = hid_read_timeout(device_.get(), report.data(), report.size(),
                                     static_cast<int>(timeout.count()));
  if (count < 0 && !stop_signal::came()) throw DeviceGone("HID device '" + name_ + "' is gone");
  return static_cast<std::size_t>(std::max(count, 0));
}

void HidDevice::write(const Bytes& report) {
  // hidapi requires the report id first: 0 for a device with a single report.
  std::array<std::uint8_t, 1 + Report::bytes> bytes{};
  std::copy(report.begin(), report.end(), bytes.begin() + 1);
  if (hid_write(device_.get(), bytes.data(), bytes.size()) < 0)
    throw DeviceGone("HID device '" + name_ + "' rejects a report (" +
                     narrow(hid_error(device_.get())) + ")");
}

}  // namespace discmc::device

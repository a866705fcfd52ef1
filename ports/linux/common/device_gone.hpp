// What a device throws that went away while it was in use.
#ifndef DISCMC_LINUX_COMMON_DEVICE_GONE_HPP
#define DISCMC_LINUX_COMMON_DEVICE_GONE_HPP

#include <stdexcept>

namespace discmc::device {

class DeviceGone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace discmc::device

#endif

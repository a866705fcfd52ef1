// What a device throws that went away while it was in use.
#pragma once

#include <stdexcept>

namespace discmc::device {

class DeviceGone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace discmc::device

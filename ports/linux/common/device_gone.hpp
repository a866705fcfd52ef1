// The exception for a device that disappears while it is in use.
#pragma once

#include <stdexcept>

namespace discmc::device {

class DeviceGone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace discmc::device

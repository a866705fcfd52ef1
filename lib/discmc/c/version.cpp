#include <discmc/version.hpp>

namespace discmc {

const char* version() {
  return DISCMC_VERSION_STRING;
}

}  // namespace discmc

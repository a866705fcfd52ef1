// Which version of the library this is.
#ifndef DISCMC_VERSION_HPP
#define DISCMC_VERSION_HPP

#include <discmc/version.h>

namespace discmc {

/// The version of the library that is linked, as "0.2.0". It is DISCMC_VERSION_STRING unless
/// headers and library are of two versions. Owner: static storage.
const char* version();

}  // namespace discmc

#endif

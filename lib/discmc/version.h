/* The version of these headers, for C and C++; discmc::version() returns the version of the linked
 * library. Streams have a version of their own: DISCMC_WIRE_VERSION. */
#ifndef DISCMC_VERSION_H
#define DISCMC_VERSION_H

#define DISCMC_VERSION_MAJOR 0
#define DISCMC_VERSION_MINOR 2
#define DISCMC_VERSION_PATCH 0
#define DISCMC_VERSION_STRING "0.2.0"

#ifdef __cplusplus
namespace discmc {

/// The version of the linked library, as "0.2.0". It is DISCMC_VERSION_STRING unless headers and
/// library are of two versions. Owner: static storage.
const char* version();

}  // namespace discmc
#endif

#endif

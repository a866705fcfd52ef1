/* The version of these headers, for C and C++. discmc_version() and discmc::version() give that of
 * the library that is linked. That of streams is DISCMC_WIRE_VERSION, another number. */
#ifndef DISCMC_VERSION_H
#define DISCMC_VERSION_H

#define DISCMC_VERSION_MAJOR 0
#define DISCMC_VERSION_MINOR 2
#define DISCMC_VERSION_PATCH 0
#define DISCMC_VERSION_STRING "0.2.0"

#endif

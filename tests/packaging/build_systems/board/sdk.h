/* The functions of the board that the stand-ins for SDKs call. */
#ifndef DISCMC_TESTS_SDK_H
#define DISCMC_TESTS_SDK_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
#endif
    void
    sdk_write(const uint8_t* bytes, size_t count);

#endif

/* As much of stdio.h as examples/firmware.c and .cpp use, on a board: stdout is the UART. */
#ifndef DISCMC_TESTS_BARE_STDIO_H
#define DISCMC_TESTS_BARE_STDIO_H

#include <stddef.h>

typedef struct file FILE;
#define stdout ((FILE *)0)

#ifdef __cplusplus
extern "C"
#endif
size_t fwrite(const void *bytes, size_t size, size_t count, FILE *file);

#endif

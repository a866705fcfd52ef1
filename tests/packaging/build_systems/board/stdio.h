/* As much of stdio.h as examples/firmware.c and .cpp use, on a board: stdout is the UART, stderr
 * is nowhere. */
#ifndef DISCMC_TESTS_BARE_STDIO_H
#define DISCMC_TESTS_BARE_STDIO_H

#include <stddef.h>

typedef struct file FILE;
#define stdout ((FILE *)0)
#define stderr ((FILE *)1)

#ifdef __cplusplus
extern "C" {
#endif
size_t fwrite(const void *bytes, size_t size, size_t count, FILE *file);
int fputs(const char *text, FILE *file);
#ifdef __cplusplus
}
#endif

#endif

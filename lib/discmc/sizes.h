/* The memory of the objects in discmc.h as constant expressions, for static arrays:
 *
 *   static uint8_t memory[DISCMC_EXTRACTOR_BYTES(256, 256, 4000)];
 *
 * They are upper bounds of discmc_X_bytes() on every target; the library and the tests check that.
 * Arguments may be evaluated more than once. width, height: voxels per row and rows per slice. */
#ifndef DISCMC_SIZES_H
#define DISCMC_SIZES_H

#include <limits.h>
#include <stdint.h>

#if INT_MAX < 0x7FFFFFFF
#error "discmc needs an int of at least 32 bits: its integers are promoted to int"
#endif

/* With this many slots, from DISCMC_MIN_SLOTS on; see discmc_extractor_config. */
#define DISCMC_EXTRACTOR_BYTES(width, height, slots)                           \
  (26 * sizeof(void*) + 962 + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + \
   UINT64_C(8) * (slots))

/* With normals; sample_bytes is 1 or 2. */
#define DISCMC_NORMAL_EXTRACTOR_BYTES(width, height, sample_bytes, slots)       \
  (28 * sizeof(void*) + 1032 + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + \
   (UINT64_C(4) * (height) + 6) * ((width) * (sample_bytes) + 2) + UINT64_C(14) * (slots))

/* Without normals, and with them. */
#define DISCMC_ENCODER_BYTES (10 * sizeof(void*) + 991)

/* For any interval of key slices. For an interval of 1, discmc_slice_encoder_bytes() is much less.
 */
#define DISCMC_SLICE_ENCODER_BYTES(width, height, surfaces)                   \
  (28 * sizeof(void*) + 58 +                                                  \
   DISCMC_BIT_ROW_BYTES_(width, (height) + 3 + ((height) < 2)) * (surfaces) + \
   UINT64_C(1060) * (surfaces))

/* The minimum for streams of slices; with more, fewer regions arrive as fragments. */
#define DISCMC_RECEIVER_BYTES(width, height, surfaces)                        \
  (72 * sizeof(void*) + 3041 +                                                \
   DISCMC_BIT_ROW_BYTES_(width, (height) + 3 + ((height) < 2)) * (surfaces) + \
   UINT64_C(1060) * (surfaces) + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + (width) / 8)

/* For this many fragments that wait at once, of eight runs each. */
#define DISCMC_JOINER_BYTES(fragments) (10 * sizeof(void*) + 242 + UINT64_C(192) * (fragments))

#define DISCMC_STORE_BYTES(program_bytes) (22 * sizeof(void*) + 103 + (program_bytes))
#define DISCMC_ROW_RING_BYTES(row_bytes, rows) \
  (3 * sizeof(void*) + 42 + UINT64_C(4) * (rows) * (((row_bytes) + UINT64_C(3)) / 4 + 1))

/* Private. */
#define DISCMC_BIT_ROW_BYTES_(width, rows) (UINT64_C(4) * ((width) / 30 + 1) * (rows))

#endif

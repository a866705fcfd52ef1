/* The bytes of memory for the objects in discmc.h, as constant expressions for static arrays:
 *
 *   static uint8_t memory[DISCMC_EXTRACTOR_BYTES(256, 256, 4000)];
 *
 * Each size includes the object, and suffices on every target. width, height, slots and surfaces:
 * as in the configs of discmc.h. Units: bytes. Arguments may be evaluated more than once. */
#ifndef DISCMC_SIZES_H
#define DISCMC_SIZES_H

#include <limits.h>
#include <stdint.h>

#if INT_MAX < 0x7FFFFFFF
#error "discmc needs an int of at least 32 bits: its integers are promoted to int"
#endif

/* An extractor of a plain kind. slots: at least DISCMC_MIN_SLOTS; see discmc_extractor_config. */
#define DISCMC_EXTRACTOR_BYTES(width, height, slots)                           \
  (26 * sizeof(void*) + 966 + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + \
   UINT64_C(8) * (slots))

/* An extractor of a kind with normals. sample_bytes: 1 for u8, 2 for u16 and i16. */
#define DISCMC_NORMAL_EXTRACTOR_BYTES(width, height, sample_bytes, slots)       \
  (29 * sizeof(void*) + 1032 + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + \
   (UINT64_C(4) * (height) + 6) * ((width) * (sample_bytes) + 2) + UINT64_C(14) * (slots))

/* An encoder of either kind. */
#define DISCMC_ENCODER_BYTES (14 * sizeof(void*) + 983)

/* A slice encoder with any key_slice_interval. With the interval 1, discmc_slice_encoder_bytes() is
 * much less. */
#define DISCMC_SLICE_ENCODER_BYTES(width, height, surfaces)                   \
  (33 * sizeof(void*) + 66 +                                                  \
   DISCMC_BIT_ROW_BYTES_(width, (height) + 3 + ((height) < 2)) * (surfaces) + \
   UINT64_C(1060) * (surfaces))

/* A slice encoder of a kind with fractions, for 2 or 4 levels. sample_bytes: 1 for u8, 2 for u16
 * and i16. */
#define DISCMC_FRACTION_SLICE_ENCODER_BYTES(width, height, surfaces, levels, sample_bytes) \
  (DISCMC_SLICE_ENCODER_BYTES(width, height, surfaces) + 38 * sizeof(void*) + 161 +        \
   DISCMC_FRACTION_BYTES_(width, height, surfaces, levels) +                               \
   (UINT64_C(1) * ((width) + 1) / 2 * (height) + 3) * (surfaces) +                         \
   UINT64_C(1) * (width) * (sample_bytes))

/* The least for a receiver of slices; with more memory, fewer regions arrive as fragments. For a
 * receiver of polygons use DISCMC_RECEIVER_BYTES(1, 1, 1). */
#define DISCMC_RECEIVER_BYTES(width, height, surfaces)                        \
  (101 * sizeof(void*) + 3225 +                                               \
   DISCMC_BIT_ROW_BYTES_(width, (height) + 3 + ((height) < 2)) * (surfaces) + \
   UINT64_C(1060) * (surfaces) + DISCMC_BIT_ROW_BYTES_(width, 2 * (height) + 4) + (width) / 8)

/* The least for a receiver of slices with fractions of this many levels. */
#define DISCMC_FRACTION_RECEIVER_BYTES(width, height, surfaces, levels) \
  (DISCMC_RECEIVER_BYTES(width, height, surfaces) +                     \
   DISCMC_FRACTION_BYTES_(width, height, surfaces, levels) + UINT64_C(2) * (width) + 2)

/* A joiner for this many fragments that wait at once, with eight runs each. */
#define DISCMC_JOINER_BYTES(fragments) (10 * sizeof(void*) + 242 + UINT64_C(192) * (fragments))

/* A checkpoint store for a flash with this program_bytes. */
#define DISCMC_STORE_BYTES(program_bytes) (28 * sizeof(void*) + 127 + (program_bytes))
/* A row ring with its rows. row_bytes: of the samples of one row. */
#define DISCMC_ROW_RING_BYTES(row_bytes, rows) \
  (3 * sizeof(void*) + 42 + UINT64_C(4) * (rows) * (((row_bytes) + UINT64_C(3)) / 4 + 1))

/* Private: fractions of two rows and the slice before, and the probabilities of each surface. */
#define DISCMC_FRACTION_BYTES_(width, height, surfaces, levels)                      \
  ((UINT64_C(4) * (((width) + 5) / 4 * 4) + UINT64_C(2) * ((width) + (height) + 1) + \
    UINT64_C(906) * (levels)-872) *                                                  \
       (surfaces) +                                                                  \
   UINT64_C(4) * (((height) + 31) / 32))

/* Private: rows of bits, 30 voxels per word. */
#define DISCMC_BIT_ROW_BYTES_(width, rows) (UINT64_C(4) * ((width) / 30 + 1) * (rows))

#endif

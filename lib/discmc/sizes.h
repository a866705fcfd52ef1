/* Bytes and capacities of a scan as constant expressions of C, to size static memory with. They are
 * what the functions of capacities.hpp give with 16-bit indices, and those of key_slices.hpp:
 * c_api.cpp, c_slices.cpp and the tests check that.
 *
 *   static uint8_t memory[DISCMC_MINIMUM_BYTES(256, 256) + 32 * 1024];
 *   static const discmc_capacities capacities =
 *       DISCMC_DEFAULT_CAPACITIES(256, 256, sizeof memory);
 *
 * Sizes depend on width and height alone, not on border and slab. An argument may be evaluated more
 * than once. Names that end in an underscore are for this file alone. */
#ifndef DISCMC_SIZES_H
#define DISCMC_SIZES_H

#include <limits.h>
#include <stdint.h>

#if INT_MAX < 0x7FFFFFFF
#error "discmc needs an int of at least 32 bits: its integers are promoted to int"
#endif

/* The least memory with which a scan works. Limit: width and height as in discmc_limits. */
#define DISCMC_MINIMUM_BYTES(width, height) DISCMC_BYTES_FOR(width, height, DISCMC_MINIMUM_RECORDS_)

/* The bytes that a scan with so many records takes from the caller's memory. */
#define DISCMC_BYTES_FOR(width, height, records) \
  (DISCMC_FIXED_BYTES_(width, height) + (records)*DISCMC_RECORD_BYTES_)

/* Initialisers of a discmc_capacities: the least, and those that a number of bytes has room for. */
#define DISCMC_MINIMUM_CAPACITIES \
  { DISCMC_MINIMUM_RECORDS_, 0 }
#define DISCMC_DEFAULT_CAPACITIES(width, height, bytes)    \
  {                                                        \
    DISCMC_DEFAULT_RECORDS_(width, height, bytes),         \
        DISCMC_DEFAULT_RECORDS_(width, height, bytes) / 16 \
  }

/* The bytes that a joiner with room for so many fragments and runs takes, the least, and an
 * initialiser of a discmc_join_capacities: the default split of a number of bytes. */
#define DISCMC_JOINER_BYTES_FOR(fragments, runs) \
  (3 + UINT64_C(96) * (fragments) + UINT64_C(12) * (runs))
#define DISCMC_JOINER_MINIMUM_BYTES DISCMC_JOINER_BYTES_FOR(1, 1)
#define DISCMC_JOINER_DEFAULT_CAPACITIES(bytes)                            \
  {                                                                        \
    DISCMC_JOIN_UNITS_(bytes) == 0 ? 1 : DISCMC_JOIN_UNITS_(bytes),        \
        DISCMC_JOIN_UNITS_(bytes) == 0 ? 1 : 8 * DISCMC_JOIN_UNITS_(bytes) \
  }

/* The bytes that a slice encoder takes, by its interval of key slices, and those of a slice
 * decoder. Limit: surfaces 1 to DISCMC_MAX_SURFACES. */
#define DISCMC_SLICE_ENCODER_BYTES_FOR(width, height, key_slice_interval, surfaces)           \
  (DISCMC_BIT_ROW_BYTES_(width, DISCMC_ROWS_KEPT_(height, key_slice_interval)) * (surfaces) + \
   DISCMC_MODEL_BYTES_ + ((surfaces)-1) * DISCMC_FURTHER_MODEL_BYTES_ + 3)
#define DISCMC_SLICE_DECODER_BYTES_FOR(width, height, surfaces) \
  (DISCMC_SLICE_ENCODER_BYTES_FOR(width, height, 0, surfaces) + UINT64_C(4) * (((width) + 31) / 32))

/* The least memory of a surface decoder for streams of bits. */
#define DISCMC_MINIMUM_SURFACE_BYTES(width, height, surfaces) \
  (DISCMC_SLICE_DECODER_BYTES_FOR(width, height, surfaces) +  \
   DISCMC_FIXED_BYTES_OF_INDEX_(width, height, UINT64_C(4)) + \
   DISCMC_MINIMUM_RECORDS_ * DISCMC_LARGE_RECORD_BYTES_)

/* The same as of a discmc_extractor for one that makes normals, of samples of 1 or 2 bytes, and for
 * one that learns. Kinds of normal extractors for hosts have functions alone. */
#define DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(width, height, sample_bytes) \
  DISCMC_NORMAL_EXTRACTOR_BYTES_FOR(width, height, sample_bytes, DISCMC_MINIMUM_RECORDS_)
#define DISCMC_NORMAL_EXTRACTOR_BYTES_FOR(width, height, sample_bytes, records) \
  (DISCMC_FIXED_BYTES_(width, height) +                                         \
   DISCMC_SAMPLE_ROW_BYTES_(width, DISCMC_NORMAL_ROWS_(height), sample_bytes) + \
   DISCMC_ALIGNED_(DISCMC_NORMAL_ROWS_(height) * 2) +                           \
   DISCMC_ALIGNED_((records)*DISCMC_NORMAL_RECORD_BYTES_))
#define DISCMC_NORMAL_EXTRACTOR_DEFAULT_CAPACITIES(width, height, sample_bytes, bytes) \
  {                                                                                    \
    DISCMC_NORMAL_DEFAULT_RECORDS_(width, height, sample_bytes, bytes),                \
        DISCMC_NORMAL_DEFAULT_RECORDS_(width, height, sample_bytes, bytes) / 16        \
  }
#define DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(width, height) \
  DISCMC_LEARNING_EXTRACTOR_BYTES_FOR(width, height, DISCMC_MINIMUM_RECORDS_)
#define DISCMC_LEARNING_EXTRACTOR_BYTES_FOR(width, height, records) \
  (DISCMC_FIXED_BYTES_OF_INDEX_(width, height, UINT64_C(4)) + (records)*DISCMC_LARGE_RECORD_BYTES_)
#define DISCMC_LEARNING_EXTRACTOR_DEFAULT_CAPACITIES(width, height, bytes) \
  {                                                                        \
    DISCMC_LEARNING_DEFAULT_RECORDS_(width, height, bytes),                \
        DISCMC_LEARNING_DEFAULT_RECORDS_(width, height, bytes) / 16        \
  }

/* The bytes that a sample window takes, for samples of 1 or 2 bytes. */
#define DISCMC_SAMPLE_WINDOW_BYTES_FOR(width, height, sample_bytes) \
  (DISCMC_SAMPLE_ROW_BYTES_(width, UINT64_C(4) * (height), sample_bytes) + 3)

/* The front end: a ring of rows, a majority filter, and means of blocks of `extent` samples each
 * way. */
#define DISCMC_ROW_RING_BYTES_FOR(row_bytes, rows) \
  (UINT64_C(4) * (rows) * (((row_bytes) + UINT64_C(3)) / 4 + 1) + 3)
#define DISCMC_MAJORITY_FILTER_BYTES_FOR(width, height) \
  (UINT64_C(4) * (((width) + 31) / 32) * (2 * (height) + 4) + 3)
#define DISCMC_BLOCK_MEANS_BYTES_FOR(width, height, extent, sample_bytes)         \
  (UINT64_C(4) * DISCMC_BLOCKS_(width, extent) * DISCMC_BLOCKS_(height, extent) + \
   (DISCMC_BLOCKS_(width, extent) * UINT64_C(1) * (sample_bytes) + 3) / 4 * 4 + 3)

/* ---- how they come about ---- */

#define DISCMC_BLOCKS_(voxels, extent) (((voxels) + (extent)-1) / (extent))

#define DISCMC_RECORD_BYTES_ UINT64_C(8)
#define DISCMC_LARGE_RECORD_BYTES_ UINT64_C(16) /* with 32-bit indices */
#define DISCMC_MINIMUM_RECORDS_ 4
#define DISCMC_MOST_RECORDS_ 32759
#define DISCMC_NORMAL_RECORD_BYTES_ UINT64_C(14)

/* So many rows of bits, and one that is off. */
#define DISCMC_BIT_ROW_BYTES_(width, rows) (UINT64_C(4) * ((width) / 30 + 1) * ((rows) + 1))

/* Rows of bits, queues, lists of holes, and alignment. */
#define DISCMC_FIXED_BYTES_(width, height) DISCMC_FIXED_BYTES_OF_INDEX_(width, height, UINT64_C(2))
#define DISCMC_FIXED_BYTES_OF_INDEX_(width, height, index_bytes)                      \
  (DISCMC_BIT_ROW_BYTES_(width, UINT64_C(2) * (height) + 3) + (index_bytes)*2 * 144 + \
   (index_bytes)*16 + 3)

/* Arrays begin at multiples of four bytes. */
#define DISCMC_ALIGNED_(bytes) (((bytes) + 3) / 4 * 4)
#define DISCMC_SAMPLE_ROW_BYTES_(width, rows, sample_bytes) \
  DISCMC_ALIGNED_((rows) * (width) * (sample_bytes))
#define DISCMC_NORMAL_ROWS_(height) (UINT64_C(4) * (height) + 6)

/* The rows that those of a stream of slices are told by, and what is learnt of them. */
#define DISCMC_ROWS_KEPT_(height, key_slice_interval) \
  ((key_slice_interval) == 1 || (height) < 2 ? UINT64_C(4) : UINT64_C(2) + (height))
#define DISCMC_MODEL_BYTES_ UINT64_C(548)
#define DISCMC_FURTHER_MODEL_BYTES_ UINT64_C(1060)

#define DISCMC_AFFORDABLE_RECORDS_(width, height, bytes) \
  ((bytes) < DISCMC_MINIMUM_BYTES(width, height) + 4     \
       ? UINT64_C(0)                                     \
       : ((bytes)-DISCMC_MINIMUM_BYTES(width, height) - 4) / DISCMC_RECORD_BYTES_)
#define DISCMC_DEFAULT_RECORDS_(width, height, bytes)                               \
  (DISCMC_AFFORDABLE_RECORDS_(width, height, bytes) <                               \
           DISCMC_MOST_RECORDS_ - DISCMC_MINIMUM_RECORDS_                           \
       ? DISCMC_MINIMUM_RECORDS_ + DISCMC_AFFORDABLE_RECORDS_(width, height, bytes) \
       : DISCMC_MOST_RECORDS_)

/* The minimum, and what more bytes than its have room for: those that 32 bits count. */
#define DISCMC_SPARE_BYTES_(minimum_bytes, bytes)                           \
  ((bytes) < (minimum_bytes) + 4              ? UINT64_C(0)                 \
   : (bytes) - (minimum_bytes)-4 < UINT32_MAX ? (bytes) - (minimum_bytes)-4 \
                                              : UINT64_C(1) * UINT32_MAX)
#define DISCMC_NORMAL_SPARE_RECORDS_(width, height, sample_bytes, bytes)                   \
  (DISCMC_SPARE_BYTES_(DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(width, height, sample_bytes), \
                       bytes) /                                                            \
   DISCMC_NORMAL_RECORD_BYTES_)
#define DISCMC_NORMAL_DEFAULT_RECORDS_(width, height, sample_bytes, bytes)    \
  (DISCMC_NORMAL_SPARE_RECORDS_(width, height, sample_bytes, bytes) <         \
           DISCMC_MOST_RECORDS_ - DISCMC_MINIMUM_RECORDS_                     \
       ? DISCMC_MINIMUM_RECORDS_ +                                            \
             DISCMC_NORMAL_SPARE_RECORDS_(width, height, sample_bytes, bytes) \
       : DISCMC_MOST_RECORDS_)
#define DISCMC_LEARNING_DEFAULT_RECORDS_(width, height, bytes)                          \
  (DISCMC_MINIMUM_RECORDS_ +                                                            \
   DISCMC_SPARE_BYTES_(DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(width, height), bytes) / \
       DISCMC_LARGE_RECORD_BYTES_)

/* A fragment with eight runs takes 192 bytes. */
#define DISCMC_JOIN_MAX_FRAGMENTS_ (UINT64_C(1) << 28)
#define DISCMC_JOIN_UNITS_(bytes)                                 \
  ((bytes) < 3 ? UINT64_C(0)                                      \
   : (UINT64_C(1) * (bytes)-3) / 192 < DISCMC_JOIN_MAX_FRAGMENTS_ \
       ? (UINT64_C(1) * (bytes)-3) / 192                          \
       : DISCMC_JOIN_MAX_FRAGMENTS_)

#endif

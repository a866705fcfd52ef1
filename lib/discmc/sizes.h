/* Bytes and capacities of a scan as constant expressions of C, to size static memory with. What
 * they mean is said in limits.hpp, whose functions they equal: c_api.cpp and the tests see to that.
 *
 *   static uint8_t memory[DISCMC_MINIMUM_BYTES16(256, 256, DISCMC_CLOSED) + 32 * 1024];
 *   static const discmc_capacities capacities =
 *       DISCMC_DEFAULT_CAPACITIES16(256, 256, DISCMC_CLOSED, sizeof memory);
 *
 * An argument is used more than once. Names that end in an underscore are for this file alone. */
#ifndef DISCMC_SIZES_H
#define DISCMC_SIZES_H

#include <stdint.h>

/* The least memory with which a scan works. Limit: width and height as in discmc_limits. */
#define DISCMC_MINIMUM_BYTES16(width, height, border) \
  DISCMC_MINIMUM_BYTES_(2, width, height, border)
#define DISCMC_MINIMUM_BYTES32(width, height, border) \
  DISCMC_MINIMUM_BYTES_(4, width, height, border)

/* The memory with which no volume ever cuts a region apart, given the worst-case capacities. */
#define DISCMC_WORST_CASE_BYTES16(width, height, border) \
  DISCMC_WORST_CASE_BYTES_(2, width, height, border)
#define DISCMC_WORST_CASE_BYTES32(width, height, border) \
  DISCMC_WORST_CASE_BYTES_(4, width, height, border)

/* The bytes that a scan with these capacities takes from the caller's memory. */
#define DISCMC_BYTES_FOR16(width, height, border, edges, runs, rings, regions, slots) \
  DISCMC_BYTES_FOR_(2, width, height, border, edges, runs, rings, regions, slots)
#define DISCMC_BYTES_FOR32(width, height, border, edges, runs, rings, regions, slots) \
  DISCMC_BYTES_FOR_(4, width, height, border, edges, runs, rings, regions, slots)

/* Initialisers of a discmc_capacities: the least, those of the worst case, and the default split
 * of a number of bytes. */
#define DISCMC_MINIMUM_CAPACITIES \
  { 2, 34, 11, 5, 1 }
#define DISCMC_WORST_CASE_CAPACITIES(width, height, border)                                       \
  {                                                                                               \
    DISCMC_WORST_EDGES_(width, height, border), DISCMC_WORST_RUNS_(width, height, border),        \
        DISCMC_WORST_RINGS_(width, height, border), DISCMC_WORST_REGIONS_(width, height, border), \
        DISCMC_WORST_SLOTS_(width, height, border)                                                \
  }
#define DISCMC_DEFAULT_CAPACITIES16(width, height, border, bytes) \
  DISCMC_DEFAULT_CAPACITIES_(2, width, height, border, bytes)
#define DISCMC_DEFAULT_CAPACITIES32(width, height, border, bytes) \
  DISCMC_DEFAULT_CAPACITIES_(4, width, height, border, bytes)

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

/* ---- how they come about: i is the bytes of an index; w, h, b are width, height, border ---- */

#define DISCMC_JOIN_MAX_FRAGMENTS_ (UINT64_C(1) << 28)
#define DISCMC_JOIN_UNITS_(bytes) \
  ((bytes) < 3 ? UINT64_C(0)      \
               : DISCMC_LESSER_((UINT64_C(1) * (bytes)-3) / 192, DISCMC_JOIN_MAX_FRAGMENTS_))

#define DISCMC_LESSER_(a, b) ((a) < (b) ? (a) : (b))
#define DISCMC_ALIGNED_(bytes) (((bytes) + 3) / 4 * 4)
#define DISCMC_MOST_ UINT64_C(0xFFFFFFFF)

/* The bytes of one record of each kind. */
#define DISCMC_EDGE_BYTES_(i) (4 * (i) + 4)
#define DISCMC_RUN_BYTES_(i) ((i) + 4)
#define DISCMC_RING_BYTES_(i) (2 * (i) + 16)
#define DISCMC_REGION_BYTES_(i) (4 * (i))

#define DISCMC_HALO_(b) ((b) == 0 ? UINT64_C(1) : UINT64_C(0))
#define DISCMC_COLUMNS_(w, b) ((w) + 2 * DISCMC_HALO_(b) - 1)
#define DISCMC_KEYS_(w, h, b) (2 * DISCMC_COLUMNS_(w, b) * DISCMC_COLUMNS_(h, b))
#define DISCMC_ROW_BYTES_(w, b) (((w) + 2 * DISCMC_HALO_(b) + 31) / 32 * 4)

#define DISCMC_BYTES_FOR_(i, w, h, b, edges, runs, rings, regions, slots)                          \
  (3 + DISCMC_ROW_BYTES_(w, b) * ((h) + 3) + DISCMC_ALIGNED_(2 * (i)*DISCMC_COLUMNS_(w, b)) +      \
   UINT64_C(1) * (edges)*DISCMC_EDGE_BYTES_(i) + DISCMC_ALIGNED_(UINT64_C(1) * (edges)) +          \
   DISCMC_ALIGNED_(UINT64_C(1) * (runs)*DISCMC_RUN_BYTES_(i)) +                                    \
   UINT64_C(1) * (rings)*DISCMC_RING_BYTES_(i) + UINT64_C(1) * (regions)*DISCMC_REGION_BYTES_(i) + \
   UINT64_C(4) * (slots) + DISCMC_ALIGNED_(UINT64_C(1) * (slots) * (i)))

#define DISCMC_MINIMUM_BYTES_(i, w, h, b) DISCMC_BYTES_FOR_(i, w, h, b, 2, 34, 11, 5, 1)

#define DISCMC_WORST_EDGES_(w, h, b) (DISCMC_KEYS_(w, h, b) + 4 * DISCMC_COLUMNS_(w, b) + 8)
#define DISCMC_WORST_RUNS_(w, h, b) \
  DISCMC_LESSER_(2 * DISCMC_WORST_EDGES_(w, h, b) + 34, DISCMC_MOST_)
#define DISCMC_WORST_RINGS_(w, h, b) (DISCMC_WORST_EDGES_(w, h, b) + 11)
#define DISCMC_WORST_REGIONS_(w, h, b) \
  DISCMC_LESSER_(2 * DISCMC_WORST_EDGES_(w, h, b) + 5, DISCMC_MOST_)
#define DISCMC_WORST_SLOTS_(w, h, b) \
  (DISCMC_KEYS_(w, h, b) == 0 ? UINT64_C(1) : DISCMC_KEYS_(w, h, b))

#define DISCMC_WORST_CASE_BYTES_(i, w, h, b)                                               \
  DISCMC_BYTES_FOR_(i, w, h, b, DISCMC_WORST_EDGES_(w, h, b), DISCMC_WORST_RUNS_(w, h, b), \
                    DISCMC_WORST_RINGS_(w, h, b), DISCMC_WORST_REGIONS_(w, h, b),          \
                    DISCMC_WORST_SLOTS_(w, h, b))

/* The unit of the default split, how many of them an index can count, and how many the bytes allow.
 */
#define DISCMC_UNIT_BYTES_(i)                                               \
  (16 * (DISCMC_EDGE_BYTES_(i) + UINT64_C(1)) + 20 * DISCMC_RUN_BYTES_(i) + \
   DISCMC_RING_BYTES_(i) + 10 * DISCMC_REGION_BYTES_(i) + 20 * (4 + (i)))
#define DISCMC_COUNTABLE_UNITS_(i) ((((i) == 2 ? UINT64_C(0xFFFF) : DISCMC_MOST_) - 64) / 26)
#define DISCMC_USABLE_BYTES_(i) \
  DISCMC_LESSER_(DISCMC_UNIT_BYTES_(i) * (DISCMC_COUNTABLE_UNITS_(i) + 1) - 1, DISCMC_MOST_)
#define DISCMC_TAKEN_BYTES_(i, w, h, b) (DISCMC_MINIMUM_BYTES_(i, w, h, b) + 7 * 4)
#define DISCMC_UNITS_(i, w, h, b, bytes)                                                      \
  (((bytes) <= DISCMC_TAKEN_BYTES_(i, w, h, b)                                                \
        ? UINT64_C(0)                                                                         \
        : DISCMC_LESSER_((bytes)-DISCMC_TAKEN_BYTES_(i, w, h, b), DISCMC_USABLE_BYTES_(i))) / \
   DISCMC_UNIT_BYTES_(i))

#define DISCMC_DEFAULT_EDGES_(i, w, h, b, bytes) \
  DISCMC_LESSER_(2 + 16 * DISCMC_UNITS_(i, w, h, b, bytes), DISCMC_WORST_EDGES_(w, h, b))
#define DISCMC_DEFAULT_RUNS_(i, w, h, b, bytes) (34 + 20 * DISCMC_UNITS_(i, w, h, b, bytes))
#define DISCMC_DEFAULT_RINGS_(i, w, h, b, bytes) \
  DISCMC_LESSER_(11 + DISCMC_UNITS_(i, w, h, b, bytes), DISCMC_WORST_RINGS_(w, h, b))
#define DISCMC_DEFAULT_REGIONS_(i, w, h, b, bytes) \
  DISCMC_LESSER_(5 + 10 * DISCMC_UNITS_(i, w, h, b, bytes), DISCMC_WORST_REGIONS_(w, h, b))
#define DISCMC_DEFAULT_SLOTS_(i, w, h, b, bytes) \
  DISCMC_LESSER_(1 + 20 * DISCMC_UNITS_(i, w, h, b, bytes), DISCMC_WORST_SLOTS_(w, h, b))

#define DISCMC_DEFAULT_CAPACITIES_(i, w, h, b, bytes)                                         \
  {                                                                                           \
    DISCMC_DEFAULT_EDGES_(i, w, h, b, bytes), DISCMC_DEFAULT_RUNS_(i, w, h, b, bytes),        \
        DISCMC_DEFAULT_RINGS_(i, w, h, b, bytes), DISCMC_DEFAULT_REGIONS_(i, w, h, b, bytes), \
        DISCMC_DEFAULT_SLOTS_(i, w, h, b, bytes)                                              \
  }

#endif

/* discmc for C99, between the sensor and the extractor: a ring of rows, and the unpacking of
 * samples. The header discmc.h describes objects, errors and calls. */
#ifndef DISCMC_FRONT_H
#define DISCMC_FRONT_H

#include <discmc/discmc.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- row ring: an interrupt fills rows in place, a task pushes them from there ---- */
typedef struct discmc_row_ring discmc_row_ring;
/* Rows lie one after the other from the beginning of the memory, each aligned to four bytes. */
typedef struct discmc_row_ring_config {
  uint32_t row_bytes, rows;
  discmc_memory memory; /* DISCMC_ROW_RING_BYTES(row_bytes, rows) */
} discmc_row_ring_config;
/* Starts an empty ring. Limit: neither side is active. Errors: DISCMC_BAD_CAPACITIES. */
DISCMC_CHECK discmc_status discmc_row_ring_start(discmc_row_ring** ring,
                                                 const discmc_row_ring_config* config);

/* Interrupt: the row to fill next, or the one `ahead` rows later; null if there is no room. */
void* discmc_row_ring_free_row(const discmc_row_ring* ring, uint32_t ahead);
/* Interrupt: marks the free row as filled. Limit: there is a free row. */
void discmc_row_ring_commit(discmc_row_ring* ring);
/* Interrupt: records rows lost before the free row. Returns all rows so far, modulo 2^32. */
uint32_t discmc_row_ring_drop(discmc_row_ring* ring, uint32_t rows);
/* Interrupt: no row follows. */
void discmc_row_ring_end(discmc_row_ring* ring);

/* Task: the next row, or the end. */
enum { DISCMC_ROW_NONE /* yet */, DISCMC_ROW_READY, DISCMC_ROW_LOST, DISCMC_ROW_END };
/* The result of peek(): a row, or the reason why there is none. */
typedef struct discmc_row {
  uint8_t kind;
  void* samples;   /* if ready; may be changed in place; Owner: the ring, until pop() */
  uint32_t number; /* filled and lost rows before it, modulo 2^32 */
} discmc_row;
discmc_row discmc_row_ring_peek(const discmc_row_ring* ring);
/* Task: removes a row that is ready or lost. */
void discmc_row_ring_pop(discmc_row_ring* ring);

/* ---- packed samples: 10 and 12 bits, byte for byte in packed_samples.hpp ---- */
enum { DISCMC_RAW10, DISCMC_RAW12 /* MIPI CSI-2 */, DISCMC_MONO10P, DISCMC_MONO12P };
enum { DISCMC_MONO10PMSB = 4, DISCMC_MONO12PMSB, DISCMC_MONO12_PACKED /* GenICam */ };

/* The bytes of this many samples, in whole groups. Limit: count <= 2^31. */
uint32_t discmc_packed_bytes(uint8_t packing, uint32_t count);
/* Unpacks a row; samples: at `packed` or without overlap. Cost: 7 to 14 instructions per sample. */
void discmc_unpack(uint8_t packing, const uint8_t* packed, uint32_t count, uint16_t* samples);

#ifdef __cplusplus
}
#endif

#endif

/* discmc for C: the whole library, C99, linked by the C linker.
 *
 *   discmc_encoder_start, discmc_extractor16_start      once
 *   discmc_extractor16_push_u8                          as often as samples arrive
 *   discmc_extractor16_resume                           after DISCMC_MORE, when the sink may take
 * again discmc_extractor16_finish                           after the last slice
 *
 * Names and meanings are those of the C++ headers, which say more where a reference is given.
 * Objects are opaque and lie in your memory. They must be zero before they are first used, as
 * static ones are, and `= {{0}}` makes others. They may be copied and forgotten at any time;
 * nothing has to be released. Nothing is shared between objects, and no function has static state.
 *
 * Pointers must not be null except where that is said. Every function is for one context at a time:
 * see ports/README.md for interrupts. Coordinates are in half-steps: voxel (i, j, k) lies at
 * (2i, 2j, 2k). */
#ifndef DISCMC_H
#define DISCMC_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifdef __GNUC__
#define DISCMC_NODISCARD __attribute__((warn_unused_result))
#else
#define DISCMC_NODISCARD
#endif

/* ---- status (status.hpp) ---- */

/* What a call came to. DISCMC_OK and DISCMC_MORE are not errors: DISCMC_MORE means that the sink
 * said "not now" and the work goes on with ..._resume(). After an error nothing has changed and
 * nothing was delivered; only a start that finds too little memory also ends a scan that was under
 * way. */
typedef uint8_t discmc_status;
enum {
  DISCMC_OK,
  DISCMC_MORE,              /* suspended by the sink; nothing is lost */
  DISCMC_BAD_LIMITS,        /* width or height is 0 or above DISCMC_MAX_EXTENT */
  DISCMC_BAD_CAPACITIES,    /* below the minimum, or beyond what the index can count */
  DISCMC_TOO_LITTLE_MEMORY, /* smaller than the limits or capacities need, or null */
  DISCMC_BAD_SINK,          /* the sink has no function */
  DISCMC_NOT_STARTED,       /* ..._start() has not succeeded yet */
  DISCMC_FINISHED,          /* only ..._reset() or ..._start() go on from here */
  DISCMC_ROW_IN_PROGRESS,   /* a whole row was given or skipped in the middle of a row */
  DISCMC_SLICE_IN_PROGRESS, /* finish in the middle of a slice */
  DISCMC_TOO_DEEP,          /* z coordinates are exhausted; finish still works */
  DISCMC_WRONG_VERSION      /* the stream's version is not known to this decoder */
};

/* A short English text for a status. Owner: static storage. */
const char* discmc_text(discmc_status status);

/* ---- limits and memory (limits.hpp) ---- */

enum { DISCMC_MAX_EXTENT = 32766 };

/* What lies around the volume: a halo of off voxels, which closes the surface, or nothing. */
enum { DISCMC_CLOSED, DISCMC_OPEN };

/* The size of a slice. The number of slices is not limited by memory. */
typedef struct discmc_limits {
  uint32_t width;  /* voxels a row; Limit: 1 to DISCMC_MAX_EXTENT */
  uint32_t height; /* rows a slice; likewise */
  uint8_t border;  /* DISCMC_CLOSED or DISCMC_OPEN */
} discmc_limits;

/* How many records of each kind there is room for. A shortage costs merging, never correctness. */
typedef struct discmc_capacities {
  uint32_t edges, runs, rings, regions, slots;
} discmc_capacities;

/* A piece of memory. Owner: the caller. */
typedef struct discmc_memory {
  void* data;
  size_t bytes;
} discmc_memory;

/* The least memory with which a scan works, for the size of a static array: every surface comes out
 * right, not merged beyond cells. More merges better. 16 and 32 are the bits of an index. */
#define DISCMC_MINIMUM_BYTES16(width, height, border) \
  (DISCMC_ROWS_BYTES(width, height, border) + 4u * ((width) + DISCMC_HALO(border) - 1u) + 503u)
#define DISCMC_MINIMUM_BYTES32(width, height, border) \
  (DISCMC_ROWS_BYTES(width, height, border) + 8u * ((width) + DISCMC_HALO(border) - 1u) + 671u)

/* Parts of the above. */
#define DISCMC_HALO(border) ((border) == DISCMC_CLOSED ? 2u : 0u)
#define DISCMC_ROWS_BYTES(width, height, border) \
  (4u * (((width) + DISCMC_HALO(border) + 31u) / 32u) * ((height) + 3u))

/* The same as functions, the bytes for any capacities, and those for the worst case: with the
 * memory of discmc_worst_case_bytesN() and discmc_worst_case_capacities() no volume ever cuts a
 * region apart. Limit: the limits are valid. */
uint64_t discmc_minimum_bytes16(const discmc_limits* limits);
uint64_t discmc_minimum_bytes32(const discmc_limits* limits);
uint64_t discmc_bytes_for16(const discmc_limits* limits, const discmc_capacities* capacities);
uint64_t discmc_bytes_for32(const discmc_limits* limits, const discmc_capacities* capacities);
uint64_t discmc_worst_case_bytes16(const discmc_limits* limits);
uint64_t discmc_worst_case_bytes32(const discmc_limits* limits);
discmc_capacities discmc_minimum_capacities(void);
discmc_capacities discmc_worst_case_capacities(const discmc_limits* limits);

/* The default split of a number of bytes, the same on every machine. */
discmc_capacities discmc_default_capacities16(const discmc_limits* limits, uint64_t bytes);
discmc_capacities discmc_default_capacities32(const discmc_limits* limits, uint64_t bytes);

/* ---- events and sinks (sink.hpp) ---- */

/* A point of the lattice. Units: half-steps. */
typedef struct discmc_vertex {
  int32_t x, y, z;
} discmc_vertex;

/* A straight run of equal links, or a stand-in for a fragment sent before: see discmc_run_length()
 * and its neighbours. */
typedef uint32_t discmc_run;

/* Totals of a scan so far. All counts are exact. */
typedef struct discmc_statistics {
  uint64_t cells;             /* active cells swept */
  uint64_t facets;            /* before merging */
  uint64_t classic_triangles; /* what classic Marching Cubes would have made */
  uint64_t regions;           /* delivered */
  uint64_t rings;             /* delivered */
  uint64_t links;             /* of all chains, delivered */
  uint64_t cuts;              /* links made boundary for lack of memory */
  uint64_t spills;            /* fragments sent early for lack of memory */
  uint64_t skipped_rows;
} discmc_statistics;

/* The kinds of events, in the grammar that sink.hpp gives. */
enum {
  DISCMC_REGION,       /* a complete region begins: incidence */
  DISCMC_RING,         /* one of its rings begins: start, hole */
  DISCMC_RUN,          /* the next run of the ring or fragment: run */
  DISCMC_REGION_END,   /* the region is complete */
  DISCMC_FRAGMENT,     /* a part of an open ring, sent early: number, incidence */
  DISCMC_FRAGMENT_END, /* the fragment is complete */
  DISCMC_SKIPPED,      /* a row never came: slice, row, repeated */
  DISCMC_LAYER,        /* every region that does not reach `slice` has been delivered */
  DISCMC_FINISH,       /* the last event: slice (how many slices), abandoned, statistics */
  DISCMC_LOST          /* decoder only: part of the region or fragment just begun is lost */
};

/* One thing that a sink is offered. Only the members that its kind names have a meaning. Flags are
 * 0 or 1. */
typedef struct discmc_event {
  uint8_t kind;
  uint8_t incidence; /* 13 + x + 3 y + 9 z of the normal's signs: see discmc_normal() */
  uint8_t hole;
  uint8_t repeated;
  uint8_t abandoned;
  discmc_run run;
  uint32_t number;
  uint32_t slice;
  uint32_t row;
  discmc_vertex start;
  const discmc_statistics* statistics; /* Owner: the sender; valid during the call */
} discmc_event;

/* What a sink answers. What it did not take is offered again, unchanged, on the next resume. */
typedef uint8_t discmc_answer;
enum { DISCMC_TAKEN, DISCMC_NOT_NOW };

/* Where events go. Owner: the sink and its context are the caller's and must outlive the scan. */
typedef struct discmc_sink {
  void* context;
  discmc_answer (*take)(void* context, const discmc_event* event);
  uint8_t takes_fragments; /* 0: a lack of memory is answered by cuts instead of spills */
} discmc_sink;

/* ---- the extractor (extractor.hpp) ---- */

/* What a push came to, and how many of the samples it took. The rest must be pushed again. */
typedef struct discmc_pushed {
  discmc_status status;
  uint32_t samples;
} discmc_pushed;

/* High-water marks of the pools, in records. */
typedef struct discmc_high_water {
  uint32_t edges, runs, rings, regions, slots;
} discmc_high_water;

/* What stands in for a row that never came. */
enum { DISCMC_OFF, DISCMC_PREVIOUS_ROW };

/* With indices of 16 bits (fewer than 65,535 records of a kind; firmware) and of 32 (hosts). The
 * events do not depend on the width, given the same capacities. */
typedef struct discmc_extractor16 {
  uint64_t opaque[(sizeof(void*) == 8 ? 720 : 640) / 8];
} discmc_extractor16;
typedef struct discmc_extractor32 {
  uint64_t opaque[(sizeof(void*) == 8 ? 960 : 864) / 8];
} discmc_extractor32;

/* Begins a scan; a voxel is on where its sample is >= threshold. capacities: may be null, for the
 * default split of the memory. memory: Owner: the caller, for as long as the scan lasts. Errors:
 * DISCMC_BAD_LIMITS, DISCMC_BAD_CAPACITIES, DISCMC_BAD_SINK, DISCMC_TOO_LITTLE_MEMORY; then the
 * memory is untouched. */
DISCMC_NODISCARD discmc_status discmc_extractor16_start(discmc_extractor16* extractor,
                                                        const discmc_limits* limits,
                                                        const discmc_capacities* capacities,
                                                        int32_t threshold, discmc_memory memory,
                                                        const discmc_sink* sink);

/* Begins the next scan with the limits, threshold, memory and sink of the last start. */
DISCMC_NODISCARD discmc_status discmc_extractor16_reset(discmc_extractor16* extractor);

/* Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
 * samples: Owner: the caller; free again when the call returns. stride: from one sample to the
 * next, in samples; 1 for samples in a row. With DISCMC_MORE all samples up to the end of the row
 * that caused it have been taken. Errors: DISCMC_NOT_STARTED, DISCMC_FINISHED, DISCMC_TOO_DEEP. */
DISCMC_NODISCARD discmc_pushed discmc_extractor16_push_u8(discmc_extractor16* extractor,
                                                          const uint8_t* samples, uint32_t count,
                                                          uint32_t stride);
DISCMC_NODISCARD discmc_pushed discmc_extractor16_push_u16(discmc_extractor16* extractor,
                                                           const uint16_t* samples, uint32_t count,
                                                           uint32_t stride);
DISCMC_NODISCARD discmc_pushed discmc_extractor16_push_i16(discmc_extractor16* extractor,
                                                           const int16_t* samples, uint32_t count,
                                                           uint32_t stride);

/* Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0. Errors:
 * as a push, DISCMC_ROW_IN_PROGRESS. The samples taken are the width, or 0. */
DISCMC_NODISCARD discmc_pushed discmc_extractor16_push_bits(discmc_extractor16* extractor,
                                                            const uint8_t* bits);

/* Stands in for a row that never came; the sink is told. substitute: DISCMC_OFF or
 * DISCMC_PREVIOUS_ROW. Result and errors: as push_bits. */
DISCMC_NODISCARD discmc_pushed discmc_extractor16_skip_row(discmc_extractor16* extractor,
                                                           uint8_t substitute);

/* Goes on after DISCMC_MORE. Also harmless at any other time. */
DISCMC_NODISCARD discmc_status discmc_extractor16_resume(discmc_extractor16* extractor);

/* Ends the scan: delivers every region and the totals. After DISCMC_MORE go on with resume. Errors:
 * DISCMC_NOT_STARTED, DISCMC_SLICE_IN_PROGRESS. */
DISCMC_NODISCARD discmc_status discmc_extractor16_finish(discmc_extractor16* extractor);

/* Ends the scan wherever it is: the rest of the slice is taken as off, and the sink is told.
 * Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_extractor16_abandon(discmc_extractor16* extractor);

/* Totals so far; what the last start came to; the bytes of the memory in use at all; complete
 * slices so far, and complete rows of the current one. */
discmc_statistics discmc_extractor16_statistics(const discmc_extractor16* extractor);
discmc_limits discmc_extractor16_limits(const discmc_extractor16* extractor);
discmc_capacities discmc_extractor16_capacities(const discmc_extractor16* extractor);
discmc_high_water discmc_extractor16_high_water(const discmc_extractor16* extractor);
size_t discmc_extractor16_bytes_used(const discmc_extractor16* extractor);
uint32_t discmc_extractor16_slices(const discmc_extractor16* extractor);
uint32_t discmc_extractor16_rows(const discmc_extractor16* extractor);

/* The same with indices of 32 bits. */
DISCMC_NODISCARD discmc_status discmc_extractor32_start(discmc_extractor32* extractor,
                                                        const discmc_limits* limits,
                                                        const discmc_capacities* capacities,
                                                        int32_t threshold, discmc_memory memory,
                                                        const discmc_sink* sink);
DISCMC_NODISCARD discmc_status discmc_extractor32_reset(discmc_extractor32* extractor);
DISCMC_NODISCARD discmc_pushed discmc_extractor32_push_u8(discmc_extractor32* extractor,
                                                          const uint8_t* samples, uint32_t count,
                                                          uint32_t stride);
DISCMC_NODISCARD discmc_pushed discmc_extractor32_push_u16(discmc_extractor32* extractor,
                                                           const uint16_t* samples, uint32_t count,
                                                           uint32_t stride);
DISCMC_NODISCARD discmc_pushed discmc_extractor32_push_i16(discmc_extractor32* extractor,
                                                           const int16_t* samples, uint32_t count,
                                                           uint32_t stride);
DISCMC_NODISCARD discmc_pushed discmc_extractor32_push_bits(discmc_extractor32* extractor,
                                                            const uint8_t* bits);
DISCMC_NODISCARD discmc_pushed discmc_extractor32_skip_row(discmc_extractor32* extractor,
                                                           uint8_t substitute);
DISCMC_NODISCARD discmc_status discmc_extractor32_resume(discmc_extractor32* extractor);
DISCMC_NODISCARD discmc_status discmc_extractor32_finish(discmc_extractor32* extractor);
DISCMC_NODISCARD discmc_status discmc_extractor32_abandon(discmc_extractor32* extractor);
discmc_statistics discmc_extractor32_statistics(const discmc_extractor32* extractor);
discmc_limits discmc_extractor32_limits(const discmc_extractor32* extractor);
discmc_capacities discmc_extractor32_capacities(const discmc_extractor32* extractor);
discmc_high_water discmc_extractor32_high_water(const discmc_extractor32* extractor);
size_t discmc_extractor32_bytes_used(const discmc_extractor32* extractor);
uint32_t discmc_extractor32_slices(const discmc_extractor32* extractor);
uint32_t discmc_extractor32_rows(const discmc_extractor32* extractor);

/* ---- the encoder (encoder.hpp) ---- */

/* What a stream says of its scan. */
typedef struct discmc_stream_header {
  uint32_t width, height;
  uint32_t depth;        /* planned slices; 0 when not known */
  int32_t spacing_nm[3]; /* between voxels; negative for a mirrored axis; 0 unknown */
  int32_t threshold;     /* a voxel is on where its sample is >= threshold */
  uint8_t border;        /* DISCMC_CLOSED or DISCMC_OPEN */
} discmc_stream_header;

/* Where bytes go. Owner: the context is the caller's. */
typedef struct discmc_byte_output {
  void* context;
  /* Takes up to `count` bytes and returns how many it took; 0 means "not now". */
  size_t (*write)(void* context, const uint8_t* bytes, size_t count);
} discmc_byte_output;

typedef struct discmc_encoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 880 : 832) / 8];
} discmc_encoder;

/* Begins a stream; its header is the first packet. Errors: DISCMC_BAD_LIMITS, DISCMC_BAD_SINK (no
 * write). */
DISCMC_NODISCARD discmc_status discmc_encoder_start(discmc_encoder* encoder,
                                                    const discmc_stream_header* header,
                                                    discmc_byte_output output);

/* Takes an event; encoder points to a discmc_encoder, so that this is the `take` of a sink whose
 * context is one: {&encoder, discmc_encoder_take, 1}. */
discmc_answer discmc_encoder_take(void* encoder, const discmc_event* event);

/* Hands over what is there so far instead of waiting for a full packet. 0 when the output does not
 * take all of it now: call again. */
DISCMC_NODISCARD uint8_t discmc_encoder_flush(discmc_encoder* encoder);

/* The bytes that the output has taken so far. */
uint64_t discmc_encoder_bytes(const discmc_encoder* encoder);

/* ---- the decoder (decoder.hpp) ---- */

/* How a stream arrived. Lost counts grow when the next whole packet tells of the gap. Flags are 0
 * or 1. */
typedef struct discmc_stream_report {
  uint8_t has_header, has_trailer;
  uint8_t abandoned;     /* the scan was ended before its time; the surface is closed */
  uint8_t is_unreadable; /* a packet was whole, but its records are of no known kind */
  uint8_t is_complete;   /* nothing is missing from header to trailer */
  uint64_t bytes;
  uint64_t packets; /* whole ones, repeated ones not counted */
  uint64_t repeated_packets;
  uint64_t damaged_packets; /* frames that are no packet, or fail their checksum */
  uint64_t lost_packets;    /* missing by their numbers */
  uint64_t regions;         /* delivered complete */
  uint64_t lost_regions;    /* missing by the running count of regions */
  uint32_t slices;          /* of the trailer */
  discmc_statistics totals; /* of the trailer */
} discmc_stream_report;

/* What a push came to, and how many of the bytes it took. The rest must be pushed again. */
typedef struct discmc_decoded {
  discmc_status status;
  size_t bytes;
} discmc_decoded;

typedef struct discmc_decoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 1088 : 1040) / 8];
} discmc_decoder;

/* Begins a stream. The sink must outlive it. Errors: DISCMC_BAD_SINK. */
DISCMC_NODISCARD discmc_status discmc_decoder_start(discmc_decoder* decoder,
                                                    const discmc_sink* sink);

/* Takes bytes, any number at a time. DISCMC_MORE: the sink said "not now", push the rest again.
 * DISCMC_WRONG_VERSION: nothing more of this stream is delivered. Errors: also DISCMC_NOT_STARTED.
 * Any bytes are safe. */
DISCMC_NODISCARD discmc_decoded discmc_decoder_push(discmc_decoder* decoder, const uint8_t* bytes,
                                                    size_t count);

/* Tells that no byte follows: an unfinished region is reported lost. DISCMC_MORE as a push. */
DISCMC_NODISCARD discmc_status discmc_decoder_finish(discmc_decoder* decoder);

discmc_stream_header discmc_decoder_header(const discmc_decoder* decoder);
discmc_stream_report discmc_decoder_report(const discmc_decoder* decoder);

/* ---- chains (lattice.hpp, chain.hpp) ---- */

/* A straight run. Limit: length 1 to 2^28 - 1 links, direction below discmc_direction_count(). */
discmc_run discmc_run_straight(uint8_t direction, uint32_t length);
/* Whether a run stands for a fragment, and for which; else its direction and its length in links.
 */
uint8_t discmc_run_is_fragment(discmc_run run);
uint32_t discmc_run_fragment_number(discmc_run run);
uint8_t discmc_run_direction(discmc_run run);
uint32_t discmc_run_length(discmc_run run);

/* A region's normal, as signs; it points from on to off. */
discmc_vertex discmc_normal(uint8_t incidence);
/* How many directions the planes of an incidence have, and the vector of one. */
uint8_t discmc_direction_count(uint8_t incidence);
discmc_vertex discmc_direction_vector(uint8_t incidence, uint8_t direction);

/* The chain's end relative to its start. Limit, here and below: straight runs only. */
discmc_vertex discmc_displacement(uint8_t incidence, const discmc_run* runs, uint32_t count);
/* Turns the chain round in place. */
void discmc_reverse(uint8_t incidence, discmc_run* runs, uint32_t count);
/* Twice the area of a closed chain times the length of its incidence's normal: positive for an
 * outer ring, negative for a hole. Units: square half-steps. */
int64_t discmc_twice_area(uint8_t incidence, const discmc_run* runs, uint32_t count);
/* The links of a chain, and so the vertices of a closed one. */
uint64_t discmc_link_count(const discmc_run* runs, uint32_t count);

/* ---- polygons (polygon.hpp) ---- */

/* Writes the vertices of a closed chain, one for every link, beginning with the start. vertices:
 * discmc_link_count() of them; Owner: the caller. */
void discmc_unfold(uint8_t incidence, discmc_vertex start, const discmc_run* runs, uint32_t count,
                   discmc_vertex* vertices);

/* Who is handed simple rings: of three vertices or more, valid during the call. */
typedef struct discmc_ring_receiver {
  void* context;
  void (*take)(void* context, const discmc_vertex* vertices, uint32_t count);
} discmc_ring_receiver;

/* Splits a closed ring of vertices into simple rings and hands them over. vertices: is used up.
 * scratch: 2 * count words. Owner: the caller. Cost: count * log(count) comparisons. */
void discmc_split_ring(discmc_vertex* vertices, uint32_t count, uint32_t* scratch,
                       const discmc_ring_receiver* receiver);

/* Keeps, in order and in place, the corners of a ring and every vertex that keep() returns not 0
 * for; returns how many. keep: may be null. */
uint32_t discmc_keep_corners(discmc_vertex* vertices, uint32_t count,
                             uint8_t (*keep)(void* context, const discmc_vertex* vertex),
                             void* context);

#ifdef __cplusplus
}
#endif

#endif

/* discmc for C99: the surface of a 3D scan as polygons, extracted while the scan runs.
 *
 *   samples -> extractor -> encoder -> your link    polygons: the receiver only draws
 *   samples -> slice encoder -> your link           thresholded slices: a tenth of the bytes
 *   your link -> receiver -> joiner -> your sink    polygons from a stream of either kind
 *
 * Programs: examples/firmware.c sends polygons, slices.c sends slices, receive.c receives both.
 *
 * Objects. An object lies in the memory of its config, which may have any alignment, and uses all
 * of it. start() copies the config and overwrites the memory. On success it sets the pointer to the
 * object; after an error the memory holds no object. Do not move memory or contexts while the
 * object is in use. Nothing has to be released. Leave unused config members zero. bytes() returns
 * the least memory for start(); sizes.h has upper bounds for static arrays.
 *
 * Checkpoints. save() sets `part` to the first bytes of the object's memory, which are its complete
 * state. Copy them before the next call of the object. An encoder is suspended until its output has
 * no unsent bytes. restore() continues from a copy at the beginning of the config's memory, and
 * reads only kind, memory, and sink or output of the config. The build must be the same, and the
 * address modulo 8. Cost: about 50 instructions per byte.
 *
 * Errors. start() and restore() can return DISCMC_NO_KIND, DISCMC_TOO_LITTLE_MEMORY and
 * DISCMC_BAD_SINK, restore() also DISCMC_BAD_CHECKPOINT. Comments list all others; docs/statuses.md
 * has remedies. After another error the object continues as if not called, but sent its events.
 *
 * Calls. Call an object from one thread or interrupt at a time. Objects share nothing. Your
 * functions run within calls of the object that has them. They must not jump out of the call, nor
 * call an object that is calling them. Pointers must not be null unless a comment allows it. Flags
 * are 0 or 1. A Limit in a comment is not checked: keep it. Owner: who owns the memory behind a
 * pointer. front.h has the row ring and unpackers; C++ also has filters and polygon arithmetic. */
#ifndef DISCMC_H
#define DISCMC_H

#include <discmc/sizes.h>
#include <discmc/version.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__) && !defined(DISCMC_FORCE_PORTABLE)
#define DISCMC_CHECK __attribute__((warn_unused_result))
#else
#define DISCMC_CHECK
#endif

/* ---- status: the result of a call; DISCMC_SUSPENDED is not an error ---- */
typedef uint8_t discmc_status;
enum {
  DISCMC_OK,
  DISCMC_SUSPENDED,         /* the sink or output is busy: resume(), or call again */
  DISCMC_BAD_LIMITS,        /* see discmc_limits and slab */
  DISCMC_BAD_CAPACITIES,    /* too few slots, or more than the kind counts; no rows */
  DISCMC_TOO_LITTLE_MEMORY, /* less than bytes(), or null */
  DISCMC_BAD_SINK,          /* no function; a sink that has not started; a bad max_frame */
  DISCMC_NOT_STARTED,       /* an encoder that has not received the start of a scan */
  DISCMC_FINISHED,          /* the scan has ended: start another */
  DISCMC_ROW_IN_PROGRESS,   /* a whole row was pushed or skipped in the middle of a row */
  DISCMC_SLICE_IN_PROGRESS, /* finish() in the middle of a slice: complete it, or abandon() */
  DISCMC_TOO_MANY_SLICES,   /* the scan has DISCMC_MAX_SLICES; finish() still works */
  DISCMC_WRONG_VERSION,     /* this receiver does not support the version of the stream */
  DISCMC_BAD_CHECKPOINT,    /* damaged, or saved by another build or kind */
  DISCMC_BAD_LABEL,         /* the channel is too high; surface_count; levels */
  DISCMC_BAD_RECORD,        /* an application record is too long */
  DISCMC_BAD_DEVICE,        /* a flash without functions, or without room for two checkpoints */
  DISCMC_DEVICE_ERROR,      /* a flash function failed, or a unit reads back with other bytes */
  DISCMC_BAD_SAMPLES,       /* a type that the kind does not accept, or bits that are not one row */
  DISCMC_NO_KIND            /* the kind in the config is null */
};

/* A short English text. Owner: static storage. */
const char* discmc_status_string(discmc_status status);

/* ---- shared types ---- */
typedef struct discmc_extractor discmc_extractor;
typedef struct discmc_encoder discmc_encoder;
typedef struct discmc_slice_encoder discmc_slice_encoder;
typedef struct discmc_receiver discmc_receiver;
typedef struct discmc_joiner discmc_joiner;
typedef struct discmc_store discmc_store;

typedef struct discmc_memory {
  void* data;
  size_t bytes;
} discmc_memory;

/* The size of a slice. Memory does not depend on the number of slices. */
typedef struct discmc_limits {
  uint32_t width;  /* voxels per row, 1 to DISCMC_MAX_EXTENT */
  uint32_t height; /* rows per slice, likewise */
  uint8_t border;  /* DISCMC_CLOSED or DISCMC_OPEN */
} discmc_limits;
enum { DISCMC_CLOSED /* off voxels around the volume close its surface */, DISCMC_OPEN };
enum { DISCMC_MAX_EXTENT = 32766, DISCMC_MAX_SLICES = 1073741823 };

/* Bits are rows that you thresholded: eight voxels per byte, the first in bit 0. */
typedef uint8_t discmc_sample_type;
enum { DISCMC_BITS, DISCMC_U8, DISCMC_U16, DISCMC_I16 };

/* The replacement of a missing row: off voxels, or the previous row (off if there is none). */
enum { DISCMC_SUBSTITUTE_OFF, DISCMC_SUBSTITUTE_PREVIOUS_ROW };

/* The result of a push. Push again only the samples or bytes that were not accepted. */
typedef struct discmc_push_result {
  discmc_status status;
  size_t accepted; /* samples; of a whole row the width or 0; for a receiver bytes */
} discmc_push_result;

/* The output of an encoder. write() accepts up to `count` bytes, valid during the call, and returns
 * how many: 0 if busy, or on an error. It is offered the rest of one frame. If the link is dead,
 * call set_output(). unsent(), for checkpoints: the accepted bytes that a power failure loses. */
typedef struct discmc_byte_output {
  void* context;
  size_t (*write)(void* context, const uint8_t* bytes, size_t count);
  size_t (*unsent)(void* context);
  uint16_t max_frame; /* of regions or slices: 48 to DISCMC_MAX_FRAME, or 0 for the latter */
} discmc_byte_output;
enum { DISCMC_WIRE_VERSION = 1, DISCMC_MAX_FRAME = 256 /* bytes of a stream's longest frame */ };

/* Your description of a scan, for the header of its stream. */
typedef struct discmc_stream_label {
  uint32_t depth;        /* planned slices; 0 if unknown */
  int32_t spacing_nm[3]; /* between voxels along x, y, z; negative if mirrored; 0 if unknown */
  uint16_t scan;         /* a number that no other scan on the link has */
  uint8_t channel;       /* distinguishes surfaces on one link, 0 to DISCMC_MAX_CHANNEL */
} discmc_stream_label;
enum { DISCMC_MAX_CHANNEL = 63, DISCMC_ANY_CHANNEL = 255, DISCMC_MAX_SURFACES = 4 };

/* Your own data in a stream: a time stamp, a pose. A record costs 22 bytes beyond its data. */
typedef struct discmc_application_record {
  uint8_t kind;         /* yours; Limit: below DISCMC_FIRST_STANDARD_KIND */
  uint32_t slice, row;  /* complete slices so far, and complete rows of the next */
  const uint8_t* bytes; /* Owner: the caller; free again when the call returns */
  size_t count;         /* at most DISCMC_MAX_RECORD_BYTES */
} discmc_application_record;
enum { DISCMC_MAX_RECORD_BYTES = 200, DISCMC_FIRST_STANDARD_KIND = 240 };

/* ---- events of extractors and receivers ---- */
/* Events come in this order:
 *
 *   scan     = START { region | fragment | SKIPPED | LAYER | APPLICATION | FRACTIONS } FINISH
 *   region   = REGION { RING { RUN } } REGION_END       the outer ring first, then the holes
 *   fragment = FRAGMENT { RUN } FRAGMENT_END
 *
 * A region is a merged polygon. A fragment is a loose piece of a ring, which was sent early for
 * lack of memory, or at the seam of a slab. Put a joiner before a sink that needs whole regions. */
enum {
  DISCMC_START,  /* of.header; from an extractor without depth, scan and channel */
  DISCMC_REGION, /* incidence */
  DISCMC_RING,   /* start, is_hole */
  DISCMC_RUN,    /* run, normal */
  DISCMC_REGION_END,
  DISCMC_FRAGMENT, /* incidence, start, incoming_direction */
  DISCMC_FRAGMENT_END,
  DISCMC_SKIPPED,     /* slice, row, is_repeated: a row is missing */
  DISCMC_LAYER,       /* slice: complete; regions that do not reach it have been delivered */
  DISCMC_APPLICATION, /* of.application; from receivers only */
  DISCMC_FINISH,      /* slice: the number of slices; is_abandoned, of.statistics */
  DISCMC_LOST,        /* discard the region or fragment that has begun; from receivers only */
  DISCMC_FRACTIONS    /* slice, row, of.fractions; from receivers only, before their vertices */
};

/* A point. Units: half-steps; voxel (i, j, k) lies at (2i, 2j, 2k). */
typedef struct discmc_vertex {
  int32_t x, y, z;
} discmc_vertex;

typedef struct discmc_statistics {
  uint64_t cells, facets;     /* active cells, and facets in them, before the merge */
  uint64_t classic_triangles; /* that classic Marching Cubes would have made */
  uint64_t regions, rings;    /* delivered, and the rings of these regions */
  uint64_t links;             /* the length of all runs delivered */
  uint64_t fragments;         /* delivered */
  uint64_t skipped_rows;
} discmc_statistics;

/* The header of a stream; see discmc_stream_label. */
typedef struct discmc_stream_header {
  uint32_t width, height, depth;
  int32_t spacing_nm[3];
  int32_t thresholds[4]; /* of each surface */
  uint8_t border;
  uint8_t channel; /* of the first surface */
  uint16_t scan;
  uint8_t surface_count; /* 1, or up to DISCMC_MAX_SURFACES in a stream of slices */
  uint8_t levels;        /* of the fractions in a stream of slices: 2 or 4, or 0 without them */
} discmc_stream_header;

/* One event. Only the members that its kind names are valid. */
typedef struct discmc_event {
  uint8_t kind;
  uint8_t incidence;          /* the normal of the polygon: discmc_incidence_normal() */
  uint8_t incoming_direction; /* of the link that leads to the start of a fragment */
  uint8_t is_hole;            /* the ring is a hole */
  uint8_t is_repeated;        /* the row was replaced by the previous row */
  uint8_t is_abandoned;       /* the scan ended early */
  uint8_t normal[2];          /* where the run starts: discmc_unit_normal() */
  uint32_t run;               /* a straight piece of a ring: discmc_run_vector() */
  uint32_t slice, row;
  discmc_vertex start;
  union {
    const discmc_statistics* statistics;
    const discmc_stream_header* header;
    const discmc_application_record* application;
    /* Per voxel, three bits each for the edges to the voxels before it along x, y and z. They hold
     * the crossing in eighths, from the voxel before. 0: nowhere, or unknown: the middle. */
    const uint16_t* fractions;
  } of; /* Owner: the sender; valid during the call */
} discmc_event;

/* BUSY: the next resume(), or push() of a receiver, offers the event again; NOT_STARTED: never. */
typedef uint8_t discmc_sink_result;
enum { DISCMC_SINK_ACCEPTED, DISCMC_SINK_BUSY, DISCMC_SINK_NOT_STARTED };
/* A sink of events: a function, and the object that it is called with. */
typedef struct discmc_sink {
  void* context;
  discmc_sink_result (*accept)(void* context, const discmc_event* event);
} discmc_sink;

/* The normal of a polygon, from on to off: components are -1, 0 or 1. */
discmc_vertex discmc_incidence_normal(uint8_t incidence);
/* The vector from the start of a run to its end, where the next run starts. */
discmc_vertex discmc_run_vector(uint8_t incidence, uint32_t run);
/* The normal in an event as fixed-point numbers, 16384 for 1; all zero if there is none. */
discmc_vertex discmc_unit_normal(const uint8_t normal[2]);

/* ---- extractor: samples in, polygons out ---- */
/* A program links only the kinds that it names. Plain kinds accept samples of one type, or rows of
 * bits. Kinds with normals add one to each corner, and keep four slices and six rows of samples. */
typedef struct discmc_extractor_kind discmc_extractor_kind;
extern const discmc_extractor_kind discmc_plain_bits, discmc_plain_u8, discmc_plain_u16,
    discmc_plain_i16, discmc_normals_u8, discmc_normals_u16, discmc_normals_i16;

typedef struct discmc_extractor_config {
  const discmc_extractor_kind* kind;
  discmc_limits limits;
  /* The slices of one of several extractors; all zero: the volume. If it continues below, push the
   * slice below first; if above, the slice above last. DISCMC_ANY_ORDER joins all events. */
  struct {
    uint32_t first; /* the number of its first own slice; 0 unless the volume continues below */
    uint8_t continues_below, continues_above;
  } slab;
  int32_t threshold;     /* a voxel is on if its sample is >= threshold */
  int32_t spacing_nm[3]; /* for normals: between voxels; 0: voxels are cubes */
  /* Each slot holds up to three runs of unfinished polygons, in 8 bytes (normals 14).
   * Few slots make the stream longer; the surface is unchanged. 0: as many as fit. */
  uint32_t slots;
  discmc_memory memory;
  discmc_sink sink;
} discmc_extractor_config;
enum { DISCMC_MIN_SLOTS = 4, DISCMC_MAX_SLOTS = 32759 };
/* The least memory for this kind, limits and slots, with the object; 0 if they are bad. */
uint64_t discmc_extractor_bytes(const discmc_extractor_config* config);
/* Begins a scan, also if suspended. Errors: DISCMC_BAD_LIMITS, DISCMC_BAD_CAPACITIES. */
DISCMC_CHECK discmc_status discmc_extractor_start(discmc_extractor** extractor,
                                                  const discmc_extractor_config* config);

/* Accepts samples of consecutive voxels: x first, then y, then z. A call may begin and end anywhere
 * in a row. samples: `count` values of the type, `stride` values apart; Owner: the caller, during
 * the call. Bits: one row per call, (width + 7) / 8 bytes, with the width as the count. If
 * suspended, call resume() until it is not suspended, then push the samples that were not accepted.
 * Errors: DISCMC_BAD_SAMPLES, DISCMC_FINISHED, DISCMC_TOO_MANY_SLICES, for bits
 * DISCMC_ROW_IN_PROGRESS. Cost: a comparison per sample. */
DISCMC_CHECK discmc_push_result discmc_extractor_push(discmc_extractor* extractor,
                                                      discmc_sample_type type, const void* samples,
                                                      uint32_t count, uint32_t stride);
/* Replaces a missing row: DISCMC_SUBSTITUTE_OFF or _PREVIOUS_ROW. Result and errors as for bits. */
DISCMC_CHECK discmc_push_result discmc_extractor_skip_row(discmc_extractor* extractor,
                                                          uint8_t substitute);
/* Continues after any suspended call, and is suspended again while the sink is busy. */
DISCMC_CHECK discmc_status discmc_extractor_resume(discmc_extractor* extractor);
/* Ends the scan, and delivers the remaining events. Errors: DISCMC_SLICE_IN_PROGRESS. */
DISCMC_CHECK discmc_status discmc_extractor_finish(discmc_extractor* extractor);
/* Ends the scan anywhere; the rest of the slice is off. DISCMC_CLOSED still closes the surface. */
DISCMC_CHECK discmc_status discmc_extractor_abandon(discmc_extractor* extractor);
/* A checkpoint; if suspended, resume first. restore() continues at `slices`, `rows` of the info. */
DISCMC_CHECK discmc_status discmc_extractor_save(discmc_extractor* extractor, discmc_memory* part);
DISCMC_CHECK discmc_status discmc_extractor_restore(discmc_extractor** extractor,
                                                    const discmc_extractor_config* config);
/* The progress of a scan, and the memory that it needed. */
typedef struct discmc_extractor_info {
  discmc_statistics statistics;    /* so far */
  uint32_t slices, rows;           /* complete slices, and complete rows of the next */
  uint32_t slots, holes;           /* capacities; waiting holes use some of the slots */
  uint32_t peak_slots, peak_holes; /* most in use; peak_slots + 1168 slots avoid all fragments */
  size_t bytes_used;               /* of the memory, from its beginning */
} discmc_extractor_info;
discmc_extractor_info discmc_extractor_get_info(const discmc_extractor* extractor);

/* ---- encoder: polygons in, bytes out ---- */
/* discmc_regions_with_normals also encodes normals: the stream is about five times as long. */
typedef struct discmc_encoder_kind discmc_encoder_kind;
extern const discmc_encoder_kind discmc_regions, discmc_regions_with_normals;

typedef struct discmc_encoder_config {
  const discmc_encoder_kind* kind;
  discmc_stream_label label; /* a spacing that the extractor has replaces the one here */
  discmc_memory memory;      /* DISCMC_ENCODER_BYTES */
  discmc_byte_output output;
} discmc_encoder_config;
/* Prepares a stream, before discmc_extractor_start(). Each further scan is a stream with the next
 * number. If a reset may have cut off a frame, send a zero byte first. Errors: DISCMC_BAD_LABEL. */
DISCMC_CHECK discmc_status discmc_encoder_start(discmc_encoder** encoder,
                                                const discmc_encoder_config* config);
/* Encodes an event: the sink of an extractor is {encoder, discmc_encoder_accept}. */
discmc_sink_result discmc_encoder_accept(void* encoder, const discmc_event* event);
/* Writes a record now. Suspended while the output is busy or a region is in progress: resume the
 * extractor, then call again. Errors: DISCMC_NOT_STARTED, DISCMC_FINISHED, DISCMC_BAD_RECORD. */
DISCMC_CHECK discmc_status discmc_encoder_write_record(discmc_encoder* encoder,
                                                       const discmc_application_record* record);
/* Sends an incomplete packet instead of waiting for a full one. If suspended, call again. */
DISCMC_CHECK discmc_status discmc_encoder_flush(discmc_encoder* encoder);
/* Continues with another output, and repeats the header for a late receiver. An output without a
 * write function is for a dead link: the encoder drops the stream but counts its bytes. */
void discmc_encoder_set_output(discmc_encoder* encoder, discmc_byte_output output);
/* A checkpoint; if suspended, call again. restore() sends the interrupted frame again. */
DISCMC_CHECK discmc_status discmc_encoder_save(discmc_encoder* encoder, discmc_memory* part);
DISCMC_CHECK discmc_status discmc_encoder_restore(discmc_encoder** encoder,
                                                  const discmc_encoder_config* config);
/* The bytes of stream so far, dropped ones included. */
uint64_t discmc_encoder_stream_bytes(const discmc_encoder* encoder);

/* ---- slice encoder: samples in, bytes out; the receiver extracts the surface ---- */
/* By the type of samples. A program links only the kinds that it names. Kinds with fractions also
 * send where the surface crosses each edge between two voxels. Then the mean distance to the
 * interpolated surface is a quarter, and the stream up to four times as long. */
typedef struct discmc_slice_kind discmc_slice_kind;
extern const discmc_slice_kind discmc_slices_bits, discmc_slices_u8, discmc_slices_u16,
    discmc_slices_i16, discmc_fraction_slices_u8, discmc_fraction_slices_u16,
    discmc_fraction_slices_i16;

typedef struct discmc_slice_encoder_config {
  const discmc_slice_kind* kind;
  discmc_limits limits;
  uint8_t surface_count; /* up to DISCMC_MAX_SURFACES, on consecutive channels; 0: one */
  int32_t thresholds[4]; /* put first the surface most like the others: it predicts them */
  /* The slices from a key slice, which decodes alone, to the next; 0: no further key slice. A lost
   * packet costs up to this many slices; 16 is good. 1: least memory, but the longest stream. */
  uint32_t key_slice_interval;
  uint8_t levels; /* for kinds with fractions: 2 or 4, the parts of an edge */
  discmc_stream_label label;
  discmc_memory memory;
  discmc_byte_output output;
} discmc_slice_encoder_config;
/* The least memory for kind, limits, surfaces, interval and levels; 0 if they are bad. */
uint64_t discmc_slice_encoder_bytes(const discmc_slice_encoder_config* config);
/* Begins a scan. Errors: DISCMC_BAD_LIMITS, DISCMC_BAD_LABEL. */
DISCMC_CHECK discmc_status discmc_slice_encoder_start(discmc_slice_encoder** encoder,
                                                      const discmc_slice_encoder_config* config);

/* push() to restore() work as those of the extractor. Bits: one row per surface, each starting at a
 * new byte. The count of bits is the width, also with several surfaces. */
DISCMC_CHECK discmc_push_result discmc_slice_encoder_push(discmc_slice_encoder* encoder,
                                                          discmc_sample_type type,
                                                          const void* samples, uint32_t count,
                                                          uint32_t stride);
DISCMC_CHECK discmc_push_result discmc_slice_encoder_skip_row(discmc_slice_encoder* encoder,
                                                              uint8_t substitute);
DISCMC_CHECK discmc_status discmc_slice_encoder_resume(discmc_slice_encoder* encoder);
DISCMC_CHECK discmc_status discmc_slice_encoder_finish(discmc_slice_encoder* encoder);
DISCMC_CHECK discmc_status discmc_slice_encoder_abandon(discmc_slice_encoder* encoder);
DISCMC_CHECK discmc_status discmc_slice_encoder_save(discmc_slice_encoder* encoder,
                                                     discmc_memory* part);
DISCMC_CHECK discmc_status discmc_slice_encoder_restore(discmc_slice_encoder** encoder,
                                                        const discmc_slice_encoder_config* config);
/* As for the encoder, except that write_record() fills in slice and row of the record. If it is
 * suspended, call write_record() again. The next slice after set_output() is a key slice. */
DISCMC_CHECK discmc_status discmc_slice_encoder_write_record(
    discmc_slice_encoder* encoder, const discmc_application_record* record);
DISCMC_CHECK discmc_status discmc_slice_encoder_flush(discmc_slice_encoder* encoder);
void discmc_slice_encoder_set_output(discmc_slice_encoder* encoder, discmc_byte_output output);

typedef struct discmc_slice_encoder_info {
  uint64_t stream_bytes; /* so far, dropped ones included */
  uint32_t slices, rows; /* complete slices, and complete rows of the next */
} discmc_slice_encoder_info;
discmc_slice_encoder_info discmc_slice_encoder_get_info(const discmc_slice_encoder* encoder);

/* ---- receiver: bytes in, polygons out ---- */
typedef struct discmc_receiver_config {
  uint8_t channel;      /* of the surface; DISCMC_ANY_CHANNEL: of the first packet */
  discmc_memory memory; /* for slices: beyond the minimum, fewer regions arrive as fragments */
  discmc_sink sink;
} discmc_receiver_config;
/* The least memory for slices as in a header; for polygons null. Limit: valid limits, or null. */
uint64_t discmc_receiver_bytes(const discmc_limits* limits, uint32_t surface_count,
                               uint32_t levels);
/* A receiver per surface: push all bytes to each. Errors: DISCMC_BAD_LABEL (no such channel). */
DISCMC_CHECK discmc_status discmc_receiver_start(discmc_receiver** receiver,
                                                 const discmc_receiver_config* config);

/* Accepts any bytes, any number at a time. DISCMC_FINISHED: a scan is over; the info describes it
 * until the next push() of the remaining bytes, which begin the next scan. If suspended, call
 * push() again with the remaining bytes, even if there are none. Errors: DISCMC_TOO_LITTLE_MEMORY
 * (set_memory(), then push the rest), DISCMC_WRONG_VERSION (call start()), DISCMC_BAD_SINK. */
DISCMC_CHECK discmc_push_result discmc_receiver_push(discmc_receiver* receiver,
                                                     const uint8_t* bytes, size_t count);
/* After DISCMC_TOO_LITTLE_MEMORY: sets memory, discmc_receiver_bytes() for the header of the info.
 * The memory of the config stays in use. Errors: DISCMC_TOO_LITTLE_MEMORY, DISCMC_WRONG_VERSION. */
DISCMC_CHECK discmc_status discmc_receiver_set_memory(discmc_receiver* receiver,
                                                       discmc_memory memory);
/* Ends the input. If suspended, call again. Errors: DISCMC_BAD_SINK. */
DISCMC_CHECK discmc_status discmc_receiver_finish(discmc_receiver* receiver);
/* The report of a receiver: received and missing data so far. */
typedef struct discmc_receiver_info {
  discmc_stream_header header;
  uint8_t has_header, has_trailer, holds_slices, is_abandoned;
  uint8_t is_complete;   /* nothing is missing from header to trailer */
  uint8_t is_unreadable; /* an intact packet has contents that this receiver cannot read */
  uint8_t is_mixed;      /* packets of another scan of the same number were accepted */
  uint64_t bytes, packets, repeated_packets, damaged_packets;
  uint64_t foreign_packets;           /* of other scans and channels; in no other count */
  uint64_t lost_packets, lost_pieces; /* seen at the next packet; pieces: regions and fragments */
  uint64_t regions, fragments;        /* of a stream of polygons */
  uint64_t rows, lost_rows;           /* of a stream of slices */
  uint64_t total_rows;                /* from here on: according to the trailer */
  uint32_t slices;
  discmc_statistics totals; /* for slices only skipped_rows */
} discmc_receiver_info;
discmc_receiver_info discmc_receiver_get_info(const discmc_receiver* receiver);

/* ---- joiner: fragments in, regions out ---- */
typedef struct discmc_joiner_config {
  uint8_t order;        /* DISCMC_SWEEP_ORDER: one extractor or receiver; DISCMC_ANY_ORDER: many */
  discmc_memory memory; /* DISCMC_JOINER_BYTES(fragments that wait at once) */
  discmc_sink sink;
} discmc_joiner_config;
enum { DISCMC_SWEEP_ORDER, DISCMC_ANY_ORDER };
/* Starts an empty joiner. */
DISCMC_CHECK discmc_status discmc_joiner_start(discmc_joiner** joiner,
                                               const discmc_joiner_config* config);
/* Accepts any event: the sink of an extractor or receiver is {joiner, discmc_joiner_accept}. */
discmc_sink_result discmc_joiner_accept(void* joiner, const discmc_event* event);
/* Ends the input. If suspended, call again. Errors: DISCMC_BAD_SINK,
 * DISCMC_TOO_LITTLE_MEMORY (the sink received fragments that a larger joiner can join). */
DISCMC_CHECK discmc_status discmc_joiner_finish(discmc_joiner* joiner);

typedef struct discmc_joiner_info {
  uint64_t received, invalid;         /* fragments that arrived, and those dropped as invalid */
  uint64_t regions, rings;            /* delivered, joined from fragments */
  uint64_t unmatched;                 /* fragments without a partner at the end: data is missing */
  uint64_t short_of_memory;           /* fragments that left unjoined or partly joined */
  uint32_t fragments, runs;           /* capacities */
  uint32_t peak_fragments, peak_runs; /* most in use */
} discmc_joiner_info;
discmc_joiner_info discmc_joiner_get_info(const discmc_joiner* joiner);

/* ---- checkpoint store: the newest complete checkpoint in flash survives a power failure ---- */
/* The driver of a flash, as in littlefs's lfs_config. Its functions return 0, or another number for
 * an error. They may block, or return while the device is busy if the next call then waits. */
typedef struct discmc_store_config {
  void* context;
  int (*read)(void* context, uint32_t block, uint32_t offset, void* buffer, uint32_t bytes);
  /* The store programs the units of an erased block once, in ascending order. */
  int (*program)(void* context, uint32_t block, uint32_t offset, const void* buffer,
                 uint32_t bytes);
  int (*erase)(void* context, uint32_t block); /* null for FRAM and MRAM */
  int (*sync)(void* context);                  /* null if nothing is ever buffered */
  uint32_t program_bytes; /* a unit: programmed and read at once; at least 16 */
  uint32_t block_bytes;   /* erased at once; a multiple of a unit, at most 2^30 */
  uint32_t blocks;        /* fewer than 2^32 units in all */
  uint32_t max_bytes;     /* of all parts of a checkpoint */
  discmc_memory memory;   /* DISCMC_STORE_BYTES(program_bytes) */
} discmc_store_config;
/* Finds the newest checkpoint. Errors: DISCMC_BAD_DEVICE; DISCMC_DEVICE_ERROR (but it starts). */
DISCMC_CHECK discmc_status discmc_store_start(discmc_store** store,
                                              const discmc_store_config* config);
/* The newest checkpoint of a store, and the costs of a checkpoint. */
typedef struct discmc_store_info {
  uint8_t has_checkpoint;   /* one that was not discarded: continue its scan */
  uint32_t bytes, sequence; /* of the newest entry: its length and its number, modulo 2^32 */
  uint32_t slots;           /* checkpoints that fit; E erasures per block suffice for E * slots */
  uint32_t slots_per_block; /* 1 if a slot has one or more blocks of its own */
  uint32_t blocks, units;   /* erased and programmed by a checkpoint of max_bytes */
} discmc_store_info;
discmc_store_info discmc_store_get_info(const discmc_store* store);
/* Reads the newest checkpoint. parts: in number and order as of save(); each may be longer. Errors:
 * DISCMC_BAD_CHECKPOINT, DISCMC_DEVICE_ERROR. */
DISCMC_CHECK discmc_status discmc_store_restore(discmc_store* store, const discmc_memory* parts,
                                                uint32_t count);
/* Erases a block for the next checkpoint of this many bytes; call it between rows. If suspended,
 * another block remains: call again. Errors: DISCMC_DEVICE_ERROR. */
DISCMC_CHECK discmc_status discmc_store_erase_ahead(discmc_store* store, uint32_t bytes);
/* Saves 1 to DISCMC_MAX_PARTS parts; keep them unchanged while the save is suspended. Each call
 * erases a block, or programs a unit and reads it back. Errors: DISCMC_TOO_LITTLE_MEMORY (parts),
 * DISCMC_DEVICE_ERROR (save again: it uses other blocks if there are more than two flash slots). */
DISCMC_CHECK discmc_status discmc_store_save(discmc_store* store, const discmc_memory* parts,
                                             uint32_t count);
DISCMC_CHECK discmc_status discmc_store_resume(discmc_store* store);
enum { DISCMC_MAX_PARTS = 6 };
/* Makes the newest checkpoint void. Call it before the first row of a new scan, and after a scan
 * whose last byte has left the output. Suspended and errors: as save(). */
DISCMC_CHECK discmc_status discmc_store_discard(discmc_store* store);

#ifdef __cplusplus
}
#endif

#endif

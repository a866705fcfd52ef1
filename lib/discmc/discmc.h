/* discmc for C99: all that the C++ headers have, linked by the C linker. Left to C++ are
 * Extractor32, as discmc_learning_extractor has indices of 32 bits, too; groups of other extractors
 * than discmc_extractor, which are given the same rows one after another; and arithmetic on members
 * that a line of C does.
 *
 *   discmc_encoder_start      once
 *   discmc_extractor_start    once, with {&encoder, discmc_encoder_take} as the sink
 *   discmc_extractor_push_u8  as often as samples arrive
 *   discmc_extractor_resume   after DISCMC_MORE, when the output takes bytes again
 *   discmc_extractor_finish   after the last slice; the stream is then complete, without a flush
 *
 * Where the receiver is to extract the surface, a slice encoder stands in for the first two, and
 * sends the bits of the samples in a tenth of the bytes. examples/firmware.c and link.c have both.
 *
 * Names and meanings are those of the C++ headers, which say more where a section names one.
 * Objects are opaque and lie in your memory. They must be zero before their first use: static ones
 * are, others are with `= {{0}}`. Do not move them once started. Drop them at any time: nothing has
 * to be released. Objects share nothing, and no function has static state.
 *
 * The functions that you give, of sinks and outputs, are called within calls of the object that has
 * them, by the same thread, and at no other time. They may wait. They must not throw or jump out,
 * nor call a function of that object, or of one before it on the way of the data, that does
 * something or saves.
 *
 * Pointers must not be null unless said otherwise. Call an object's functions from one context at a
 * time: see ports/boards/README.md for interrupts. Coordinates are in half-steps: voxel (i, j, k) lies at
 * (2i, 2j, 2k). */
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
#define DISCMC_NODISCARD __attribute__((warn_unused_result))
#else
#define DISCMC_NODISCARD
#endif

/* ---- status (status.hpp) ---- */

/* Result of a call. DISCMC_OK and DISCMC_MORE are not errors: DISCMC_MORE means that the sink or
 * output said "not now" and that ..._resume() goes on with the work; of a decoder, a push of the
 * rest.
 *
 * After an error what is under way goes on as if the call had not been made. But what comes before
 * the error is done: events that waited have been delivered, and a push tells how much it has
 * taken. Some errors leave more behind. discmc_extractor_start, DISCMC_TOO_LITTLE_MEMORY, or
 * DISCMC_BAD_SINK of a sink that did not take the start: the scan before has ended, too. A
 * decoder's push, DISCMC_WRONG_VERSION: nothing more of this stream comes.
 * discmc_joiner_finish, DISCMC_TOO_LITTLE_MEMORY: all has been done that can be. */
typedef uint8_t discmc_status;
enum {
  DISCMC_OK,
  DISCMC_MORE,              /* suspended; nothing is lost */
  DISCMC_BAD_LIMITS,        /* see discmc_limits */
  DISCMC_BAD_CAPACITIES,    /* below the minimum, or more records than an index can count */
  DISCMC_TOO_LITTLE_MEMORY, /* smaller than the limits or capacities need, or null */
  DISCMC_BAD_SINK,        /* a sink or output without a function, or a sink that refuses to start */
  DISCMC_NOT_STARTED,     /* ..._start() has not succeeded yet */
  DISCMC_FINISHED,        /* the scan takes no more samples: ..._start() another, or reset */
  DISCMC_ROW_IN_PROGRESS, /* a whole row was given or skipped in the middle of a row */
  DISCMC_SLICE_IN_PROGRESS, /* finish in the middle of a slice */
  DISCMC_TOO_DEEP,          /* the volume has DISCMC_MAX_SLICES; finish still works */
  DISCMC_WRONG_VERSION,     /* this decoder does not know the stream's version */
  DISCMC_BAD_CHECKPOINT,    /* it, or the memory that goes with it, is not what was saved */
  DISCMC_BAD_LABEL,         /* see discmc_stream_label; of a header also its surfaces */
  DISCMC_BAD_RECORD,        /* an application record is too long */
  DISCMC_BAD_DEVICE,        /* a flash without functions, or without room for two checkpoints */
  DISCMC_DEVICE_ERROR       /* a function of a flash failed */
};

/* A short English text for a status. Owner: static storage. */
const char* discmc_text(discmc_status status);

/* ---- version (version.h) ---- */

/* The version of the library that is linked, as "0.2.0". It is DISCMC_VERSION_STRING unless headers
 * and library are of two versions. Owner: static storage. */
const char* discmc_version(void);

/* ---- limits and memory (limits.hpp, capacities.hpp) ---- */

enum { DISCMC_MAX_EXTENT = 32766, DISCMC_MAX_SLICES = 1073741823 };

/* What lies around the volume: a halo of off voxels, which closes the surface, or nothing. */
enum { DISCMC_CLOSED, DISCMC_OPEN };

/* The slices of a volume that one extractor scans. All zero: all of them. Where others continue it,
 * push one slice of theirs as well, before the first or after the last of its own. What crosses the
 * seam leaves as loose fragments, which whoever receives all slabs joins. Flags are 0 or 1. */
typedef struct discmc_slab {
  uint32_t first; /* number of its first own slice in the volume; not 0 where it continues below */
  uint8_t continues_below;
  uint8_t continues_above;
} discmc_slab;

/* The size of a slice. The number of slices is not limited by memory. */
typedef struct discmc_limits {
  uint32_t width;  /* voxels a row; Limit: 1 to DISCMC_MAX_EXTENT */
  uint32_t height; /* rows a slice; likewise */
  uint8_t border;  /* DISCMC_CLOSED or DISCMC_OPEN */
  discmc_slab slab;
} discmc_limits;

/* What there is room for. A shortage costs bytes of the stream, never regions: what has no room is
 * sent as loose fragments. */
typedef struct discmc_capacities {
  uint32_t records; /* of 8 bytes: an end that waits, up to three corners, or half a hole */
  uint32_t holes;   /* that wait for the ring around them; their records count above */
} discmc_capacities;

/* A piece of memory. Owner: the caller. */
typedef struct discmc_memory {
  void* data;
  size_t bytes;
} discmc_memory;

/* 1 when they are valid, else 0. */
uint8_t discmc_limits_is_valid(const discmc_limits* limits);
uint8_t discmc_capacities_is_valid(const discmc_capacities* capacities);

/* The least memory with which a scan works: the surface comes out right, in loose fragments of a
 * few links, or cell by cell where the sink takes none. The least capacities. The bytes that a scan
 * with any capacities takes. Limit: the limits are valid.
 *
 * sizes.h has the same as constants, to size a static array with: DISCMC_MINIMUM_BYTES(),
 * DISCMC_BYTES_FOR() and, as initialisers of a discmc_capacities, DISCMC_MINIMUM_CAPACITIES and
 * DISCMC_DEFAULT_CAPACITIES(). */
uint64_t discmc_minimum_bytes(const discmc_limits* limits);
discmc_capacities discmc_minimum_capacities(void);
uint64_t discmc_bytes_for(const discmc_limits* limits, const discmc_capacities* capacities);

/* The capacities that a number of bytes has room for, the same on every machine. More bytes never
 * make less of anything; fewer than discmc_minimum_bytes() give the minimum. */
discmc_capacities discmc_default_capacities(const discmc_limits* limits, uint64_t bytes);

/* Capacities with which no volume of so many slices ever sends anything loose: far more than real
 * volumes need, and mostly more than 16-bit indices count. */
discmc_capacities discmc_worst_case_capacities(const discmc_limits* limits, uint32_t slices);

/* ---- events and sinks (sink.hpp) ---- */

/* A point of the lattice. Units: half-steps. */
typedef struct discmc_vertex {
  int32_t x, y, z;
} discmc_vertex;

/* A straight run of equal links: see discmc_run_length() and its neighbours. */
typedef uint32_t discmc_run;

/* A unit vector in two bytes, both zero where there is none: see discmc_unit_normal_of(). */
typedef struct discmc_octahedral_normal {
  uint8_t u, v;
} discmc_octahedral_normal;

/* Totals of a scan so far. All are exact, but for slabs: of the cells at a seam either slab counts
 * a part, and drops what is not whole in the end. So the first three counts of a volume's slabs add
 * up to those of the volume, less one a seam at most. */
typedef struct discmc_statistics {
  uint64_t cells;             /* that the surface passes through */
  uint64_t facets;            /* in them, before they are merged to regions */
  uint64_t classic_triangles; /* that classic Marching Cubes would have made in them */
  uint64_t regions;           /* delivered whole */
  uint64_t rings;             /* of these regions, holes included */
  uint64_t links;             /* of rings and loose fragments: the lengths of all runs delivered */
  uint64_t fragments;         /* loose ones, delivered */
  uint64_t skipped_rows;      /* that never came, by skip_row; not those after abandon */
} discmc_statistics;

/* What an encoder is told of a scan; the rest the extractor knows. */
typedef struct discmc_stream_label {
  uint32_t depth;        /* planned slices; 0 when not known */
  int32_t spacing_nm[3]; /* between voxels; negative for a mirrored axis; 0 unknown */
  uint16_t scan;         /* a number that no other scan on the link has, such as a device's own and
                          * a count of its scans */
  uint8_t channel;       /* of the surface, where several share a link; Limit: at most
                          * DISCMC_MAX_CHANNEL */
} discmc_stream_label;

enum { DISCMC_MAX_CHANNEL = 63 };

/* For a decoder that takes the first stream that comes, of whatever channel. */
enum { DISCMC_ANY_CHANNEL = 255 };

/* What a stream says of its scan. */
typedef struct discmc_stream_header {
  uint32_t width, height;
  uint32_t depth;        /* planned slices; 0 when not known */
  int32_t spacing_nm[3]; /* between voxels; negative for a mirrored axis; 0 unknown */
  int32_t threshold;     /* a voxel is on where its sample is >= threshold */
  uint8_t border;        /* DISCMC_CLOSED or DISCMC_OPEN */
  uint8_t channel;       /* of the first surface, where a stream of slices has several */
  uint16_t scan;
  uint8_t further_surfaces; /* in this stream, on the next channels; below DISCMC_MAX_SURFACES */
  int32_t further_thresholds[3]; /* of the second surface on */
} discmc_stream_header;
enum { DISCMC_MAX_SURFACES = 4 };

/* 1 when sizes, border, surfaces and channels are within their limits, else 0. */
uint8_t discmc_stream_header_is_valid(const discmc_stream_header* header);

/* The user's own data in a stream: a time stamp, a pose, the state of a battery. A record goes out
 * at once, in a packet of its own: so tell rarely, and much at once. */
typedef struct discmc_application_record {
  uint8_t kind;         /* the user's; Limit: below DISCMC_FIRST_STANDARD_KIND, not checked */
  uint32_t slice, row;  /* where the scan was: as many were complete */
  const uint8_t* bytes; /* Owner: whoever tells it; free again when the call returns */
  size_t count;         /* Limit: at most DISCMC_MAX_RECORD_BYTES */
} discmc_application_record;
enum { DISCMC_MAX_RECORD_BYTES = 200, DISCMC_FIRST_STANDARD_KIND = 240 };

/* The kinds of events, in this grammar:
 *
 *   scan     = start { region | fragment | skipped | layer | application } finish
 *   region   = region { ring { run } } region_end       outer ring first, then the holes
 *   fragment = fragment { run } fragment_end            only when the sink takes fragments
 *
 * A fragment is loose: a piece of a boundary ring, sent early for lack of memory, complete in
 * itself. Fragment E follows fragment F where both have the same incidence, E starts where F's runs
 * end, and E came there by the direction of F's last run; there is one match at most. Where two
 * fragments are joined, runs of one direction may meet: that is no corner. A ring that goes out
 * loose as a whole follows itself. All loose fragments of a region's holes come before its outer
 * ring, or the last fragment of it.
 *
 * A start must be taken at once: an extractor whose sink does not is not started. Only decoders
 * send `application`. */
enum {
  DISCMC_START,        /* the first event: header */
  DISCMC_REGION,       /* a complete region begins: incidence */
  DISCMC_RING,         /* one of its rings begins: start, hole */
  DISCMC_RUN,          /* the next run of the ring or fragment: run, normal */
  DISCMC_REGION_END,   /* the region is complete */
  DISCMC_FRAGMENT,     /* a loose fragment begins: incidence, start, came */
  DISCMC_FRAGMENT_END, /* the fragment is complete */
  DISCMC_SKIPPED,      /* a row never came: slice, row, repeated */
  DISCMC_LAYER,        /* every region that does not reach `slice` has been delivered */
  DISCMC_APPLICATION,  /* the user's own data: application */
  DISCMC_FINISH,       /* the last event: slice (how many; of a slab, its own), abandoned,
                        * statistics */
  DISCMC_LOST          /* decoder only: part of the region or fragment just begun is lost */
};

/* One thing that a sink is offered. Only the members that its kind names have a meaning. Flags are
 * 0 or 1. */
typedef struct discmc_event {
  uint8_t kind;
  uint8_t incidence; /* see discmc_normal() */
  uint8_t came;      /* the direction of the link by which a fragment's chain comes to its start */
  uint8_t hole;
  uint8_t repeated;
  uint8_t abandoned;
  discmc_octahedral_normal normal; /* where the run starts, if the stream tells normals */
  discmc_run run;
  uint32_t slice;
  uint32_t row;
  discmc_vertex start;
  /* Owner: the sender; valid during the call. */
  union {
    const discmc_statistics* statistics;
    const discmc_stream_header* header; /* of an extractor: not the depth, scan and channel */
    const discmc_application_record* application;
  } of;
} discmc_event;

/* A sink's answer. What it did not take is offered again, unchanged, on the next resume. Never: the
 * sink was not started, and asking again is of no use. Extractors are not started then; decoders
 * and joiners say DISCMC_BAD_SINK. To an extractor at work it is as "not now". */
typedef uint8_t discmc_answer;
enum { DISCMC_TAKEN, DISCMC_NOT_NOW, DISCMC_NEVER };

/* Where events go. A sink that passes over fragments, from DISCMC_FRAGMENT to DISCMC_FRAGMENT_END,
 * gets an incomplete surface: put a joiner before it. Owner: the context is the caller's and must
 * outlive the scan; the sink is copied. */
typedef struct discmc_sink {
  void* context;
  discmc_answer (*take)(void* context, const discmc_event* event);
} discmc_sink;

/* ---- the extractor (extractor.hpp) ---- */

/* The result of a push, and how many of the samples it took. The rest must be pushed again. */
typedef struct discmc_push_result {
  discmc_status status;
  uint32_t samples;
} discmc_push_result;

/* High-water marks. Units: as discmc_capacities. */
typedef struct discmc_high_water {
  uint32_t records, holes;
} discmc_high_water;

/* What stands in for a row that never came. */
enum { DISCMC_OFF, DISCMC_PREVIOUS_ROW };

/* Takes the samples of a scan, and hands its regions to a sink. With 16-bit indices: at most 32,759
 * records, which are 256 KiB. Hosts that give it more memory take a discmc_learning_extractor, and
 * whoever wants normals a discmc_normal_extractor. */
typedef struct discmc_extractor {
  uint64_t opaque[(sizeof(void*) == 8 ? 512 : 424) / 8];
} discmc_extractor;

/* Where a scan is, as plain bytes: see checkpoint.hpp. */
typedef struct discmc_extractor_checkpoint {
  uint64_t head[3];
  discmc_extractor extractor;
} discmc_extractor_checkpoint;

/* Begins a scan; a voxel is on where its sample is >= threshold. capacities: null for as many
 * records as the memory has room for. memory: at least discmc_minimum_bytes(), or
 * discmc_bytes_for() of the capacities; Owner: the caller, for as long as the scan lasts. Errors:
 * DISCMC_BAD_LIMITS, DISCMC_BAD_CAPACITIES, DISCMC_BAD_SINK, DISCMC_TOO_LITTLE_MEMORY; then the
 * memory is untouched. Cost: a write for each queue, and for each word of a row. */
DISCMC_NODISCARD discmc_status discmc_extractor_start(discmc_extractor* extractor,
                                                      const discmc_limits* limits,
                                                      const discmc_capacities* capacities,
                                                      int32_t threshold, discmc_memory memory,
                                                      const discmc_sink* sink);

/* Begins the next scan with the limits, threshold, memory and sink of the last start. Errors:
 * DISCMC_NOT_STARTED, DISCMC_BAD_SINK (it does not take the start of the scan). */
DISCMC_NODISCARD discmc_status discmc_extractor_reset(discmc_extractor* extractor);

/* Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
 * samples: Owner: the caller; free again when the call returns. stride: from one sample to the
 * next, in samples; 1 where they are adjacent. With DISCMC_MORE all samples up to the end of the
 * row that caused it have been taken. Errors: DISCMC_NOT_STARTED, DISCMC_FINISHED, DISCMC_TOO_DEEP.
 * Cost: a comparison a sample; a completed row also sweeps a row of the slice below. */
DISCMC_NODISCARD discmc_push_result discmc_extractor_push_u8(discmc_extractor* extractor,
                                                             const uint8_t* samples, uint32_t count,
                                                             uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_extractor_push_u16(discmc_extractor* extractor,
                                                              const uint16_t* samples,
                                                              uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_extractor_push_i16(discmc_extractor* extractor,
                                                              const int16_t* samples,
                                                              uint32_t count, uint32_t stride);

/* Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0. Counts as
 * `width` samples, or 0 when it was not taken. Errors: as a push, and DISCMC_ROW_IN_PROGRESS. */
DISCMC_NODISCARD discmc_push_result discmc_extractor_push_bits(discmc_extractor* extractor,
                                                               const uint8_t* bits);

/* Stands in for a row that never came; the sink is told. substitute: DISCMC_OFF or
 * DISCMC_PREVIOUS_ROW. Result and errors: as push_bits. */
DISCMC_NODISCARD discmc_push_result discmc_extractor_skip_row(discmc_extractor* extractor,
                                                              uint8_t substitute);

/* Goes on after DISCMC_MORE, which it may answer again. Harmless at any other time. Errors:
 * DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_extractor_resume(discmc_extractor* extractor);

/* Ends the scan: delivers every region and the totals. After DISCMC_MORE go on with resume. Errors:
 * DISCMC_NOT_STARTED, DISCMC_SLICE_IN_PROGRESS. */
DISCMC_NODISCARD discmc_status discmc_extractor_finish(discmc_extractor* extractor);

/* Ends the scan wherever it is: the rest of the slice is taken as off, so the surface is closed all
 * the same, and the sink is told. After DISCMC_MORE go on with resume.
 * Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_extractor_abandon(discmc_extractor* extractor);

/* Writes down where the scan is; with the first discmc_extractor_bytes_used() bytes of the memory
 * that is all of it. Errors: DISCMC_NOT_STARTED. DISCMC_MORE: resume first. Cost: a checksum of
 * those bytes. */
DISCMC_NODISCARD discmc_status discmc_extractor_save(const discmc_extractor* extractor,
                                                     discmc_extractor_checkpoint* checkpoint);

/* Goes on where a checkpoint was saved, by the same build. memory: as many bytes as the start was
 * given, the first ones as they were then; it may lie elsewhere, with the same alignment modulo 4;
 * Owner: as of the start. Errors: DISCMC_TOO_LITTLE_MEMORY, DISCMC_BAD_CHECKPOINT,
 * DISCMC_BAD_SINK. Cost: as save. */
DISCMC_NODISCARD discmc_status
discmc_extractor_restore(discmc_extractor* extractor, const discmc_extractor_checkpoint* checkpoint,
                         discmc_memory memory, const discmc_sink* sink);

/* Totals so far, and all of them once the scan is finished. */
discmc_statistics discmc_extractor_statistics(const discmc_extractor* extractor);
/* What the scan was started with, the default capacities worked out; and the most in use so far. */
discmc_limits discmc_extractor_limits(const discmc_extractor* extractor);
discmc_capacities discmc_extractor_capacities(const discmc_extractor* extractor);
discmc_high_water discmc_extractor_high_water(const discmc_extractor* extractor);
/* The bytes of the memory, from its beginning, that the scan has written to so far. */
size_t discmc_extractor_bytes_used(const discmc_extractor* extractor);
/* Complete slices so far, and complete rows of the current one. */
uint32_t discmc_extractor_slices(const discmc_extractor* extractor);
uint32_t discmc_extractor_rows(const discmc_extractor* extractor);

/* ---- the encoder (encoder.hpp) ---- */

/* The version of the stream that is written, and the most bytes of one of its frames. */
enum { DISCMC_WIRE_VERSION = 2, DISCMC_MAX_FRAME = 256 };

/* Where bytes go. Owner: the context is the caller's, and must stay until there is another output,
 * or the encoder is used no more. */
typedef struct discmc_byte_output {
  void* context;
  /* Takes up to `count` bytes and returns how many it took, never more; 0 means "not now". On
   * error, return 0. bytes: valid during the call. */
  size_t (*write)(void* context, const uint8_t* bytes, size_t count);
} discmc_byte_output;

/* Writes the stream of one scan. */
typedef struct discmc_encoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 1024 : 1000) / 8];
} discmc_encoder;

/* Gets ready for a scan: the stream begins with the extractor's start, which tells the rest of its
 * header, the first packet. A further scan is a further stream; its number is one more. Where a
 * reset may have cut off a frame, send a zero byte first: it ends the frame, and is none. Errors:
 * DISCMC_BAD_LABEL, DISCMC_BAD_SINK (no write). */
DISCMC_NODISCARD discmc_status discmc_encoder_start(discmc_encoder* encoder,
                                                    const discmc_stream_label* label,
                                                    discmc_byte_output output);

/* Takes an event; encoder points to a discmc_encoder, so that this is the `take` of a sink whose
 * context is one: {&encoder, discmc_encoder_take}. DISCMC_NEVER before discmc_encoder_start(),
 * and before the start of a scan: a stream begins with its header. */
discmc_answer discmc_encoder_take(void* encoder, const discmc_event* event);

/* Sends an application record now, in the order of the stream. DISCMC_MORE: the output takes
 * nothing now, or a region is on its way: resume the extractor and call again. Errors:
 * DISCMC_NOT_STARTED, DISCMC_FINISHED, DISCMC_BAD_RECORD. */
DISCMC_NODISCARD discmc_status discmc_encoder_tell(discmc_encoder* encoder,
                                                   const discmc_application_record* record);

/* A packet of records on its way from an encoder or a decoder to another encoder
 * (records_packet.hpp). */
typedef struct discmc_records_packet {
  const uint8_t* payload; /* Owner: who gives it */
  size_t bytes;           /* Limit: at most DISCMC_MAX_APPENDED, or 2 more where not whole */
  uint32_t pieces;        /* regions and loose fragments that end in it; Limit: below 2^16 */
  uint8_t is_whole;       /* it holds whole regions alone, none of them in part, and no loose
                           * fragment of any stream belongs to one of them */
} discmc_records_packet;
enum { DISCMC_MAX_APPENDED = 241 };

/* Sends a packet of records as it is. The parts of a piece that goes through several packets must
 * follow each other. DISCMC_MORE: as of tell. Errors: DISCMC_NOT_STARTED, DISCMC_FINISHED,
 * DISCMC_BAD_RECORD. */
DISCMC_NODISCARD discmc_status discmc_encoder_append(discmc_encoder* encoder,
                                                     const discmc_records_packet* packet);

/* Goes on with another output, and with a header, so that a receiver may come late. Without a write
 * the stream is dropped, but counted: so a scan goes on though its link is dead, and the stream is
 * there again once it has an output. */
void discmc_encoder_set_output(discmc_encoder* encoder, discmc_byte_output output);

/* Sends what is there so far instead of waiting for a full packet. 0 when the output does not take
 * all of it now: call again. */
DISCMC_NODISCARD uint8_t discmc_encoder_flush(discmc_encoder* encoder);

/* Where a stream is, as plain bytes. */
typedef struct discmc_encoder_checkpoint {
  uint64_t head[3];
  discmc_encoder encoder;
} discmc_encoder_checkpoint;

/* Writes down where the stream is, at the beginning of a frame. Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_encoder_save(const discmc_encoder* encoder,
                                                   discmc_encoder_checkpoint* checkpoint);

/* Goes on where a checkpoint was saved; discmc_encoder_bytes() says how many bytes of stream were
 * before. Errors: DISCMC_BAD_CHECKPOINT, DISCMC_BAD_SINK (no write). */
DISCMC_NODISCARD discmc_status discmc_encoder_restore(discmc_encoder* encoder,
                                                      const discmc_encoder_checkpoint* checkpoint,
                                                      discmc_byte_output output);

/* The bytes of stream so far: what the output has taken, and what was dropped without one. How many
 * those are is what this has grown by between the two calls of ..._set_output(). */
uint64_t discmc_encoder_bytes(const discmc_encoder* encoder);

/* ---- checkpoints in flash (checkpoint_store.hpp, flash_device.hpp) ---- */

/* The part of a memory that is for checkpoints. Units: bytes, but for the blocks. */
typedef struct discmc_flash_geometry {
  uint32_t program_bytes; /* programmed and read at once; may be several units of the device;
                           * Limit: at least 16 */
  uint32_t block_bytes;   /* erased at once; Limit: a multiple of program_bytes, at most 2^30 */
  uint32_t blocks;        /* how many; numbered from 0; Limit: fewer than 2^32 program units */
} discmc_flash_geometry;

/* The functions of a driver; those of littlefs's lfs_config do the same. Each returns 0, or any
 * other number for an error. They are called within calls of the store that has them, by the same
 * thread, and at no other time. They may wait, or return while the device is still at work, where
 * each call that follows waits until it is done. They must not call the store. Owner: the context
 * is the caller's. */
typedef struct discmc_flash_device {
  void* context;
  /* Reads a unit: bytes is program_bytes, and offset a multiple of it, within a block. */
  int (*read)(void* context, uint32_t block, uint32_t offset, void* buffer, uint32_t bytes);
  /* Programs a unit of a block that was erased, once, in their order. */
  int (*program)(void* context, uint32_t block, uint32_t offset, const void* buffer,
                 uint32_t bytes);
  /* Erases a block. Null where the device needs none, as FRAM and MRAM. */
  int (*erase)(void* context, uint32_t block);
  /* Comes back when all is in the memory to stay. Null where it always is. */
  int (*sync)(void* context);
  discmc_flash_geometry geometry;
} discmc_flash_device;

/* How checkpoints of a number of bytes lie in a flash. A flash whose blocks bear so many erasures
 * is worn out after slots * erasures checkpoints. One takes at most blocks * (time of an erasure) +
 * units * (time of a unit); without the first part where all was erased ahead. */
typedef struct discmc_store_plan {
  uint32_t slots;           /* checkpoints that there is room for */
  uint32_t slots_per_block; /* where several share a block, which is erased for the first; else 1 */
  uint32_t blocks;          /* of a checkpoint */
  uint32_t units;           /* that a checkpoint programs */
} discmc_store_plan;

/* All zero where there is no room for two of them in blocks of their own. */
discmc_store_plan discmc_store_plan_for(const discmc_flash_geometry* geometry, uint32_t most_bytes);

/* Keeps checkpoints in flash: the newest whole one is there after a power failure, whenever that
 * came. A checkpoint is the bytes of some parts, one behind the other: those of ..._save(), and the
 * memory in use. */
typedef struct discmc_checkpoint_store {
  uint64_t opaque[(sizeof(void*) == 8 ? 272 : 184) / 8];
} discmc_checkpoint_store;
enum { DISCMC_MAX_PARTS = 4 };

/* Finds the newest whole checkpoint; what else is in the flash is of no matter. most_bytes: of all
 * parts of a checkpoint. buffer: at least program_bytes; Owner: the caller, as for the device, as
 * long as the store is used. Errors: DISCMC_BAD_DEVICE, DISCMC_TOO_LITTLE_MEMORY (the buffer).
 * DISCMC_DEVICE_ERROR: a read failed, and no checkpoint was found; the store is started all the
 * same, and may save over what could not be read. */
DISCMC_NODISCARD discmc_status discmc_checkpoint_store_start(discmc_checkpoint_store* store,
                                                             const discmc_flash_device* device,
                                                             uint32_t most_bytes,
                                                             discmc_memory buffer);

/* 1 when there is a whole checkpoint; how many bytes it has, and its number: one more than of the
 * one before. Without one, 0. */
uint8_t discmc_checkpoint_store_has_checkpoint(const discmc_checkpoint_store* store);
uint32_t discmc_checkpoint_store_bytes(const discmc_checkpoint_store* store);
uint32_t discmc_checkpoint_store_sequence(const discmc_checkpoint_store* store);

/* Reads the newest checkpoint. parts: as they were saved, but the last may have more bytes than
 * then. Breaks off a save that is under way. Errors: DISCMC_NOT_STARTED, DISCMC_BAD_CHECKPOINT
 * (there is none, or of other bytes, then nothing is written; or it is damaged since the start),
 * DISCMC_DEVICE_ERROR. */
DISCMC_NODISCARD discmc_status discmc_checkpoint_store_restore(discmc_checkpoint_store* store,
                                                               const discmc_memory* parts,
                                                               uint32_t count);

/* Erases a block for the next checkpoint, if one is left to erase for so many bytes; the scan may
 * go on between calls. DISCMC_MORE: call again. Errors: DISCMC_NOT_STARTED, DISCMC_DEVICE_ERROR. */
DISCMC_NODISCARD discmc_status discmc_checkpoint_store_erase_ahead(discmc_checkpoint_store* store,
                                                                   uint32_t bytes);

/* Begins to save a checkpoint, and does the first step of ..._resume(). parts: at most
 * DISCMC_MAX_PARTS; Owner: what they lead to stays as it is up to another status than DISCMC_MORE;
 * until then the checkpoint before is the newest. Breaks off a save that is under way. Errors:
 * DISCMC_NOT_STARTED, DISCMC_TOO_LITTLE_MEMORY (more parts or bytes than there is room for),
 * DISCMC_DEVICE_ERROR. */
DISCMC_NODISCARD discmc_status discmc_checkpoint_store_save(discmc_checkpoint_store* store,
                                                            const discmc_memory* parts,
                                                            uint32_t count);

/* Goes on with the save that is under way, if there is one: erases a block, or programs a unit and
 * reads it again. Errors: DISCMC_NOT_STARTED. DISCMC_DEVICE_ERROR: the save is broken off; the next
 * one takes other blocks if there are more than two slots. */
DISCMC_NODISCARD discmc_status discmc_checkpoint_store_resume(discmc_checkpoint_store* store);

/* What the axes of space are: the scanner's own; towards left, back and head, as in DICOM; towards
 * right, front and head, as in NIfTI. */
enum { DISCMC_FRAME_NONE, DISCMC_FRAME_LPS, DISCMC_FRAME_RAS };

/* Where a volume lies in space (placement.hpp): voxel (i, j, k) has its centre at origin +
 * i axes[0] + j axes[1] + k axes[2]. Units: nanometres. */
typedef struct discmc_placement {
  int32_t axes_nm[3][3]; /* of one voxel to the next along x, y, z: their x, y, z in space */
  int64_t origin_nm[3];  /* the centre of voxel (0, 0, 0) */
  uint8_t frame;         /* DISCMC_FRAME_NONE, DISCMC_FRAME_LPS or DISCMC_FRAME_RAS */
} discmc_placement;
enum { DISCMC_PLACEMENT_KIND = DISCMC_FIRST_STANDARD_KIND, DISCMC_PLACEMENT_BYTES = 61 };

/* The record of a placement, to be told best before the first row. bytes: room for
 * DISCMC_PLACEMENT_BYTES, which are written; Owner: the caller, until the record has been told. */
discmc_application_record discmc_placement_record(const discmc_placement* placement,
                                                  uint8_t* bytes);

/* Reads the placement in a record. 0, and nothing is written, where it holds none: the kind is
 * another, or the number of bytes, or the frame is not known. */
DISCMC_NODISCARD uint8_t discmc_read_placement(const discmc_application_record* record,
                                               discmc_placement* placement);

/* The own slices of a slab (slab_range.hpp). Units: slices. */
typedef struct discmc_slab_range {
  uint32_t first;
  uint32_t slices;
  uint32_t depth; /* of the volume; Limit: at least first + slices */
} discmc_slab_range;
enum { DISCMC_SLAB_RANGE_KIND = DISCMC_FIRST_STANDARD_KIND + 1, DISCMC_SLAB_RANGE_BYTES = 12 };

/* The record of a slab, to be told at any time in its scan. bytes: room for
 * DISCMC_SLAB_RANGE_BYTES, which are written; Owner: the caller, until the record has been told. */
discmc_application_record discmc_slab_range_record(const discmc_slab_range* range, uint8_t* bytes);

/* Reads the range in a record. 0, and nothing is written, where it holds none: the kind is another,
 * or the number of bytes, or the slices are none, or beyond the depth. */
DISCMC_NODISCARD uint8_t discmc_read_slab_range(const discmc_application_record* record,
                                                discmc_slab_range* range);

/* ---- normals on the device (gradient_normals.hpp) ---- */

/* What a normal extractor is made for: samples of a type, and indices of 16 bits, which count at
 * most 32,759 records of 14 bytes, or, for hosts, of 32 and records of 16. A program links the code
 * of those kinds alone that it names. */
typedef struct discmc_normal_kind discmc_normal_kind;
extern const discmc_normal_kind discmc_normals_u8;
extern const discmc_normal_kind discmc_normals_u16;
extern const discmc_normal_kind discmc_normals_i16;
extern const discmc_normal_kind discmc_host_normals_u8;
extern const discmc_normal_kind discmc_host_normals_u16;
extern const discmc_normal_kind discmc_host_normals_i16;

/* An extractor that tells with every run the normal where it starts: of the samples' gradient, in
 * the events' `normal`. It keeps the samples of four slices, and sweeps a slice and a row later;
 * the events are those of a discmc_extractor but for the normals in them. */
typedef struct discmc_normal_extractor {
  uint64_t opaque[(sizeof(void*) == 8 ? 600 : 504) / 8];
} discmc_normal_extractor;

/* As discmc_minimum_bytes() and its neighbours. sizes.h has the same as constants, but for kinds of
 * hosts: DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(), DISCMC_NORMAL_EXTRACTOR_BYTES_FOR() and
 * DISCMC_NORMAL_EXTRACTOR_DEFAULT_CAPACITIES(). */
uint64_t discmc_normal_extractor_minimum_bytes(const discmc_normal_kind* kind,
                                               const discmc_limits* limits);
uint64_t discmc_normal_extractor_bytes_for(const discmc_normal_kind* kind,
                                           const discmc_limits* limits,
                                           const discmc_capacities* capacities);
discmc_capacities discmc_normal_extractor_default_capacities(const discmc_normal_kind* kind,
                                                             const discmc_limits* limits,
                                                             uint64_t bytes);

/* Tells how far apart voxels are, for the scans of this kind to come, until told otherwise: without
 * it they are cubes. The start of the scan tells it to the stream. spacing_nm: negative where an
 * axis is mirrored. Limit: not during a scan, whose normals would differ from then on; that of
 * another kind has ended. */
void discmc_normal_extractor_set_spacing(discmc_normal_extractor* extractor,
                                         const discmc_normal_kind* kind,
                                         const int32_t spacing_nm[3]);

/* As discmc_extractor_start(), with the bytes of this kind. The object becomes one of this kind: a
 * scan of another has ended, whatever comes of the start. */
DISCMC_NODISCARD discmc_status
discmc_normal_extractor_start(discmc_normal_extractor* extractor, const discmc_normal_kind* kind,
                              const discmc_limits* limits, const discmc_capacities* capacities,
                              int32_t threshold, discmc_memory memory, const discmc_sink* sink);

/* Takes samples as discmc_extractor_push_u8() and its neighbours. DISCMC_NOT_STARTED: also that the
 * kind is of another type. */
DISCMC_NODISCARD discmc_push_result discmc_normal_extractor_push_u8(
    discmc_normal_extractor* extractor, const uint8_t* samples, uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_normal_extractor_push_u16(
    discmc_normal_extractor* extractor, const uint16_t* samples, uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_normal_extractor_push_i16(
    discmc_normal_extractor* extractor, const int16_t* samples, uint32_t count, uint32_t stride);

/* Each as the function of discmc_extractor. */
DISCMC_NODISCARD discmc_push_result
discmc_normal_extractor_skip_row(discmc_normal_extractor* extractor, uint8_t substitute);
DISCMC_NODISCARD discmc_status discmc_normal_extractor_reset(discmc_normal_extractor* extractor);
DISCMC_NODISCARD discmc_status discmc_normal_extractor_resume(discmc_normal_extractor* extractor);
DISCMC_NODISCARD discmc_status discmc_normal_extractor_finish(discmc_normal_extractor* extractor);
DISCMC_NODISCARD discmc_status discmc_normal_extractor_abandon(discmc_normal_extractor* extractor);
discmc_statistics discmc_normal_extractor_statistics(const discmc_normal_extractor* extractor);
discmc_limits discmc_normal_extractor_limits(const discmc_normal_extractor* extractor);
discmc_capacities discmc_normal_extractor_capacities(const discmc_normal_extractor* extractor);
discmc_high_water discmc_normal_extractor_high_water(const discmc_normal_extractor* extractor);
size_t discmc_normal_extractor_bytes_used(const discmc_normal_extractor* extractor);
uint32_t discmc_normal_extractor_slices(const discmc_normal_extractor* extractor);
uint32_t discmc_normal_extractor_rows(const discmc_normal_extractor* extractor);

/* Where a scan is, as plain bytes. */
typedef struct discmc_normal_extractor_checkpoint {
  uint64_t head[3];
  discmc_normal_extractor extractor;
} discmc_normal_extractor_checkpoint;

/* As discmc_extractor_save(). */
DISCMC_NODISCARD discmc_status discmc_normal_extractor_save(
    const discmc_normal_extractor* extractor, discmc_normal_extractor_checkpoint* checkpoint);
/* As discmc_extractor_restore(); that of another kind is DISCMC_BAD_CHECKPOINT. The object becomes
 * one of this kind, as by a start. */
DISCMC_NODISCARD discmc_status
discmc_normal_extractor_restore(discmc_normal_extractor* extractor, const discmc_normal_kind* kind,
                                const discmc_normal_extractor_checkpoint* checkpoint,
                                discmc_memory memory, const discmc_sink* sink);

/* An encoder that tells the normals of runs too, which a discmc_encoder leaves out. A normal takes
 * 2 to 3 bytes, and a stream with them about four times the bytes of one without. */
typedef struct discmc_normal_encoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 1040 : 1000) / 8];
} discmc_normal_encoder;

/* Each as the function of discmc_encoder. */
DISCMC_NODISCARD discmc_status discmc_normal_encoder_start(discmc_normal_encoder* encoder,
                                                           const discmc_stream_label* label,
                                                           discmc_byte_output output);
discmc_answer discmc_normal_encoder_take(void* encoder, const discmc_event* event);
DISCMC_NODISCARD discmc_status discmc_normal_encoder_tell(discmc_normal_encoder* encoder,
                                                          const discmc_application_record* record);
DISCMC_NODISCARD discmc_status discmc_normal_encoder_append(discmc_normal_encoder* encoder,
                                                            const discmc_records_packet* packet);
void discmc_normal_encoder_set_output(discmc_normal_encoder* encoder, discmc_byte_output output);
DISCMC_NODISCARD uint8_t discmc_normal_encoder_flush(discmc_normal_encoder* encoder);
uint64_t discmc_normal_encoder_bytes(const discmc_normal_encoder* encoder);

/* Where a stream is, as plain bytes. */
typedef struct discmc_normal_encoder_checkpoint {
  uint64_t head[3];
  discmc_normal_encoder encoder;
} discmc_normal_encoder_checkpoint;

/* Each as the function of discmc_encoder. */
DISCMC_NODISCARD discmc_status discmc_normal_encoder_save(
    const discmc_normal_encoder* encoder, discmc_normal_encoder_checkpoint* checkpoint);
DISCMC_NODISCARD discmc_status discmc_normal_encoder_restore(
    discmc_normal_encoder* encoder, const discmc_normal_encoder_checkpoint* checkpoint,
    discmc_byte_output output);

/* ---- an extractor for hosts (learning_extractor.hpp) ---- */

/* An extractor with 32-bit indices and records of 16 bytes, which takes half of the instructions
 * where it has a few megabytes. The object takes 137 KiB. Events are those of a discmc_extractor,
 * as long as nothing goes out loose; what does may be other pieces of the same regions. */
typedef struct discmc_learning_extractor {
  uint64_t opaque[(sizeof(void*) == 8 ? 140544 : 140448) / 8];
} discmc_learning_extractor;

/* As discmc_minimum_bytes() and its neighbours; give it 600 KiB more than the minimum. sizes.h has
 * the same as constants: DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(),
 * DISCMC_LEARNING_EXTRACTOR_BYTES_FOR() and DISCMC_LEARNING_EXTRACTOR_DEFAULT_CAPACITIES(). */
uint64_t discmc_learning_extractor_minimum_bytes(const discmc_limits* limits);
uint64_t discmc_learning_extractor_bytes_for(const discmc_limits* limits,
                                             const discmc_capacities* capacities);
discmc_capacities discmc_learning_extractor_default_capacities(const discmc_limits* limits,
                                                               uint64_t bytes);

/* Remembers in this memory, besides that of the start, what it works out of neighbourhoods, from
 * this scan to the next: 1 MiB is a good size, and without it the events are the same but cost
 * more. Call it at any time; what was remembered elsewhere is forgotten. Nothing is remembered
 * before, and after restore. Owner: the caller, for as long as scans last. Cost: a quarter of it is
 * written. */
void discmc_learning_extractor_learn_in(discmc_learning_extractor* extractor, discmc_memory memory);

/* Each as the function of discmc_extractor. */
DISCMC_NODISCARD discmc_status discmc_learning_extractor_start(discmc_learning_extractor* extractor,
                                                               const discmc_limits* limits,
                                                               const discmc_capacities* capacities,
                                                               int32_t threshold,
                                                               discmc_memory memory,
                                                               const discmc_sink* sink);
DISCMC_NODISCARD discmc_status
discmc_learning_extractor_reset(discmc_learning_extractor* extractor);
DISCMC_NODISCARD discmc_push_result discmc_learning_extractor_push_u8(
    discmc_learning_extractor* extractor, const uint8_t* samples, uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_learning_extractor_push_u16(
    discmc_learning_extractor* extractor, const uint16_t* samples, uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_learning_extractor_push_i16(
    discmc_learning_extractor* extractor, const int16_t* samples, uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result
discmc_learning_extractor_push_bits(discmc_learning_extractor* extractor, const uint8_t* bits);
DISCMC_NODISCARD discmc_push_result
discmc_learning_extractor_skip_row(discmc_learning_extractor* extractor, uint8_t substitute);
DISCMC_NODISCARD discmc_status
discmc_learning_extractor_resume(discmc_learning_extractor* extractor);
DISCMC_NODISCARD discmc_status
discmc_learning_extractor_finish(discmc_learning_extractor* extractor);
DISCMC_NODISCARD discmc_status
discmc_learning_extractor_abandon(discmc_learning_extractor* extractor);
discmc_statistics discmc_learning_extractor_statistics(const discmc_learning_extractor* extractor);
discmc_limits discmc_learning_extractor_limits(const discmc_learning_extractor* extractor);
discmc_capacities discmc_learning_extractor_capacities(const discmc_learning_extractor* extractor);
discmc_high_water discmc_learning_extractor_high_water(const discmc_learning_extractor* extractor);
size_t discmc_learning_extractor_bytes_used(const discmc_learning_extractor* extractor);
uint32_t discmc_learning_extractor_slices(const discmc_learning_extractor* extractor);
uint32_t discmc_learning_extractor_rows(const discmc_learning_extractor* extractor);

/* Where a scan is, as plain bytes. */
typedef struct discmc_learning_extractor_checkpoint {
  uint64_t head[3];
  discmc_learning_extractor extractor;
} discmc_learning_extractor_checkpoint;

/* Each as the function of discmc_extractor. */
DISCMC_NODISCARD discmc_status discmc_learning_extractor_save(
    const discmc_learning_extractor* extractor, discmc_learning_extractor_checkpoint* checkpoint);
DISCMC_NODISCARD discmc_status discmc_learning_extractor_restore(
    discmc_learning_extractor* extractor, const discmc_learning_extractor_checkpoint* checkpoint,
    discmc_memory memory, const discmc_sink* sink);

/* ---- several surfaces of a scan (surface_group.hpp, shared_output.hpp) ---- */

/* What is pushed to a group goes to all of its extractors, each of which has a threshold, a memory
 * and a sink of its own. A stream of slices needs none: it has several surfaces itself. */
typedef struct discmc_surface_group {
  uint64_t opaque[(sizeof(void*) == 8 ? 32 : 24) / 8];
} discmc_surface_group;

/* Begins with extractors that were started for slices of one size, with nothing pushed yet; Owner:
 * the caller, for as long as the scan lasts. width: voxels a row. */
void discmc_surface_group_start(discmc_surface_group* group, discmc_extractor* extractors,
                                uint32_t count, uint32_t width);

/* Each as the function of discmc_extractor, for all. DISCMC_MORE: some sink said "not now"; what a
 * push counts has gone to all. */
DISCMC_NODISCARD discmc_push_result discmc_surface_group_push_u8(discmc_surface_group* group,
                                                                 const uint8_t* samples,
                                                                 uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_surface_group_push_u16(discmc_surface_group* group,
                                                                  const uint16_t* samples,
                                                                  uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_surface_group_push_i16(discmc_surface_group* group,
                                                                  const int16_t* samples,
                                                                  uint32_t count, uint32_t stride);
/* With a row of bits for each: one behind the other, each of which begins with a byte. */
DISCMC_NODISCARD discmc_push_result discmc_surface_group_push_bits(discmc_surface_group* group,
                                                                   const uint8_t* bits);
DISCMC_NODISCARD discmc_push_result discmc_surface_group_skip_row(discmc_surface_group* group,
                                                                  uint8_t substitute);
DISCMC_NODISCARD discmc_status discmc_surface_group_resume(discmc_surface_group* group);
DISCMC_NODISCARD discmc_status discmc_surface_group_finish(discmc_surface_group* group);
DISCMC_NODISCARD discmc_status discmc_surface_group_abandon(discmc_surface_group* group);

/* One link for several encoders: their frames go out in turns, each of them whole. It holds a
 * frame. */
typedef struct discmc_shared_output {
  uint64_t opaque[(sizeof(void*) == 8 ? 288 : 272) / 8];
} discmc_shared_output;

/* Drops a frame that is held. */
void discmc_shared_output_start(discmc_shared_output* shared, discmc_byte_output output);
/* The output of every encoder, each with a channel of its own; before the start, or where that got
 * none, one without a write, with which encoders do not start. */
discmc_byte_output discmc_shared_output_output(discmc_shared_output* shared);
/* Hands over what is held. 0 when the output does not take all of it now: call again, as long as
 * there is hope, as on a dead link it stays so. */
DISCMC_NODISCARD uint8_t discmc_shared_output_flush(discmc_shared_output* shared);

/* ---- the decoder (decoder.hpp) ---- */

/* How a stream arrived. Lost counts grow when the next whole packet reveals the gap. Of a stream of
 * slices it has rows only, no region, fragment or total but skipped_rows: count regions in the sink
 * of a surface decoder. Flags are 0 or 1. */
typedef struct discmc_stream_report {
  uint8_t has_header;
  uint8_t holds_slices; /* as its header says: a slice decoder or a surface decoder takes it */
  uint8_t has_trailer;
  uint8_t abandoned;     /* the scan was ended before its time; the surface is closed */
  uint8_t is_unreadable; /* a packet was whole, but its records are of no known kind */
  uint8_t is_mixed;      /* packets of another scan, of the same name, were taken */
  uint8_t is_complete;   /* nothing is missing from header to trailer */
  uint64_t bytes;
  uint64_t packets; /* whole ones, repeated ones not counted */
  uint64_t repeated_packets;
  uint64_t damaged_packets; /* frames that are no packet, or fail their checksum */
  uint64_t foreign_packets; /* of another scan or channel; not counted above, and left alone */
  uint64_t lost_packets;    /* missing by their numbers */
  uint64_t regions;         /* delivered complete */
  uint64_t fragments;       /* loose ones delivered complete */
  uint64_t lost_pieces;     /* regions and fragments missing by the running count of both */
  uint64_t rows;            /* of bits, delivered */
  uint64_t lost_rows;       /* of bits, by where the next one is */
  uint64_t total_rows;      /* of bits: of the trailer */
  uint32_t slices;          /* of the trailer */
  discmc_statistics totals; /* of the trailer */
} discmc_stream_report;

/* The result of a push, and how many of the bytes it took. The rest must be pushed again. */
typedef struct discmc_decoded {
  discmc_status status;
  size_t bytes;
} discmc_decoded;

/* Reads one stream of regions, and hands its events to a sink. */
typedef struct discmc_decoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 1328 : 1256) / 8];
} discmc_decoder;

/* Begins a stream: the one of the first whole packet that comes on this channel, or
 * DISCMC_ANY_CHANNEL. Packets of other scans and channels are counted and left alone, so every
 * decoder of a link may get all bytes. For scan after scan push up to the next zero byte at a time;
 * when a push has answered DISCMC_OK and the report has_trailer, start anew (decoder.hpp, link.c).
 * Errors: DISCMC_BAD_SINK. */
DISCMC_NODISCARD discmc_status discmc_decoder_start(discmc_decoder* decoder,
                                                    const discmc_sink* sink, uint8_t channel);

/* Who takes packets of records; valid during the call. */
typedef struct discmc_records_packet_sink {
  void* context;
  void (*take)(void* context, const discmc_records_packet* packet);
} discmc_records_packet_sink;

/* Until told otherwise packets of whole regions go there in place of the events of their regions.
 * They come after the scan's start, and between two pieces. sink: null for none; Owner: the caller,
 * as long as the decoder is used. */
void discmc_decoder_pass_whole_regions_to(discmc_decoder* decoder,
                                          const discmc_records_packet_sink* sink);

/* Takes bytes, any number at a time. DISCMC_MORE: the sink said "not now", push the rest again, be
 * it none. DISCMC_WRONG_VERSION: nothing more of this stream is delivered. Errors: also
 * DISCMC_NOT_STARTED, and DISCMC_BAD_SINK: the sink said "never", as an encoder does that was not
 * started, or that gets anything before the header of its stream. Any bytes are safe. */
DISCMC_NODISCARD discmc_decoded discmc_decoder_push(discmc_decoder* decoder, const uint8_t* bytes,
                                                    size_t count);

/* Says that no byte follows: an unfinished region or fragment is reported lost. DISCMC_MORE as a
 * push. Errors: DISCMC_NOT_STARTED, DISCMC_BAD_SINK. */
DISCMC_NODISCARD discmc_status discmc_decoder_finish(discmc_decoder* decoder);

discmc_stream_header discmc_decoder_header(const discmc_decoder* decoder);
discmc_stream_report discmc_decoder_report(const discmc_decoder* decoder);

/* ---- the slice encoder (slice_encoder.hpp) ---- */

/* Takes the samples of a scan, and writes the stream of their bits. */
typedef struct discmc_slice_encoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 736 : 648) / 8];
} discmc_slice_encoder;

/* The bytes that a slice encoder takes. key_slice_interval: the slices from one key slice, which is
 * told without the ones before, to the next; 0 where only the first is one; key_slices.hpp has a
 * rule. 1 takes least memory, but makes the stream longer by half or more. Limit: the limits are
 * valid, and surfaces 1 to DISCMC_MAX_SURFACES. sizes.h has the same as a constant:
 * DISCMC_SLICE_ENCODER_BYTES_FOR(). */
uint64_t discmc_slice_encoder_bytes_for(const discmc_limits* limits, uint32_t key_slice_interval,
                                        uint32_t surfaces);

/* Begins a scan and its stream; the header, of which all is told here, is the first packet. Where
 * it has several surfaces each gets all samples; bits of the further ones are told by those of the
 * first. memory: at least discmc_slice_encoder_bytes_for(); Owner: the caller, for as long as the
 * scan lasts. Errors: DISCMC_BAD_LIMITS, DISCMC_BAD_LABEL (too many surfaces, too), DISCMC_BAD_SINK
 * (no write), DISCMC_TOO_LITTLE_MEMORY. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_start(discmc_slice_encoder* encoder,
                                                          const discmc_stream_header* header,
                                                          uint32_t key_slice_interval,
                                                          discmc_memory memory,
                                                          discmc_byte_output output);

/* Takes samples as discmc_extractor_push_u8() and its neighbours. */
DISCMC_NODISCARD discmc_push_result discmc_slice_encoder_push_u8(discmc_slice_encoder* encoder,
                                                                 const uint8_t* samples,
                                                                 uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_slice_encoder_push_u16(discmc_slice_encoder* encoder,
                                                                  const uint16_t* samples,
                                                                  uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_push_result discmc_slice_encoder_push_i16(discmc_slice_encoder* encoder,
                                                                  const int16_t* samples,
                                                                  uint32_t count, uint32_t stride);

/* Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0; of
 * several surfaces one row behind the other, each of which begins with a byte. Counts as `width`
 * samples, or 0 when it was not taken. Errors: as a push, and DISCMC_ROW_IN_PROGRESS. */
DISCMC_NODISCARD discmc_push_result discmc_slice_encoder_push_bits(discmc_slice_encoder* encoder,
                                                                   const uint8_t* bits);

/* Stands in for a row that never came; the stream says so. substitute: DISCMC_OFF or
 * DISCMC_PREVIOUS_ROW. Result and errors: as push_bits. */
DISCMC_NODISCARD discmc_push_result discmc_slice_encoder_skip_row(discmc_slice_encoder* encoder,
                                                                  uint8_t substitute);

/* Goes on after DISCMC_MORE, which it may answer again. Harmless at any other time. Errors:
 * DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_resume(discmc_slice_encoder* encoder);

/* Hands over what is there so far instead of waiting for a full packet; costs about 15 bytes of
 * stream a call. After DISCMC_MORE call it again. Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_flush(discmc_slice_encoder* encoder);

/* Sends an application record now, before the next row; its slice and row are filled in.
 * DISCMC_MORE: not taken yet, call again. Errors: DISCMC_NOT_STARTED, DISCMC_FINISHED,
 * DISCMC_BAD_RECORD. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_tell(discmc_slice_encoder* encoder,
                                                         const discmc_application_record* record);

/* Goes on with another output, as discmc_encoder_set_output(). The next slice is a key slice. */
void discmc_slice_encoder_set_output(discmc_slice_encoder* encoder, discmc_byte_output output);

/* Ends the scan and the stream. After DISCMC_MORE go on with resume. Errors: DISCMC_NOT_STARTED,
 * DISCMC_SLICE_IN_PROGRESS. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_finish(discmc_slice_encoder* encoder);

/* Ends the scan wherever it is: the stream says so, and the receiver takes the rest of the slice as
 * off. DISCMC_MORE as finish. Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_abandon(discmc_slice_encoder* encoder);

/* Where a scan and its stream are, as plain bytes: see checkpoint.hpp. */
typedef struct discmc_slice_encoder_checkpoint {
  uint64_t head[3];
  discmc_slice_encoder encoder;
} discmc_slice_encoder_checkpoint;

/* Writes down where scan and stream are, the stream at the beginning of a frame; with the first
 * discmc_slice_encoder_bytes_used() bytes of the memory that is all of both. DISCMC_MORE: resume
 * first. Errors: DISCMC_NOT_STARTED. */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_save(
    const discmc_slice_encoder* encoder, discmc_slice_encoder_checkpoint* checkpoint);

/* Goes on where a checkpoint was saved; discmc_slice_encoder_bytes() says how many bytes of stream
 * were before. memory: as discmc_extractor_restore(). Errors: DISCMC_TOO_LITTLE_MEMORY,
 * DISCMC_BAD_CHECKPOINT, DISCMC_BAD_SINK (no write). */
DISCMC_NODISCARD discmc_status discmc_slice_encoder_restore(
    discmc_slice_encoder* encoder, const discmc_slice_encoder_checkpoint* checkpoint,
    discmc_memory memory, discmc_byte_output output);

/* The bytes of stream so far, as discmc_encoder_bytes(). */
uint64_t discmc_slice_encoder_bytes(const discmc_slice_encoder* encoder);
/* So many bytes at the beginning of the caller's memory the scan uses. */
size_t discmc_slice_encoder_bytes_used(const discmc_slice_encoder* encoder);
/* Complete slices so far, and complete rows of the current one. */
uint32_t discmc_slice_encoder_slices(const discmc_slice_encoder* encoder);
uint32_t discmc_slice_encoder_rows(const discmc_slice_encoder* encoder);

/* ---- the slice decoder (slice_decoder.hpp) ---- */

/* The kinds of row events: every row of a scan in its order, of each surface in turn, and its end.
 */
enum {
  DISCMC_ROWS_START,       /* the first event: header */
  DISCMC_ROW,              /* slice, row, channel, bits */
  DISCMC_ROW_SKIPPED,      /* it never came to the encoder: as a row, with bits that stand in for
                            * it; repeated */
  DISCMC_ROWS_LOST,        /* so many rows of all were lost on the way: slice, row (of the first),
                            * count */
  DISCMC_ROWS_APPLICATION, /* the user's own data: application */
  DISCMC_ROWS_FINISH       /* the last event: slice (how many), abandoned */
};

/* One thing that a row sink is offered. Only the members that its kind names have a meaning. Flags
 * are 0 or 1. */
typedef struct discmc_row_event {
  uint8_t kind;
  uint8_t repeated; /* the row before stands in, not a row that is off */
  uint8_t abandoned;
  uint8_t channel;
  uint32_t slice;
  uint32_t row;
  uint64_t count;
  /* Owner: the decoder; valid during the call. */
  union {
    const uint8_t* bits; /* eight voxels a byte, the first in bit 0 */
    const discmc_stream_header* header;
    const discmc_application_record* application;
  } of;
} discmc_row_event;

/* Where rows go. Owner: the context is the caller's and must outlive the decoder; the sink is
 * copied. */
typedef struct discmc_row_sink {
  void* context;
  discmc_answer (*take)(void* context, const discmc_row_event* event);
} discmc_row_sink;

/* Reads one stream of bits, and hands its rows to a row sink. */
typedef struct discmc_slice_decoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 968 : 840) / 8];
} discmc_slice_decoder;

/* The bytes that a slice decoder takes for slices of this size. Limit: as of the slice encoder.
 * sizes.h has the same as a constant: DISCMC_SLICE_DECODER_BYTES_FOR(). */
uint64_t discmc_slice_decoder_bytes_for(const discmc_limits* limits, uint32_t surfaces);

/* Begins a stream. memory: at least discmc_slice_decoder_bytes_for() of what the header will tell,
 * or none before it is known; Owner: the caller, as long as the decoder is used. channel: as of the
 * decoder; the rows of all surfaces of its stream are handed out. Errors: DISCMC_BAD_SINK. */
DISCMC_NODISCARD discmc_status discmc_slice_decoder_start(discmc_slice_decoder* decoder,
                                                          discmc_memory memory,
                                                          const discmc_row_sink* sink,
                                                          uint8_t channel);

/* Takes bytes as discmc_decoder_push(). DISCMC_TOO_LITTLE_MEMORY: the header tells of larger slices
 * than the memory serves: give_memory, and push the rest. Any bytes are safe. */
DISCMC_NODISCARD discmc_decoded discmc_slice_decoder_push(discmc_slice_decoder* decoder,
                                                          const uint8_t* bytes, size_t count);

/* Goes on with other memory, of discmc_slice_decoder_bytes_for(), after DISCMC_TOO_LITTLE_MEMORY.
 * Errors: DISCMC_NOT_STARTED, DISCMC_TOO_LITTLE_MEMORY, DISCMC_WRONG_VERSION. */
DISCMC_NODISCARD discmc_status discmc_slice_decoder_give_memory(discmc_slice_decoder* decoder,
                                                                discmc_memory memory);

/* Tells that no byte follows. DISCMC_MORE and errors as a push. */
DISCMC_NODISCARD discmc_status discmc_slice_decoder_finish(discmc_slice_decoder* decoder);

discmc_stream_header discmc_slice_decoder_header(const discmc_slice_decoder* decoder);
discmc_stream_report discmc_slice_decoder_report(const discmc_slice_decoder* decoder);

/* ---- the surface decoder (surface_decoder.hpp) ---- */

/* The lost rows that a call skips at most, as a hostile stream can claim any number of them. */
enum { DISCMC_MOST_SKIPPED_ROWS = 65536 };

/* Makes events of a stream of either kind: of bits those of an extractor that is given the same
 * rows. Rows that were lost on the way are skipped rows. */
typedef struct discmc_surface_decoder {
  uint64_t opaque[(sizeof(void*) == 8 ? 2832 : 2544) / 8];
} discmc_surface_decoder;

/* The least memory for streams of bits of this size. Limit: as of the slice encoder. sizes.h has
 * the same as a constant: DISCMC_MINIMUM_SURFACE_BYTES(). */
uint64_t discmc_minimum_surface_bytes(const discmc_limits* limits, uint32_t surfaces);

/* Begins a stream. memory: none for streams of regions, or before it is known; at least
 * discmc_minimum_surface_bytes() of what the header of a stream of bits will tell, and more for
 * fewer loose fragments (surface_decoder.hpp); Owner: the caller, as long as the decoder is used.
 * channel: as of the decoder; of several surfaces of one stream that one, or the first: for all of
 * them have as many decoders, each with all the memory, and give all bytes to each. Errors:
 * DISCMC_BAD_SINK. */
DISCMC_NODISCARD discmc_status discmc_surface_decoder_start(discmc_surface_decoder* decoder,
                                                            discmc_memory memory,
                                                            const discmc_sink* sink,
                                                            uint8_t channel);

/* As discmc_decoder_pass_whole_regions_to(). */
void discmc_surface_decoder_pass_whole_regions_to(discmc_surface_decoder* decoder,
                                                  const discmc_records_packet_sink* sink);

/* Takes bytes as discmc_slice_decoder_push(). DISCMC_MORE: also that there are more lost rows to
 * skip. */
DISCMC_NODISCARD discmc_decoded discmc_surface_decoder_push(discmc_surface_decoder* decoder,
                                                            const uint8_t* bytes, size_t count);

/* As discmc_slice_decoder_give_memory(), with discmc_minimum_surface_bytes() or more. */
DISCMC_NODISCARD discmc_status discmc_surface_decoder_give_memory(discmc_surface_decoder* decoder,
                                                                  discmc_memory memory);

/* As discmc_decoder_finish(); errors as a push. Of a stream of bits that has no end the surface has
 * none either. */
DISCMC_NODISCARD discmc_status discmc_surface_decoder_finish(discmc_surface_decoder* decoder);

discmc_stream_header discmc_surface_decoder_header(const discmc_surface_decoder* decoder);
discmc_stream_report discmc_surface_decoder_report(const discmc_surface_decoder* decoder);

/* ---- the joiner (joiner.hpp) ---- */

/* What is known of the order in which events come: that of one sweep, or fragments in any order, of
 * one stream or several. */
enum { DISCMC_SWEEP_ORDER, DISCMC_ANY_ORDER };

/* How much a joiner has room for. Limit: at least 1 of each. */
typedef struct discmc_join_capacities {
  uint32_t fragments; /* chains not closed yet, and rings that wait; Limit: 2^28 */
  uint32_t runs;      /* of all of them; Limit: 2^32 - 2 */
} discmc_join_capacities;

/* What a joiner has done since its start. */
typedef struct discmc_join_report {
  uint64_t fragments; /* that came */
  uint64_t invalid;   /* of them: left out, for an incidence, direction or run that is none */
  uint64_t regions;   /* delivered, their outer rings joined of fragments */
  uint64_t rings;     /* joined of fragments and delivered in any region */
  uint64_t unmatched; /* left over in the end, or their place was taken: what was lost */
  uint64_t passed;    /* chains passed on for lack of memory */
} discmc_join_report;

/* Joins loose fragments to regions. */
typedef struct discmc_joiner {
  uint64_t opaque[(sizeof(void*) == 8 ? 312 : 272) / 8];
} discmc_joiner;

/* The bytes that a joiner takes, the least, and the default split of a number of bytes. sizes.h has
 * the same as constants: DISCMC_JOINER_BYTES_FOR(), DISCMC_JOINER_MINIMUM_BYTES and, for
 * `const discmc_join_capacities c = `, DISCMC_JOINER_DEFAULT_CAPACITIES(). */
uint64_t discmc_joiner_bytes_for(const discmc_join_capacities* capacities);
uint64_t discmc_joiner_minimum_bytes(void);
discmc_join_capacities discmc_joiner_default_capacities(uint64_t bytes);

/* Begins anew. capacities: may be null, for the default split of the memory. memory: Owner: the
 * caller, for as long as events are taken. order: DISCMC_SWEEP_ORDER or DISCMC_ANY_ORDER. Errors:
 * DISCMC_BAD_SINK, DISCMC_BAD_CAPACITIES, DISCMC_TOO_LITTLE_MEMORY; then nothing has changed. */
DISCMC_NODISCARD discmc_status discmc_joiner_start(discmc_joiner* joiner,
                                                   const discmc_join_capacities* capacities,
                                                   discmc_memory memory, const discmc_sink* sink,
                                                   uint8_t order);

/* Takes an event; joiner points to a discmc_joiner, so that this is the `take` of a sink whose
 * context is one: {&joiner, discmc_joiner_take}. DISCMC_NEVER before discmc_joiner_start(), and
 * where the sink says so. Any events are safe. */
discmc_answer discmc_joiner_take(void* joiner, const discmc_event* event);

/* Tells that no event follows, and delivers what waits. DISCMC_MORE: the sink said "not now", call
 * again. Errors: DISCMC_NOT_STARTED; DISCMC_BAD_SINK (it said "never"); DISCMC_TOO_LITTLE_MEMORY
 * when memory was short at any time: then the sink got fragments that another joiner can join. */
DISCMC_NODISCARD discmc_status discmc_joiner_finish(discmc_joiner* joiner);

discmc_join_report discmc_joiner_report(const discmc_joiner* joiner);
discmc_join_capacities discmc_joiner_capacities(const discmc_joiner* joiner);
/* The most that was held at once. */
discmc_join_capacities discmc_joiner_high_water(const discmc_joiner* joiner);

/* Adds the totals of a scan to those of others, such as the slabs of one volume. */
void discmc_add_statistics(discmc_statistics* sum, const discmc_statistics* other);

/* ---- the lattice (lattice.hpp) ---- */

/* An incidence is a signed normal as a number, 13 + x + 3 y + 9 z for components -1, 0 or 1; it
 * points from on to off, and DISCMC_NO_INCIDENCE, the zero vector, is none. A link is one of 18
 * vectors between neighbouring vertices. A direction is a link's number within the planes of an
 * incidence, counter-clockwise seen from the tip of the normal. */
enum {
  DISCMC_NO_INCIDENCE = 13,
  DISCMC_INCIDENCE_CODES = 27,
  DISCMC_LINK_CODES = 18,
  DISCMC_MAX_DIRECTIONS = 8,
  DISCMC_NO_DIRECTION = 255
};

discmc_vertex discmc_normal(uint8_t incidence);
/* The incidence of a normal. Limit: components are -1, 0 or 1. */
uint8_t discmc_incidence_of(discmc_vertex normal);

uint8_t discmc_opposite(uint8_t incidence);

/* The vector of a link, and the link that leads back. Units: half-steps. */
discmc_vertex discmc_link_vector(uint8_t link);
uint8_t discmc_opposite_link(uint8_t link);

/* How many directions the planes of an incidence have: 8 axis, 4 diagonal, 6 corner. */
uint8_t discmc_direction_count(uint8_t incidence);
/* The vector and the link of a direction, and the direction half a round on. */
discmc_vertex discmc_direction_vector(uint8_t incidence, uint8_t direction);
uint8_t discmc_link_of(uint8_t incidence, uint8_t direction);
uint8_t discmc_opposite_direction(uint8_t incidence, uint8_t direction);
/* The direction of a link, or DISCMC_NO_DIRECTION when it lies in none of the planes. */
uint8_t discmc_direction_of(uint8_t incidence, uint8_t link);
/* The same for a link's vector. Cost: a search; for tables. */
uint8_t discmc_direction_of_vector(uint8_t incidence, discmc_vertex vector);
/* The turn from one direction to the next as a count of directions, from -n/2 (a half turn counts
 * as negative) to n/2 - 1, where n is their number. Counter-clockwise is positive. */
int discmc_turn(uint8_t incidence, uint8_t from, uint8_t to);

/* ---- chains (chain.hpp) ---- */

#define DISCMC_RUN_MAX_LENGTH UINT32_C(0x0FFFFFFF)

/* A straight run. Limit: length 1 to DISCMC_RUN_MAX_LENGTH links, direction below
 * discmc_direction_count(). A run of 0 is empty. */
discmc_run discmc_run_straight(uint8_t direction, uint32_t length);
/* Its direction, and its length in links. */
uint8_t discmc_run_direction(discmc_run run);
uint32_t discmc_run_length(discmc_run run);
/* Appends the other run, when both have one direction and are short enough together: 1 if it did,
 * else 0. */
uint8_t discmc_run_absorb(discmc_run* run, discmc_run other);

/* The chain's end relative to its start. Limit: no coordinate of it overflows. */
discmc_vertex discmc_displacement(uint8_t incidence, const discmc_run* runs, uint32_t count);
/* Whether the chain ends where it starts. */
uint8_t discmc_is_closed(uint8_t incidence, const discmc_run* runs, uint32_t count);
/* Reverses the chain in place. */
void discmc_reverse(uint8_t incidence, discmc_run* runs, uint32_t count);
/* Twice the area of a closed chain times the length of its incidence's normal: positive for an
 * outer ring, negative for a hole. Units: square half-steps. */
int64_t discmc_twice_area(uint8_t incidence, const discmc_run* runs, uint32_t count);
/* The links of a chain, and so the vertices of a closed one. */
uint64_t discmc_link_count(const discmc_run* runs, uint32_t count);

/* ---- chains in their plane (plane.hpp). Coordinates wrap: any start and any runs are safe ---- */

/* 1 when a number is an incidence, a direction in its planes, a run along these, else 0. */
uint8_t discmc_is_incidence(uint8_t incidence);
uint8_t discmc_is_direction_of(uint8_t incidence, uint8_t direction);
uint8_t discmc_is_run_of(uint8_t incidence, discmc_run run);

/* Where a run leads. */
discmc_vertex discmc_after_run(uint8_t incidence, discmc_vertex from, discmc_run run);
/* The offset n.p of the plane that a vertex lies in. */
int32_t discmc_plane_offset(uint8_t incidence, discmc_vertex vertex);

/* A point or a vector of a plane, projected along an axis that the plane does not contain. */
typedef struct discmc_plane_point {
  int64_t u, v;
} discmc_plane_point;

discmc_plane_point discmc_projected(uint8_t incidence, discmc_vertex vertex);
/* A point of the region that a ring bounds, close to the middle of the ring's first link: to the
 * left of it, for outer rings and holes alike. No ring of a surface passes through it. Units:
 * eighths of a half-step. */
discmc_plane_point discmc_point_beside(uint8_t incidence, discmc_vertex start, uint8_t first);
/* Whether the ray from a point along u meets a run of a ring: where it meets an odd number of them
 * the point lies inside. Units of the point: eighths of a half-step. */
uint8_t discmc_meets_ray(uint8_t incidence, discmc_vertex from, discmc_run run,
                         discmc_plane_point point);

/* ---- polygons (polygon.hpp) ---- */

/* Writes the vertices of a closed chain, one for every link, beginning with the start. vertices:
 * discmc_link_count() of them; Owner: the caller. */
void discmc_unfold(uint8_t incidence, discmc_vertex start, const discmc_run* runs, uint32_t count,
                   discmc_vertex* vertices);

/* discmc_twice_area() of a ring of vertices. */
int64_t discmc_twice_area_of_ring(uint8_t incidence, const discmc_vertex* vertices, uint32_t count);

/* Where simple rings go: of three vertices or more, valid during the call. */
typedef struct discmc_ring_receiver {
  void* context;
  void (*take)(void* context, const discmc_vertex* vertices, uint32_t count);
} discmc_ring_receiver;

/* Splits a closed ring of vertices into simple rings. vertices: overwritten. scratch: 2 * count
 * words. Owner: the caller. Cost: count * log(count) comparisons. */
void discmc_split_ring(discmc_vertex* vertices, uint32_t count, uint32_t* scratch,
                       const discmc_ring_receiver* receiver);

/* Whether vertex i of a ring is a corner: the links before and after it differ. */
uint8_t discmc_is_corner(const discmc_vertex* vertices, uint32_t count, uint32_t i);

/* Keeps, in order and in place, the corners of a ring and every vertex that keep() returns not 0
 * for; returns how many. keep: may be null. */
uint32_t discmc_keep_corners(discmc_vertex* vertices, uint32_t count,
                             uint8_t (*keep)(void* context, const discmc_vertex* vertex),
                             void* context);

/* ---- normals (normal.hpp) ---- */

/* A vector of any length and unit. */
typedef struct discmc_long_vector {
  int64_t x, y, z;
} discmc_long_vector;

/* A unit vector in fixed point; 16384 is one. All zero where there is no normal. */
typedef struct discmc_unit_normal {
  int16_t x, y, z;
} discmc_unit_normal;

/* What the components of a normal are multiplied by where voxels are not cubes. */
typedef struct discmc_axis_weights {
  int32_t x, y, z;
} discmc_axis_weights;

/* The weights of a spacing. Units: any; negative where an axis is mirrored. Where one is zero, as
 * in a header that does not know it, voxels are taken as cubes. */
discmc_axis_weights discmc_axis_weights_of(const int32_t spacing[3]);
/* A vector in units of voxels, such as a normal or a gradient, as it is in space. */
discmc_long_vector discmc_weighted(discmc_long_vector vector, discmc_axis_weights weights);

/* The unit vector of a direction, of any length; none for the zero vector. Error: at most 0.006
 * degrees; of an octahedral one 0.96. */
discmc_unit_normal discmc_unit_normal_along(discmc_long_vector direction);
discmc_octahedral_normal discmc_octahedral_normal_along(discmc_long_vector direction);
/* The unit vector that an octahedral one stands for. Any bytes are safe. */
discmc_unit_normal discmc_unit_normal_of(discmc_octahedral_normal normal);

/* A polygon's part in the normals of its vertices: its normal, with twelve times its area for a
 * length. twice_area: the sum over its rings. Units: half-steps. */
discmc_long_vector discmc_area_vector(uint8_t incidence, int64_t twice_area);

/* ---- normals in a second pass (sample_window.hpp) ---- */

/* The last four slices, which are shown again in order. */
typedef struct discmc_sample_window {
  uint64_t opaque[(sizeof(void*) == 8 ? 56 : 48) / 8];
} discmc_sample_window;

/* The bytes that a window takes. sample_bytes: 1 or 2. sizes.h has the same as a constant:
 * DISCMC_SAMPLE_WINDOW_BYTES_FOR(). */
uint64_t discmc_sample_window_bytes_for(const discmc_limits* limits, uint32_t sample_bytes);

/* Begins a pass over samples of a type. memory: at least discmc_sample_window_bytes_for(); Owner:
 * the caller, as long as the window is in use. Errors: DISCMC_BAD_LIMITS, DISCMC_TOO_LITTLE_MEMORY;
 * then nothing has changed. */
DISCMC_NODISCARD discmc_status discmc_sample_window_start_u8(discmc_sample_window* window,
                                                             const discmc_limits* limits,
                                                             discmc_memory memory);
DISCMC_NODISCARD discmc_status discmc_sample_window_start_u16(discmc_sample_window* window,
                                                              const discmc_limits* limits,
                                                              discmc_memory memory);
DISCMC_NODISCARD discmc_status discmc_sample_window_start_i16(discmc_sample_window* window,
                                                              const discmc_limits* limits,
                                                              discmc_memory memory);

/* Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
 * samples: Owner: the caller; free again when the call returns. stride: from one sample to the
 * next, in samples. Errors: DISCMC_NOT_STARTED, for this type; DISCMC_FINISHED, after the end. */
DISCMC_NODISCARD discmc_status discmc_sample_window_push_u8(discmc_sample_window* window,
                                                            const uint8_t* samples, uint32_t count,
                                                            uint32_t stride);
DISCMC_NODISCARD discmc_status discmc_sample_window_push_u16(discmc_sample_window* window,
                                                             const uint16_t* samples,
                                                             uint32_t count, uint32_t stride);
DISCMC_NODISCARD discmc_status discmc_sample_window_push_i16(discmc_sample_window* window,
                                                             const int16_t* samples, uint32_t count,
                                                             uint32_t stride);
/* Says that no slice follows. */
void discmc_sample_window_end(discmc_sample_window* window);

/* 1 when discmc_sample_window_downhill() can tell: the slices around the vertex and one more on
 * either side, all that the volume has, are held. Once they have passed it stays 0. */
uint8_t discmc_sample_window_covers(const discmc_sample_window* window, discmc_vertex vertex);
/* The direction in which the samples fall, from on to off; zero where they are level, and outside
 * the volume. Units: samples a voxel, times 4 for a midpoint and 16 for a centroid. Limit: the
 * window covers the vertex. */
discmc_long_vector discmc_sample_window_downhill(const discmc_sample_window* window,
                                                 discmc_vertex vertex);

/* ---- facets (facet_table.hpp): the lookup table, for tools. No scan needs these ---- */

/* A facet is one byte: its incidence in the upper 5 bits, its place in plane and cell in the lower
 * 3. A configuration is the corner bits of a cell, bit c for corner (c & 1, c >> 1 & 1, c >> 2). */
typedef struct discmc_facet_ring {
  uint32_t count;            /* 3, 4, or 0 for a code that is no facet */
  discmc_vertex vertices[4]; /* from the cell's corner 0; counter-clockwise from the normal's tip */
} discmc_facet_ring;

/* What is counted of a cell. */
typedef struct discmc_cell_facts {
  uint8_t facets;            /* 0 to 7 */
  uint8_t classic_triangles; /* of classic Marching Cubes */
  uint8_t enclosed;          /* volume on the on side; Units: 48ths of a cell */
} discmc_cell_facts;

discmc_cell_facts discmc_facts_of(uint8_t configuration);
/* Facet i of a configuration. Limit: i is below the number of its facets. */
uint8_t discmc_facet_at(uint8_t configuration, uint32_t i);
uint8_t discmc_incidence_of_facet(uint8_t facet);
discmc_facet_ring discmc_ring_of_facet(uint8_t facet);

/* What lies on the other side of a facet's edge when it belongs to the same plane. */
typedef struct discmc_neighbour {
  discmc_vertex cell; /* that it lies in, as an offset in cells; all zero for the same cell */
  uint8_t facet;
} discmc_neighbour;

/* The facet of the same incidence that shares an edge, from that vertex of the facet's ring to the
 * next. Limit: edge is below the count of the ring. Cost: a search. */
discmc_neighbour discmc_across_edge(uint8_t facet, uint32_t edge);

/* ---- the front end: from the sensor to the extractor ---- */

/* Rows between an interrupt and a task (row_ring.hpp): the sensor's DMA controller writes each row
 * where it stays until the extractor has read it. One producer and one consumer, which need not
 * mask interrupts. */
typedef struct discmc_row_ring {
  uint64_t opaque[(sizeof(void*) == 8 ? 56 : 48) / 8];
} discmc_row_ring;

/* What comes next on the consumer's side. */
enum {
  DISCMC_NEXT_NOTHING, /* it has not come yet */
  DISCMC_NEXT_ROW,     /* discmc_row_ring_row() holds it */
  DISCMC_NEXT_LOST,    /* a row that was lost: skip it */
  DISCMC_NEXT_END      /* no row follows */
};

/* The memory of a ring. sizes.h has the same as a constant: DISCMC_ROW_RING_BYTES_FOR(). Units:
 * bytes. */
uint64_t discmc_row_ring_bytes_for(uint32_t row_bytes, uint32_t rows);

/* Begins a scan, with room for so many rows, which lie one after the other from the beginning of
 * the memory, each aligned to four bytes. memory: at least discmc_row_ring_bytes_for(); Owner: the
 * caller, for as long as the ring is in use. Limit: neither side is at work. Errors:
 * DISCMC_BAD_CAPACITIES (no rows, empty ones, or 4 GiB of them), DISCMC_TOO_LITTLE_MEMORY; then
 * nothing has changed. */
DISCMC_NODISCARD discmc_status discmc_row_ring_start(discmc_row_ring* ring, uint32_t row_bytes,
                                                     uint32_t rows, discmc_memory memory);

/* The producer's: the row to fill next, or one that comes `ahead` rows later; null while there is
 * no room for it. It has been filled. So many rows were lost before the one that is filled next;
 * Limit: fewer than 2^31 in succession. No row follows. The number of the row that comes next,
 * modulo 2^32. */
void* discmc_row_ring_free_row(const discmc_row_ring* ring, uint32_t ahead);
void discmc_row_ring_fill(discmc_row_ring* ring);
void discmc_row_ring_lose(discmc_row_ring* ring, uint32_t rows);
void discmc_row_ring_end(discmc_row_ring* ring);
uint32_t discmc_row_ring_came(const discmc_row_ring* ring);

/* The consumer's: what comes next. The bytes of that row, which may be changed in place. Goes on
 * behind a row, or a lost one. The number of what comes next, and how many were lost before it. */
uint8_t discmc_row_ring_next(const discmc_row_ring* ring);
void* discmc_row_ring_row(const discmc_row_ring* ring);
void discmc_row_ring_pass(discmc_row_ring* ring);
uint32_t discmc_row_ring_passed(const discmc_row_ring* ring);
uint32_t discmc_row_ring_lost(const discmc_row_ring* ring);

/* How samples are packed: MIPI CSI-2's RAW10 and RAW12, and Mono10p to Mono12Packed of GenICam,
 * byte for byte in packed_samples.hpp. */
enum {
  DISCMC_RAW10,
  DISCMC_RAW12,
  DISCMC_MONO10P,
  DISCMC_MONO12P,
  DISCMC_MONO10PMSB,
  DISCMC_MONO12PMSB,
  DISCMC_MONO12_PACKED
};

/* The bytes that discmc_unpack() reads for so many samples: whole groups. Limit: count <= 2^31. */
uint32_t discmc_packed_bytes(uint8_t packing, uint32_t count);

/* Unpacks a row, or a part of one that begins with a group. samples: room for count; it may begin
 * where `packed` begins, and must not overlap it otherwise; Owner: the caller. Limit: packing is
 * one of the above; of another nothing is written. */
void discmc_unpack(uint8_t packing, const uint8_t* packed, uint32_t count, uint16_t* samples);

/* Writes a bit a sample, on where sample >= threshold, eight a byte, the first in bit 0, as
 * ..._push_bits() takes them (threshold_row.hpp): for thresholds that change from row to row. bits:
 * room for count / 8 bytes, rounded up; Owner: the caller. stride: from one sample to the next. */
void discmc_threshold_row_u8(const uint8_t* samples, uint32_t count, int32_t threshold,
                             uint8_t* bits, uint32_t stride);
void discmc_threshold_row_u16(const uint16_t* samples, uint32_t count, int32_t threshold,
                              uint8_t* bits, uint32_t stride);
void discmc_threshold_row_i16(const int16_t* samples, uint32_t count, int32_t threshold,
                              uint8_t* bits, uint32_t stride);

/* The same less an offset for each column: on where sample - offsets[x] >= threshold. */
void discmc_threshold_row_less_u8(const uint8_t* samples, const int16_t* offsets, uint32_t count,
                                  int32_t threshold, uint8_t* bits);
void discmc_threshold_row_less_u16(const uint16_t* samples, const int16_t* offsets, uint32_t count,
                                   int32_t threshold, uint8_t* bits);
void discmc_threshold_row_less_i16(const int16_t* samples, const int16_t* offsets, uint32_t count,
                                   int32_t threshold, uint8_t* bits);

/* A part of what a sensor delivers (row_picker.hpp): of an axis `count` voxels, each `step` behind
 * the one before; DISCMC_REST is as many as there are. */
typedef struct discmc_picked_range {
  uint32_t first, count, step;
} discmc_picked_range;
#define DISCMC_REST UINT32_MAX

/* Tells of each row that comes whether it is picked, and what of it. */
typedef struct discmc_row_picker {
  uint64_t opaque[56 / 8];
} discmc_row_picker;

/* Begins a volume. axes: of x, y and z. Errors: DISCMC_BAD_LIMITS (of the slices that come; nothing
 * is picked of an axis, or more than there is, or by a step of 0); then nothing has changed. */
DISCMC_NODISCARD discmc_status discmc_row_picker_start(discmc_row_picker* picker,
                                                       const discmc_limits* incoming,
                                                       const discmc_picked_range* axes);

/* The size of what is picked. Whether the next row that comes is picked, to be called once for
 * each, lost ones too. Whether none that still comes is. */
discmc_limits discmc_row_picker_limits(const discmc_row_picker* picker);
uint8_t discmc_row_picker_next(discmc_row_picker* picker);
uint8_t discmc_row_picker_is_done(const discmc_row_picker* picker);

/* Of a row that is picked: its first sample, how many, and from one to the next. */
uint32_t discmc_row_picker_first(const discmc_row_picker* picker);
uint32_t discmc_row_picker_count(const discmc_row_picker* picker);
uint32_t discmc_row_picker_step(const discmc_row_picker* picker);

/* The same of a row of bits. picked: room for discmc_row_picker_count() / 8 bytes, rounded up; it
 * may be `bits`. */
void discmc_row_picker_pick_bits(const discmc_row_picker* picker, const uint8_t* bits,
                                 uint8_t* picked);

/* Blocks of samples become their mean (block_means.hpp). Use the functions of one type of sample
 * with an object. */
typedef struct discmc_block_means {
  uint64_t opaque[(sizeof(void*) == 8 ? 80 : 72) / 8];
} discmc_block_means;
enum { DISCMC_MAX_BLOCK_EXTENT = 16 };

/* The memory for blocks of `extent` samples each way, of so many bytes a sample. sizes.h has the
 * same as a constant: DISCMC_BLOCK_MEANS_BYTES_FOR(). */
uint64_t discmc_block_means_bytes_for(const discmc_limits* incoming, uint32_t extent,
                                      uint32_t sample_bytes);

/* Begins a volume. memory: at least discmc_block_means_bytes_for(); Owner: the caller, as long as
 * this is in use. Limit: extent 1 to DISCMC_MAX_BLOCK_EXTENT. Errors: DISCMC_BAD_LIMITS,
 * DISCMC_TOO_LITTLE_MEMORY; then it is not started. */
DISCMC_NODISCARD discmc_status discmc_block_means_start_u8(discmc_block_means* means,
                                                           const discmc_limits* incoming,
                                                           uint32_t extent, discmc_memory memory);
DISCMC_NODISCARD discmc_status discmc_block_means_start_u16(discmc_block_means* means,
                                                            const discmc_limits* incoming,
                                                            uint32_t extent, discmc_memory memory);
DISCMC_NODISCARD discmc_status discmc_block_means_start_i16(discmc_block_means* means,
                                                            const discmc_limits* incoming,
                                                            uint32_t extent, discmc_memory memory);

/* The size of what comes out. */
discmc_limits discmc_block_means_limits(const discmc_block_means* means);

/* Takes the next row, and returns the row of means that is complete with it, or null; Owner: this,
 * until the next call. Then, after the last whole slice, the rows that are left, or null. */
const uint8_t* discmc_block_means_push_u8(discmc_block_means* means, const uint8_t* samples);
const uint16_t* discmc_block_means_push_u16(discmc_block_means* means, const uint16_t* samples);
const int16_t* discmc_block_means_push_i16(discmc_block_means* means, const int16_t* samples);
const uint8_t* discmc_block_means_drain_u8(discmc_block_means* means);
const uint16_t* discmc_block_means_drain_u16(discmc_block_means* means);
const int16_t* discmc_block_means_drain_i16(discmc_block_means* means);

/* A voxel is on where most of the 3 x 3 x 3 around it are (majority_filter.hpp). */
typedef struct discmc_majority_filter {
  uint64_t opaque[(sizeof(void*) == 8 ? 64 : 48) / 8];
} discmc_majority_filter;

/* The memory of a filter. sizes.h has the same as a constant: DISCMC_MAJORITY_FILTER_BYTES_FOR().
 */
uint64_t discmc_majority_filter_bytes_for(const discmc_limits* limits);

/* Begins a volume. memory: at least discmc_majority_filter_bytes_for(); Owner: the caller, as long
 * as the filter is in use. Errors: DISCMC_BAD_LIMITS, DISCMC_TOO_LITTLE_MEMORY; then it is not
 * started. */
DISCMC_NODISCARD discmc_status discmc_majority_filter_start(discmc_majority_filter* filter,
                                                            const discmc_limits* limits,
                                                            discmc_memory memory);

/* Takes the next row, eight voxels a byte, the first in bit 0. Returns the row that is due, a slice
 * and a row later, or null; Owner: the filter, until the next call. Then, after the last whole
 * slice, the rows that are left, or null. */
const uint8_t* discmc_majority_filter_push(discmc_majority_filter* filter, const uint8_t* bits);
const uint8_t* discmc_majority_filter_drain(discmc_majority_filter* filter);

#ifdef __cplusplus
}
#endif

#endif

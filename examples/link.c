/* Both ends of a slow link that fails, in C: link.cpp once more, which says why. It prints the
 * same. */
#include <discmc/discmc.h>
#include <stdio.h>
#include <string.h>

enum { SIZE = 48, SURFACES = 2 }; /* voxels a row, rows a slice, slices */
enum { TIME_STAMP = 1 };          /* a kind of record: the application's own, below 240 */

/* ---- the receiver ---- */

/* Of one surface. Two of one stream are two decoders, which both get all bytes. */
typedef struct receiver {
  discmc_surface_decoder decoder;
  uint8_t memory[256 * 1024];
  uint8_t channel;
  unsigned regions, lost_rows, milliseconds, complete_scans;
  discmc_placement placement;
} receiver;

static receiver receivers[SURFACES];

static discmc_answer receiver_take(void* context, const discmc_event* event) {
  receiver* const self = context;
  if (event->kind == DISCMC_REGION_END) ++self->regions;
  if (event->kind == DISCMC_SKIPPED) ++self->lost_rows; /* the device skips none */
  if (event->kind == DISCMC_APPLICATION) {
    const discmc_application_record* const record = event->of.application;
    (void)!discmc_read_placement(record, &self->placement); /* if it is one */
    if (record->kind == TIME_STAMP && record->count == 2)
      self->milliseconds = record->bytes[0] + 256U * record->bytes[1];
  }
  return DISCMC_TAKEN;
}

static int receiver_start(receiver* self, uint8_t channel) {
  const discmc_memory memory = {self->memory, sizeof self->memory};
  const discmc_sink sink = {self, receiver_take};
  self->channel = channel;
  self->regions = self->lost_rows = 0;
  return discmc_surface_decoder_start(&self->decoder, memory, &sink, channel) == DISCMC_OK;
}

static int receiver_end_scan(receiver* self) {
  printf("scan %d, channel %d: %u regions, %u rows lost, the last stamp %u ms, x from %.1f mm\n",
         discmc_surface_decoder_header(&self->decoder).scan, self->channel, self->regions,
         self->lost_rows, self->milliseconds, (double)self->placement.origin_nm[0] / 1e6);
  if (discmc_surface_decoder_report(&self->decoder).is_complete) ++self->complete_scans;
  return receiver_start(self, self->channel);
}

/* A decoder takes one stream. So it gets no more than a frame at a time, up to the zero that ends
 * it: behind a trailer the next scan begins. */
static int receiver_push(receiver* self, const uint8_t* bytes, size_t count) {
  size_t taken = 0;
  while (taken < count) {
    const uint8_t* const zero = memchr(bytes + taken, 0, count - taken);
    const size_t end = zero == NULL ? count : (size_t)(zero - bytes) + 1;
    discmc_decoded decoded = {DISCMC_MORE, 0}; /* it may be so of many lost rows */
    for (; decoded.status == DISCMC_MORE; taken += decoded.bytes)
      decoded = discmc_surface_decoder_push(&self->decoder, bytes + taken, end - taken);
    if (decoded.status != DISCMC_OK) return 0;
    if (discmc_surface_decoder_report(&self->decoder).has_trailer && !receiver_end_scan(self))
      return 0;
  }
  return 1;
}

/* ---- the link ---- */

static int radio_works = 1;

/* Takes what there is room for, and nothing while there is no link. */
static size_t radio_write(void* context, const uint8_t* bytes, size_t count) {
  const size_t taken = count < 16 ? count : 16;
  int i;
  (void)context;
  if (!radio_works) return 0;
  for (i = 0; i < SURFACES; ++i)
    if (!receiver_push(&receivers[i], bytes, taken)) fputs("a receiver gives up\n", stderr);
  return taken;
}

static const discmc_byte_output radio = {NULL, radio_write};
static const discmc_byte_output nowhere = {NULL, NULL};

/* ---- the device ---- */

enum { KEY_SLICES = 8 }; /* a slice takes 25 bytes here, so eight are a packet */

static discmc_slice_encoder encoder;
static uint8_t memory[DISCMC_SLICE_ENCODER_BYTES_FOR(SIZE, SIZE, KEY_SLICES, SURFACES)];

static int is_dropping = 0;
static uint64_t dropped_from = 0;

/* Whether to ask again. When the radio has taken nothing for long, the link is dead: what comes is
 * dropped until it is back. */
static int waits(discmc_status status) {
  static unsigned refusals = 0;
  refusals = status == DISCMC_MORE ? refusals + 1 : 0;
  if (refusals == 100) {
    is_dropping = 1;
    dropped_from = discmc_slice_encoder_bytes(&encoder);
    discmc_slice_encoder_set_output(&encoder, nowhere);
  }
  return refusals > 0; /* sleep here */
}

static void take_up_again(void) {
  is_dropping = 0;
  discmc_slice_encoder_set_output(&encoder, radio);
  printf("scan 1: no link for %u bytes\n",
         (unsigned)(discmc_slice_encoder_bytes(&encoder) - dropped_from));
}

static int succeeds(discmc_status status) {
  while (waits(status)) status = discmc_slice_encoder_resume(&encoder);
  return status == DISCMC_OK;
}

static int tells(const discmc_application_record* record) {
  discmc_status status = discmc_slice_encoder_tell(&encoder, record);
  while (waits(status)) status = discmc_slice_encoder_tell(&encoder, record);
  return status == DISCMC_OK;
}

static int tells_time(int32_t z) {
  const unsigned milliseconds = 50U * (unsigned)z;
  const uint8_t bytes[] = {(uint8_t)(milliseconds & 0xFF), (uint8_t)(milliseconds >> 8)};
  const discmc_application_record record = {TIME_STAMP, 0, 0, bytes, sizeof bytes};
  return tells(&record);
}

static int tells_place(void) {
  const int32_t millimetre = 1000 * 1000;
  discmc_placement placement = {{{0}}, {0}, DISCMC_FRAME_NONE};
  uint8_t bytes[DISCMC_PLACEMENT_BYTES];
  discmc_application_record record;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    placement.axes_nm[axis][axis] = millimetre;
    placement.origin_nm[axis] = (1 - SIZE) * (millimetre / 2);
  }
  record = discmc_placement_record(&placement, bytes);
  return tells(&record);
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 2 * z - SIZE + 1;
  return (uint8_t)(255 - (a * a + b * b + c * c) / 26);
}

static int scans(uint16_t number) {
  const discmc_stream_header header = {.width = SIZE,
                                       .height = SIZE,
                                       .depth = SIZE,
                                       .threshold = 192,
                                       .scan = number,
                                       .further_surfaces = SURFACES - 1,
                                       .further_thresholds = {224}};
  const discmc_memory arena = {memory, sizeof memory};
  int good = succeeds(discmc_slice_encoder_start(&encoder, &header, KEY_SLICES, arena, radio)) &&
             tells_place();
  int32_t x, y, z;
  for (z = 0; good && z < SIZE; ++z) {
    radio_works = number != 1 || z < 16 || z >= 28;
    if (is_dropping && radio_works) take_up_again();
    if (z % 8 == 0) good = tells_time(z); /* rarely: each takes a packet */
    for (y = 0; good && y < SIZE; ++y) {
      uint8_t row[SIZE];
      for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, y, z);
      good = succeeds(discmc_slice_encoder_push_u8(&encoder, row, SIZE, 1).status);
    }
  }
  return good && succeeds(discmc_slice_encoder_finish(&encoder));
}

int main(void) {
  int good = receiver_start(&receivers[0], 0) && receiver_start(&receivers[1], 1);
  uint16_t scan;
  int i;
  for (scan = 1; good && scan <= 2; ++scan) good = scans(scan);
  for (i = 0; i < SURFACES; ++i) good = good && receivers[i].complete_scans == 1;
  return good ? 0 : 1;
}

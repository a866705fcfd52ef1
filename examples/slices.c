/* A scanner that sends thresholded slices, in C: two surfaces in one stream, with time stamps. It
 * needs less RAM and flash than firmware.c, and a tenth of the bytes; receive.c extracts the
 * surfaces. The radio fails for a while: the stream is dropped, and the scan continues. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, SURFACES = 2 }; /* voxels per row, rows per slice, slices */
enum { KEY_SLICES = 8 };          /* a packet holds about eight slices of this ball */
enum { TIME_STAMP = 1 };          /* a kind of record: the application's own */

static uint8_t memory[DISCMC_SLICE_ENCODER_BYTES(SIZE, SIZE, SURFACES)];
static discmc_slice_encoder* encoder;

static int radio_works = 1;

/* The radio accepts 16 bytes at a time, and nothing while there is no link. */
static size_t radio_write(void* context, const uint8_t* bytes, size_t count) {
  (void)context;
  return radio_works ? fwrite(bytes, 1, count < 16 ? count : 16, stdout) : 0;
}
static const discmc_byte_output radio = {.write = radio_write};
static const discmc_byte_output nowhere = {0};

static discmc_status start(void) {
  const discmc_slice_encoder_config config = {
      .kind = &discmc_slices_u8,
      .limits = {SIZE, SIZE, DISCMC_CLOSED},
      .surface_count = SURFACES,
      .thresholds = {192, 224},
      .key_slice_interval = KEY_SLICES,
      .label = {.depth = SIZE, .scan = 1},
      .memory = {memory, sizeof memory},
      .output = radio,
  };
  return discmc_slice_encoder_start(&encoder, &config);
}

/* Whether a call has to be made again. If the radio stays busy for long, the link is dead. */
static int waits(discmc_status status) {
  static unsigned refusals = 0;
  refusals = status == DISCMC_SUSPENDED ? refusals + 1 : 0;
  if (refusals == 100) discmc_slice_encoder_set_output(encoder, nowhere);
  return refusals > 0; /* sleep here */
}

static int succeeds(discmc_status status) {
  while (waits(status)) status = discmc_slice_encoder_resume(encoder);
  return status == DISCMC_OK;
}

static int writes_time(int32_t z) {
  const unsigned milliseconds = 50U * (unsigned)z;
  const uint8_t bytes[] = {(uint8_t)(milliseconds & 0xFF), (uint8_t)(milliseconds >> 8)};
  const discmc_application_record record = {TIME_STAMP, 0, 0, bytes, sizeof bytes};
  discmc_status status = discmc_slice_encoder_write_record(encoder, &record);
  while (waits(status)) status = discmc_slice_encoder_write_record(encoder, &record);
  return status == DISCMC_OK;
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 2 * z - SIZE + 1;
  return (uint8_t)(255 - (a * a + b * b + c * c) / 26);
}

int main(void) {
  int good = start() == DISCMC_OK;
  int32_t x, y, z;
  for (z = 0; good && z < SIZE; ++z) {
    radio_works = z < 16 || z >= 28;
    if (z == 28) discmc_slice_encoder_set_output(encoder, radio);
    if (z % 8 == 0) good = writes_time(z); /* rarely: each needs a packet */
    for (y = 0; good && y < SIZE; ++y) {
      uint8_t row[SIZE];
      for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, y, z);
      good = succeeds(discmc_slice_encoder_push(encoder, DISCMC_U8, row, SIZE, 1).status);
    }
  }
  return good && succeeds(discmc_slice_encoder_finish(encoder)) ? 0 : 1;
}

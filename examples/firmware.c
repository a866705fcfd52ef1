/* A scanner's firmware in C: firmware.cpp once more, byte for byte the same stream. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, THRESHOLD = 192 }; /* voxels per row, rows per slice, slices */

/* RAM without the stack: 7.8 KiB. Fewer slots, from 4 on, make the stream longer. */
static uint8_t encoder_memory[DISCMC_ENCODER_BYTES];
static uint8_t extractor_memory[DISCMC_EXTRACTOR_BYTES(SIZE, SIZE, 640)];
static discmc_encoder* encoder;
static discmc_extractor* extractor;

/* Replace by your driver: this one accepts up to 16 bytes, and is busy at every other call. */
static size_t uart_write(void* context, const uint8_t* bytes, size_t count) {
  static unsigned calls = 0;
  (void)context;
  return ++calls % 2 == 0 ? fwrite(bytes, 1, count < 16 ? count : 16, stdout) : 0;
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 2 * z - SIZE + 1;
  return (uint8_t)(255 - 85 * (a * a + b * b + c * c) / ((SIZE - 1) * (SIZE - 1)));
}

static discmc_status start(void) {
  const discmc_encoder_config stream = {
      .kind = &discmc_regions,
      .label = {.depth = SIZE},
      .memory = {encoder_memory, sizeof encoder_memory},
      .output = {NULL, uart_write},
  };
  const discmc_status status = discmc_encoder_start(&encoder, &stream);
  const discmc_extractor_config scan = {
      .kind = &discmc_plain_u8,
      .limits = {SIZE, SIZE, DISCMC_CLOSED},
      .threshold = THRESHOLD,
      .memory = {extractor_memory, sizeof extractor_memory},
      .sink = {encoder, discmc_encoder_accept},
  };
  return status == DISCMC_OK ? discmc_extractor_start(&extractor, &scan) : status;
}

static int succeeds(discmc_status status) {
  while (status == DISCMC_SUSPENDED) /* the UART is busy: sleep here */
    status = discmc_extractor_resume(extractor);
  if (status != DISCMC_OK) fputs(discmc_status_string(status), stderr);
  return status == DISCMC_OK;
}

int main(void) {
  int good = succeeds(start());
  int32_t i, x;
  for (i = 0; good && i < SIZE * SIZE; ++i) {
    uint8_t row[SIZE];
    for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, i % SIZE, i / SIZE);
    good = succeeds(discmc_extractor_push(extractor, DISCMC_U8, row, SIZE, 1).status);
  }
  return good && succeeds(discmc_extractor_finish(extractor)) ? 0 : 1;
}

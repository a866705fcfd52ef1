/* A scanner's firmware in C: firmware.cpp once more, byte for byte the same stream. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, THRESHOLD = 192 }; /* voxels a row, rows a slice, slices */

static const discmc_limits limits = {.width = SIZE, .height = SIZE, .border = DISCMC_CLOSED};
static uint8_t memory[DISCMC_MINIMUM_BYTES(SIZE, SIZE) + 5 * 1024];
static discmc_extractor extractor;
static discmc_encoder encoder;
static const discmc_sink sink = {&encoder, discmc_encoder_take};

/* The UART takes what its FIFO has room for. Every other time it is busy and takes nothing. */
static size_t uart_write(void* context, const uint8_t* bytes, size_t count) {
  static unsigned calls = 0;
  (void)context;
  return ++calls % 2 == 0 ? fwrite(bytes, 1, count < 16 ? count : 16, stdout) : 0;
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 2 * z - SIZE + 1;
  return (uint8_t)(255 - (a * a + b * b + c * c) / 26);
}

static int succeeds(discmc_status status) {
  while (status == DISCMC_MORE) /* the UART is busy: sleep here */
    status = discmc_extractor_resume(&extractor);
  return status == DISCMC_OK;
}

int main(void) {
  const discmc_stream_label label = {SIZE, {0, 0, 0}, 0, 0};
  const discmc_byte_output uart = {NULL, uart_write};
  const discmc_memory arena = {memory, sizeof memory};
  int good = succeeds(discmc_encoder_start(&encoder, &label, uart)) &&
             succeeds(discmc_extractor_start(&extractor, &limits, NULL, THRESHOLD, arena, &sink));
  int32_t i, x;
  for (i = 0; good && i < SIZE * SIZE; ++i) {
    uint8_t row[SIZE];
    for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, i % SIZE, i / SIZE);
    good = succeeds(discmc_extractor_push_u8(&extractor, row, SIZE, 1).status);
  }
  return good && succeeds(discmc_extractor_finish(&extractor)) ? 0 : 1;
}

/* A scanner that makes normals, in C: normals.cpp once more, byte for byte the same stream. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, THRESHOLD = 192 }; /* voxels a row, rows a slice, slices */

static const discmc_limits limits = {.width = SIZE, .height = SIZE, .border = DISCMC_CLOSED};
static const discmc_stream_label label = {.depth = SIZE};
static const int32_t spacing_nm[3] = {500000, 500000, 1000000};

#define LEAST DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(SIZE, SIZE, sizeof(uint8_t))
static uint8_t memory[LEAST + 8 * 1024];
static const discmc_memory arena = {memory, sizeof memory};
static discmc_normal_extractor extractor;
static discmc_normal_encoder encoder;
static const discmc_sink sink = {&encoder, discmc_normal_encoder_take};

static discmc_status begin(discmc_byte_output output) {
  const discmc_normal_kind* const kind = &discmc_normals_u8; /* of the samples' type */
  const discmc_status status = discmc_normal_encoder_start(&encoder, &label, output);
  if (status != DISCMC_OK) return status;
  discmc_normal_extractor_set_spacing(&extractor, kind, spacing_nm);
  return discmc_normal_extractor_start(&extractor, kind, &limits, NULL, THRESHOLD, arena, &sink);
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 4 * z - 2 * SIZE + 2;
  const int32_t fall = (a * a + b * b + c * c) / 26;
  return (uint8_t)(fall < 255 ? 255 - fall : 0);
}

/* The output takes all: no call is suspended. */
static size_t write_all(void* context, const uint8_t* bytes, size_t count) {
  (void)context;
  return fwrite(bytes, 1, count, stdout);
}

int main(void) {
  const discmc_byte_output output = {NULL, write_all};
  int good = begin(output) == DISCMC_OK;
  int32_t i, x;
  for (i = 0; good && i < SIZE * SIZE; ++i) {
    uint8_t row[SIZE];
    for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, i % SIZE, i / SIZE);
    good = discmc_normal_extractor_push_u8(&extractor, row, SIZE, 1).status == DISCMC_OK;
  }
  return good && discmc_normal_extractor_finish(&extractor) == DISCMC_OK ? 0 : 1;
}

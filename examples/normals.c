/* A scanner that makes normals, in C: normals.cpp once more, byte for byte the same stream. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, THRESHOLD = 192 }; /* voxels per row, rows per slice, slices */

static uint8_t encoder_memory[DISCMC_ENCODER_BYTES];
static uint8_t extractor_memory[DISCMC_NORMAL_EXTRACTOR_BYTES(SIZE, SIZE, sizeof(uint8_t), 590)];
static discmc_encoder* encoder;
static discmc_extractor* extractor;

static discmc_status start(discmc_byte_output output) {
  const discmc_encoder_config stream = {
      .kind = &discmc_regions_with_normals,
      .label = {.depth = SIZE},
      .memory = {encoder_memory, sizeof encoder_memory},
      .output = output,
  };
  const discmc_status status = discmc_encoder_start(&encoder, &stream);
  const discmc_extractor_config scan = {
      .kind = &discmc_normals_u8, /* by the type of samples */
      .limits = {SIZE, SIZE, DISCMC_CLOSED},
      .threshold = THRESHOLD,
      .spacing_nm = {500000, 500000, 1000000},
      .memory = {extractor_memory, sizeof extractor_memory},
      .sink = {encoder, discmc_encoder_accept},
  };
  return status == DISCMC_OK ? discmc_extractor_start(&extractor, &scan) : status;
}

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 4 * z - 2 * SIZE + 2;
  const int32_t fall = (a * a + b * b + c * c) / 26;
  return (uint8_t)(fall < 255 ? 255 - fall : 0);
}

/* The output accepts all: no call is suspended. */
static size_t write_all(void* context, const uint8_t* bytes, size_t count) {
  (void)context;
  return fwrite(bytes, 1, count, stdout);
}

int main(void) {
  const discmc_byte_output output = {.write = write_all};
  int good = start(output) == DISCMC_OK;
  int32_t i, x;
  for (i = 0; good && i < SIZE * SIZE; ++i) {
    uint8_t row[SIZE];
    for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, i % SIZE, i / SIZE);
    good = discmc_extractor_push(extractor, DISCMC_U8, row, SIZE, 1).status == DISCMC_OK;
  }
  return good && discmc_extractor_finish(extractor) == DISCMC_OK ? 0 : 1;
}

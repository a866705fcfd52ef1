/* A scanner that survives a power failure, in C. It stores a checkpoint in flash every eight
 * slices. The power fails in slice 20; the scan continues from slice 16, and the stream is that
 * of firmware.c, byte for byte. */
#include <discmc/discmc.h>
#include <stdio.h>

enum { SIZE = 48, THRESHOLD = 192 }; /* voxels per row, rows per slice, slices */

static uint8_t encoder_memory[DISCMC_ENCODER_BYTES];
static uint8_t extractor_memory[DISCMC_EXTRACTOR_BYTES(SIZE, SIZE, 640)];
static discmc_encoder* encoder;
static discmc_extractor* extractor;

static void copy(void* to, const void* from, size_t bytes) {
  size_t i;
  for (i = 0; i < bytes; ++i) ((uint8_t*)to)[i] = ((const uint8_t*)from)[i];
}

/* ---- the flash: eight blocks of 4 KiB, programmed 256 bytes at a time ---- */

enum { PROGRAM_BYTES = 256, BLOCK_BYTES = 4096, BLOCKS = 8 };
static uint8_t flash[BLOCKS][BLOCK_BYTES];
static uint8_t store_memory[DISCMC_STORE_BYTES(PROGRAM_BYTES)];
static discmc_store* store;

static int flash_read(void* context, uint32_t block, uint32_t offset, void* buffer,
                      uint32_t bytes) {
  (void)context;
  copy(buffer, &flash[block][offset], bytes);
  return 0;
}
static int flash_program(void* context, uint32_t block, uint32_t offset, const void* buffer,
                         uint32_t bytes) {
  (void)context;
  copy(&flash[block][offset], buffer, bytes);
  return 0;
}
static int flash_erase(void* context, uint32_t block) {
  uint32_t i;
  (void)context;
  for (i = 0; i < BLOCK_BYTES; ++i) flash[block][i] = 0xFF;
  return 0;
}

/* ---- the stream: a file ---- */

static uint8_t stream[32 * 1024];
static size_t stream_bytes = 0;

static size_t stream_unsent(void* context) { /* written at once, nothing is queued */
  (void)context;
  return 0;
}
static size_t stream_write(void* context, const uint8_t* bytes, size_t count) {
  (void)context;
  if (stream_bytes + count > sizeof stream) return 0;
  copy(stream + stream_bytes, bytes, count);
  stream_bytes += count;
  return count;
}

/* ---- the device ---- */

static const discmc_store_config device = {
    .read = flash_read,
    .program = flash_program,
    .erase = flash_erase,
    .program_bytes = PROGRAM_BYTES,
    .block_bytes = BLOCK_BYTES,
    .blocks = BLOCKS,
    .max_bytes = sizeof encoder_memory + sizeof extractor_memory,
    .memory = {store_memory, sizeof store_memory},
};
static const discmc_encoder_config stream_config = {
    .kind = &discmc_regions,
    .label = {.depth = SIZE},
    .memory = {encoder_memory, sizeof encoder_memory},
    .output = {NULL, stream_write, stream_unsent},
};
static discmc_extractor_config scan = {
    .kind = &discmc_plain_u8,
    .limits = {SIZE, SIZE, DISCMC_CLOSED},
    .threshold = THRESHOLD,
    .memory = {extractor_memory, sizeof extractor_memory},
    .sink = {NULL, discmc_encoder_accept},
};

/* Waits until a call of the store is over; only the scan pauses. */
static discmc_status complete(discmc_status status) {
  while (status == DISCMC_SUSPENDED) status = discmc_store_resume(store);
  return status;
}

/* Waits until the output has accepted what a call of the extractor sends. */
static discmc_status resumed(discmc_status status) {
  while (status == DISCMC_SUSPENDED) status = discmc_extractor_resume(extractor);
  return status;
}

/* Before the first row of a scan: no older checkpoint may be continued from now on. */
static discmc_status begin_scan(void) {
  discmc_status status = complete(discmc_store_discard(store));
  if (status == DISCMC_OK) status = discmc_encoder_start(&encoder, &stream_config);
  scan.sink.context = encoder;
  return status == DISCMC_OK ? resumed(discmc_extractor_start(&extractor, &scan)) : status;
}

/* Continues from the newest checkpoint, unless another build has saved it. */
static discmc_status restore(void) {
  const discmc_memory parts[] = {stream_config.memory, scan.memory};
  discmc_status status = discmc_store_restore(store, parts, 2);
  if (status == DISCMC_OK) status = discmc_encoder_restore(&encoder, &stream_config);
  scan.sink.context = encoder;
  if (status == DISCMC_OK) status = discmc_extractor_restore(&extractor, &scan);
  if (status == DISCMC_OK) stream_bytes = (size_t)discmc_encoder_stream_bytes(encoder);
  return status;
}

static discmc_status power_on(void) {
  const discmc_status status = discmc_store_start(&store, &device);
  if (status != DISCMC_OK) return status;
  if (discmc_store_get_info(store).has_checkpoint && restore() == DISCMC_OK) return DISCMC_OK;
  return begin_scan();
}

/* Suspended: bytes are unsent; call it again, before the next row. */
static discmc_status save(void) {
  discmc_memory parts[2];
  discmc_status status = discmc_encoder_save(encoder, &parts[0]);
  if (status == DISCMC_OK) status = discmc_extractor_save(extractor, &parts[1]);
  return status == DISCMC_OK ? complete(discmc_store_save(store, parts, 2)) : status;
}

/* After the last slice. */
static discmc_status end_scan(void) {
  const discmc_status status = resumed(discmc_extractor_finish(extractor));
  while (stream_unsent(NULL) > 0) continue; /* or sleep */
  return status == DISCMC_OK ? complete(discmc_store_discard(store)) : status;
}

/* ---- the scanner ---- */

static uint8_t sample_at(int32_t x, int32_t y, int32_t z) { /* of a ball, densest in its middle */
  const int32_t a = 2 * x - SIZE + 1, b = 2 * y - SIZE + 1, c = 2 * z - SIZE + 1;
  return (uint8_t)(255 - (a * a + b * b + c * c) / 26);
}

/* Scans up to a slice. */
static discmc_status scan_to(uint32_t last) {
  discmc_status status = DISCMC_OK;
  uint32_t z = discmc_extractor_get_info(extractor).slices;
  int32_t x, y;
  for (; status == DISCMC_OK && z < last; ++z) {
    for (y = 0; status == DISCMC_OK && y < SIZE; ++y) {
      uint8_t row[SIZE];
      for (x = 0; x < SIZE; ++x) row[x] = sample_at(x, y, (int32_t)z);
      status = resumed(discmc_extractor_push(extractor, DISCMC_U8, row, SIZE, 1).status);
    }
    if (status == DISCMC_OK && z % 8 == 7) {
      do status = save();
      while (status == DISCMC_SUSPENDED);
    }
  }
  return status;
}

static void lose(void* memory, size_t bytes) {
  while (bytes > 0) ((uint8_t*)memory)[--bytes] = 0;
}

int main(void) {
  size_t written = 0;
  discmc_status status = power_on();
  if (status == DISCMC_OK) status = scan_to(20);

  lose(encoder_memory, sizeof encoder_memory); /* the power fails */
  lose(extractor_memory, sizeof extractor_memory);
  lose(store_memory, sizeof store_memory);

  if (status == DISCMC_OK) status = power_on();
  if (status == DISCMC_OK) status = scan_to(SIZE);
  if (status == DISCMC_OK) status = end_scan();
  while (written < stream_bytes)
    written += fwrite(stream + written, 1, stream_bytes - written, stdout);
  return status == DISCMC_OK ? 0 : 1;
}

/* One voxel in the middle of a volume: its surface is an octahedron, eight regions. */
#include <discmc/discmc.h>

static uint8_t memory[4096];
static discmc_extractor extractor;

static discmc_answer count_regions(void *context, const discmc_event *event) {
  if (event->kind == DISCMC_REGION) ++*(unsigned *)context;
  return DISCMC_TAKEN;
}

int main(void) {
  static const uint8_t volume[27] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  const discmc_limits limits = {.width = 3, .height = 3, .border = DISCMC_CLOSED};
  const discmc_memory arena = {memory, sizeof memory};
  unsigned regions = 0;
  discmc_sink sink = {0};
  sink.context = &regions;
  sink.take = count_regions;
  if (discmc_extractor_start(&extractor, &limits, 0, 1, arena, &sink) != DISCMC_OK) return 1;
  if (discmc_extractor_push_u8(&extractor, volume, 27, 1).status != DISCMC_OK) return 2;
  if (discmc_extractor_finish(&extractor) != DISCMC_OK) return 3;
  return regions == 8 ? 0 : 4;
}

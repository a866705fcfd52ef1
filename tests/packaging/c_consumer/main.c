/* One voxel in the middle of a volume: its surface is an octahedron, eight regions. */
#include <discmc/discmc.h>

static uint8_t memory[4096];

static discmc_sink_result count_regions(void *context, const discmc_event *event) {
  if (event->kind == DISCMC_REGION) ++*(unsigned *)context;
  return DISCMC_SINK_ACCEPTED;
}

int main(void) {
  static const uint8_t volume[27] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  unsigned regions = 0;
  discmc_extractor *extractor;
  discmc_extractor_config config = {.kind = &discmc_plain_u8, .threshold = 1};
  config.limits.width = config.limits.height = 3;
  config.memory.data = memory;
  config.memory.bytes = sizeof memory;
  config.sink.context = &regions;
  config.sink.accept = count_regions;
  if (discmc_extractor_start(&extractor, &config) != DISCMC_OK) return 1;
  if (discmc_extractor_push(extractor, DISCMC_U8, volume, 27, 1).status != DISCMC_OK) return 2;
  if (discmc_extractor_finish(extractor) != DISCMC_OK) return 3;
  return regions == 8 ? 0 : 4;
}

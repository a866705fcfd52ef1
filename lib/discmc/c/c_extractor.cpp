#include <discmc/c/extractor_kind.hpp>

namespace discmc {

static const discmc_extractor_kind& kind_of(const discmc_extractor& extractor) {
  return static_cast<const discmc_extractor_kind&>(*extractor.kind);
}
static ExtractorView look(const discmc_extractor& extractor) {
  ExtractorView view;
  kind_of(extractor).look(extractor, view);
  return view;
}

extern "C" {

uint64_t discmc_extractor_bytes(const discmc_extractor_config* config) {
  const Limits limits = cpp(config->limits);
  if (!limits.is_valid()) return 0;
  if (config->kind == nullptr) return 0;
  const discmc_extractor_kind& kind = *config->kind;
  const uint32_t slots = config->slots == 0 ? minimum_capacities().slots : config->slots;
  return bytes_with_object(kind.object_bytes, bytes_of_scan(kind.sizes, limits, slots));
}

discmc_status discmc_extractor_start(discmc_extractor** extractor,
                                     const discmc_extractor_config* config) {
  return start<discmc_extractor>(extractor, *config, [&](discmc_extractor& object, Memory rest) {
    return config->kind->start(object, *config, rest, false);
  });
}
discmc_status discmc_extractor_restore(discmc_extractor** extractor,
                                       const discmc_extractor_config* config) {
  return restore<discmc_extractor>(extractor, *config, [&](discmc_extractor& object, Memory rest) {
    return config->kind->start(object, *config, rest, true);
  });
}

discmc_status discmc_extractor_save(discmc_extractor* extractor, discmc_memory* part) {
  Memory parts[2];
  const Status status = kind_of(*extractor).save(*extractor, parts);
  if (status == Status::ok) *part = extractor->part_with(parts[1].bytes);
  return c(status);
}

discmc_push_result discmc_extractor_push(discmc_extractor* extractor, discmc_sample_type type,
                                         const void* samples, uint32_t count, uint32_t stride) {
  return kind_of(*extractor).push(*extractor, type, samples, count, stride);
}
discmc_push_result discmc_extractor_skip_row(discmc_extractor* extractor, uint8_t substitute) {
  return c(kind_of(*extractor).skip_row(*extractor, static_cast<Substitute>(substitute)));
}
discmc_status discmc_extractor_resume(discmc_extractor* extractor) {
  return c(kind_of(*extractor).resume(*extractor));
}
discmc_status discmc_extractor_finish(discmc_extractor* extractor) {
  return c(kind_of(*extractor).finish(*extractor));
}
discmc_status discmc_extractor_abandon(discmc_extractor* extractor) {
  return c(kind_of(*extractor).abandon(*extractor));
}
discmc_extractor_info discmc_extractor_get_info(const discmc_extractor* extractor) {
  const ExtractorView view = look(*extractor);
  return {c(*view.statistics),
          view.slices,
          view.rows,
          view.capacities->slots,
          view.capacities->holes,
          view.peaks.slots,
          view.peaks.holes,
          extractor->part_with(view.bytes_used).bytes};
}

}  // extern "C"

}  // namespace discmc

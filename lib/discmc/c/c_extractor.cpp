#include <discmc/c/extractor_kind.hpp>

namespace discmc {

// What a scan with so many records takes of the memory behind the object.
static uint64_t bytes_of_scan(const discmc_extractor_kind& kind, const Limits& limits,
                              uint32_t records) {
  const Capacities capacities{records, 0};
  if (kind.index_bytes == 4) return bytes_for<uint32_t>(limits, capacities);
  if (kind.sample_bytes == 0) return bytes_for<uint16_t>(limits, capacities);
  if (kind.sample_bytes == 1)
    return bytes_for<uint16_t, GradientNormals<uint8_t>>(limits, capacities);
  return bytes_for<uint16_t, GradientNormals<uint16_t>>(limits, capacities);
}

// The bytes that are in use, from the object on.
static size_t used_bytes(const discmc_extractor_kind& kind, const ExtractorView& view) {
  const uint64_t bytes = bytes_of_scan(kind, view.limits, view.high_water.records);
  return kind.object_bytes + static_cast<size_t>(bytes);
}

extern "C" {

uint64_t discmc_extractor_bytes(const discmc_extractor_config* config) {
  const Limits limits = cpp(config->limits);
  if (!limits.is_valid()) return 0;
  const discmc_extractor_kind& kind = *config->kind;
  const uint32_t records = config->records == 0 ? minimum_capacities().records : config->records;
  const uint64_t arena = bytes_of_scan(kind, limits, records);
  const bool has_learnt = kind.index_bytes == 4 && arena + learnt_bytes >= enough_to_learn;
  return bytes_with_object(kind.object_bytes, arena + (has_learnt ? learnt_bytes : 0));
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
  ExtractorView view;
  extractor->kind->look(*extractor, view);
  if (view.is_suspended) return DISCMC_SUSPENDED;
  *part = extractor->seal.close(used_bytes(*extractor->kind, view));
  return DISCMC_OK;
}

discmc_push_result discmc_extractor_push(discmc_extractor* extractor, discmc_sample_type type,
                                         const void* samples, uint32_t count, uint32_t stride) {
  return extractor->kind->push(*extractor, type, samples, count, stride);
}
discmc_push_result discmc_extractor_skip_row(discmc_extractor* extractor, uint8_t substitute) {
  return c(extractor->kind->skip_row(*extractor, static_cast<Substitute>(substitute)));
}
discmc_status discmc_extractor_resume(discmc_extractor* extractor) {
  return c(extractor->kind->resume(*extractor));
}
discmc_status discmc_extractor_finish(discmc_extractor* extractor) {
  return c(extractor->kind->finish(*extractor));
}
discmc_status discmc_extractor_abandon(discmc_extractor* extractor) {
  return c(extractor->kind->abandon(*extractor));
}
discmc_extractor_info discmc_extractor_get_info(const discmc_extractor* extractor) {
  ExtractorView view;
  extractor->kind->look(*extractor, view);
  return {c(view.statistics),
          view.slices,
          view.rows,
          view.capacities.records,
          view.capacities.holes,
          view.high_water.records,
          view.high_water.holes,
          extractor->seal.part(used_bytes(*extractor->kind, view)).bytes};
}

}  // extern "C"

}  // namespace discmc

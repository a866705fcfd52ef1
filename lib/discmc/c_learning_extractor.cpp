// discmc.h in terms of the C++ library: the extractor for hosts. A file of its own, so that
// firmware does not link it.
#include <discmc/discmc.h>

#include <discmc/c_extractors.hpp>
#include <discmc/learning_extractor.hpp>

namespace discmc {

namespace {

using LearningAdapter = SinkAdapter<LearningExtractor>;
static_assert(fits<LearningAdapter, discmc_learning_extractor> &&
                  fits<Checkpoint<LearningExtractor>, discmc_learning_extractor_checkpoint>,
              "the sizes in discmc.h are enough and not much more");

static_assert(DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(31, 7) == minimum_bytes<uint32_t>({31, 7}) &&
                  DISCMC_LEARNING_DEFAULT_RECORDS_(31, 7, 5000) ==
                      default_capacities<uint32_t>({31, 7}, 5000).records,
              "the constants of sizes.h are what the functions give; the tests have many more");

LearningAdapter& adapter(discmc_learning_extractor* extractor) {
  return *reinterpret_cast<LearningAdapter*>(extractor);
}
LearningExtractor& cpp(discmc_learning_extractor* extractor) {
  return adapter(extractor).object;
}
const LearningExtractor& cpp(const discmc_learning_extractor* extractor) {
  return reinterpret_cast<const LearningAdapter*>(extractor)->object;
}

}  // namespace

extern "C" {

uint64_t discmc_learning_extractor_minimum_bytes(const discmc_limits* limits) {
  return minimum_bytes<uint32_t>(cpp(*limits));
}
uint64_t discmc_learning_extractor_bytes_for(const discmc_limits* limits,
                                             const discmc_capacities* capacities) {
  return bytes_for<uint32_t>(cpp(*limits), cpp(*capacities));
}
discmc_capacities discmc_learning_extractor_default_capacities(const discmc_limits* limits,
                                                               uint64_t bytes) {
  return c(default_capacities<uint32_t>(cpp(*limits), bytes));
}

void discmc_learning_extractor_learn_in(discmc_learning_extractor* extractor,
                                        discmc_memory memory) {
  cpp(extractor).learn_in(cpp(memory));
}
discmc_status discmc_learning_extractor_start(discmc_learning_extractor* extractor,
                                              const discmc_limits* limits,
                                              const discmc_capacities* capacities,
                                              int32_t threshold, discmc_memory memory,
                                              const discmc_sink* sink) {
  return start(adapter(extractor), limits, capacities, threshold, memory, sink);
}
discmc_status discmc_learning_extractor_reset(discmc_learning_extractor* extractor) {
  return c(cpp(extractor).reset());
}
discmc_push_result discmc_learning_extractor_push_u8(discmc_learning_extractor* extractor,
                                                     const uint8_t* samples, uint32_t count,
                                                     uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_learning_extractor_push_u16(discmc_learning_extractor* extractor,
                                                      const uint16_t* samples, uint32_t count,
                                                      uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_learning_extractor_push_i16(discmc_learning_extractor* extractor,
                                                      const int16_t* samples, uint32_t count,
                                                      uint32_t stride) {
  return c(cpp(extractor).push(samples, count, stride));
}
discmc_push_result discmc_learning_extractor_push_bits(discmc_learning_extractor* extractor,
                                                       const uint8_t* bits) {
  return c(cpp(extractor).push_bits(bits));
}
discmc_push_result discmc_learning_extractor_skip_row(discmc_learning_extractor* extractor,
                                                      uint8_t substitute) {
  return c(cpp(extractor).skip_row(static_cast<Substitute>(substitute)));
}
discmc_status discmc_learning_extractor_resume(discmc_learning_extractor* extractor) {
  return c(cpp(extractor).resume());
}
discmc_status discmc_learning_extractor_finish(discmc_learning_extractor* extractor) {
  return c(cpp(extractor).finish());
}
discmc_status discmc_learning_extractor_abandon(discmc_learning_extractor* extractor) {
  return c(cpp(extractor).abandon());
}
discmc_status discmc_learning_extractor_save(const discmc_learning_extractor* extractor,
                                             discmc_learning_extractor_checkpoint* checkpoint) {
  return save(cpp(extractor), checkpoint);
}
discmc_status discmc_learning_extractor_restore(
    discmc_learning_extractor* extractor, const discmc_learning_extractor_checkpoint* checkpoint,
    discmc_memory memory, const discmc_sink* sink) {
  return restore(adapter(extractor), checkpoint, memory, sink);
}
discmc_statistics discmc_learning_extractor_statistics(const discmc_learning_extractor* extractor) {
  return c(cpp(extractor).statistics());
}
discmc_limits discmc_learning_extractor_limits(const discmc_learning_extractor* extractor) {
  return c(cpp(extractor).limits());
}
discmc_capacities discmc_learning_extractor_capacities(const discmc_learning_extractor* extractor) {
  return c(cpp(extractor).capacities());
}
discmc_high_water discmc_learning_extractor_high_water(const discmc_learning_extractor* extractor) {
  return c(cpp(extractor).high_water());
}
size_t discmc_learning_extractor_bytes_used(const discmc_learning_extractor* extractor) {
  return cpp(extractor).bytes_used();
}
uint32_t discmc_learning_extractor_slices(const discmc_learning_extractor* extractor) {
  return cpp(extractor).slices();
}
uint32_t discmc_learning_extractor_rows(const discmc_learning_extractor* extractor) {
  return cpp(extractor).rows();
}

}  // extern "C"

}  // namespace discmc

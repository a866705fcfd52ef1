// discmc.h in terms of the C++ library: checkpoints in flash. A file of its own, so that firmware
// which keeps none does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/checkpoint_store.hpp>

namespace discmc {

namespace {

static_assert(fits<CheckpointStore, discmc_checkpoint_store>,
              "the size in discmc.h is enough and not much more");
static_assert(DISCMC_MAX_PARTS == CheckpointStore::max_parts, "constants are the same");

CheckpointStore& cpp(discmc_checkpoint_store* store) {
  return *reinterpret_cast<CheckpointStore*>(store);
}
const CheckpointStore& cpp(const discmc_checkpoint_store* store) {
  return *reinterpret_cast<const CheckpointStore*>(store);
}

FlashGeometry cpp(const discmc_flash_geometry& from) {
  return {from.program_bytes, from.block_bytes, from.blocks};
}
FlashDevice cpp(const discmc_flash_device& from) {
  return {from.context, from.read, from.program, from.erase, from.sync, cpp(from.geometry)};
}

// The parts as C++ has them. False when they are too many.
bool copy(const discmc_memory* from, uint32_t count, Memory* to) {
  if (count > CheckpointStore::max_parts) return false;
  for (uint32_t i = 0; i < count; ++i) to[i] = discmc::cpp(from[i]);
  return true;
}

}  // namespace

extern "C" {

discmc_store_plan discmc_store_plan_for(const discmc_flash_geometry* geometry,
                                        uint32_t most_bytes) {
  const StorePlan plan = store_plan(cpp(*geometry), most_bytes);
  if (!plan.is_valid()) return {};
  return {plan.slots, plan.slots_per_block, plan.blocks(most_bytes), plan.units(most_bytes)};
}
discmc_status discmc_checkpoint_store_start(discmc_checkpoint_store* store,
                                            const discmc_flash_device* device, uint32_t most_bytes,
                                            discmc_memory buffer) {
  return c(cpp(store).start(cpp(*device), most_bytes, cpp(buffer)));
}
uint8_t discmc_checkpoint_store_has_checkpoint(const discmc_checkpoint_store* store) {
  return cpp(store).has_checkpoint() ? 1 : 0;
}
uint32_t discmc_checkpoint_store_bytes(const discmc_checkpoint_store* store) {
  return cpp(store).bytes();
}
uint32_t discmc_checkpoint_store_sequence(const discmc_checkpoint_store* store) {
  return cpp(store).sequence();
}
discmc_status discmc_checkpoint_store_restore(discmc_checkpoint_store* store,
                                              const discmc_memory* parts, uint32_t count) {
  Memory copies[CheckpointStore::max_parts];
  if (!copy(parts, count, copies)) return DISCMC_BAD_CHECKPOINT;
  return c(cpp(store).restore(copies, count));
}
discmc_status discmc_checkpoint_store_erase_ahead(discmc_checkpoint_store* store, uint32_t bytes) {
  return c(cpp(store).erase_ahead(bytes));
}
discmc_status discmc_checkpoint_store_save(discmc_checkpoint_store* store,
                                           const discmc_memory* parts, uint32_t count) {
  Memory copies[CheckpointStore::max_parts];
  if (!copy(parts, count, copies)) return DISCMC_TOO_LITTLE_MEMORY;
  return c(cpp(store).save(copies, count));
}
discmc_status discmc_checkpoint_store_resume(discmc_checkpoint_store* store) {
  return c(cpp(store).resume());
}

}  // extern "C"

}  // namespace discmc

#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/checkpoint_store.hpp>

struct discmc_store {
  discmc::CheckpointStore store;
};

namespace discmc {

namespace {

static_assert(DISCMC_STORE_BYTES(256) >= bytes_with_object(sizeof(discmc_store), 256),
              "the size in sizes.h suffices");

// Converts the parts to C++. False if there are too many.
bool copy(const discmc_memory* from, uint32_t count, Memory* to) {
  if (count > CheckpointStore::max_parts) return false;
  for (uint32_t i = 0; i < count; ++i) to[i] = cpp(from[i]);
  return true;
}

}  // namespace

extern "C" {

discmc_status discmc_store_start(discmc_store** store, const discmc_store_config* config) {
  Memory rest;
  auto* const object = begin<discmc_store>(config->memory, rest);
  if (object == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  const FlashDevice device{
      config->context, config->read, config->program,
      config->erase,   config->sync, {config->program_bytes, config->block_bytes, config->blocks}};
  const Status status = object->store.start(device, config->max_bytes, rest);
  if (status == Status::ok || status == Status::device_error) *store = object;
  return c(status);
}
discmc_store_info discmc_store_get_info(const discmc_store* store) {
  const CheckpointStore& object = store->store;
  const StorePlan& plan = object.plan();
  return {object.has_checkpoint(),   object.bytes(),
          object.sequence(),         plan.slots,
          plan.slots_per_block,      plan.blocks(plan.max_bytes),
          plan.units(plan.max_bytes)};
}
discmc_status discmc_store_restore(discmc_store* store, const discmc_memory* parts,
                                   uint32_t count) {
  Memory copies[CheckpointStore::max_parts];
  if (!copy(parts, count, copies)) return DISCMC_BAD_CHECKPOINT;
  return c(store->store.restore(copies, count));
}
discmc_status discmc_store_erase_ahead(discmc_store* store, uint32_t bytes) {
  return c(store->store.erase_ahead(bytes));
}
discmc_status discmc_store_save(discmc_store* store, const discmc_memory* parts, uint32_t count) {
  Memory copies[CheckpointStore::max_parts];
  if (!copy(parts, count, copies)) return DISCMC_TOO_LITTLE_MEMORY;
  return c(store->store.save(copies, count));
}
discmc_status discmc_store_discard(discmc_store* store) {
  return c(store->store.discard());
}
discmc_status discmc_store_resume(discmc_store* store) {
  return c(store->store.resume());
}

}  // extern "C"

}  // namespace discmc

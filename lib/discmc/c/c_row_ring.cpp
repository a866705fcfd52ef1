// The ring of rows, and the unpackers.
#include <discmc/front.h>
#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/front/packed_samples.hpp>
#include <discmc/front/row_ring.hpp>

struct discmc_row_ring {
  discmc::RowRing ring;
};

namespace discmc {

static_assert(red_zone_bytes > 0 ||
                  DISCMC_ROW_RING_BYTES(37, 5) >=
                      bytes_with_object(sizeof(discmc_row_ring), RowRing::bytes_for(37, 5)),
              "the size in sizes.h suffices");
static_assert(DISCMC_ROW_READY == static_cast<int>(RowRing::Next::ready) &&
                  DISCMC_ROW_LOST == static_cast<int>(RowRing::Next::lost) &&
                  DISCMC_ROW_END == static_cast<int>(RowRing::Next::end) &&
                  DISCMC_MONO10PMSB == static_cast<int>(Packing::mono10pmsb) &&
                  DISCMC_MONO12_PACKED == static_cast<int>(Packing::mono12_packed),
              "enumerations are in the same order");

extern "C" {

// Places the object after the rows, which have the alignment of the memory.
discmc_status discmc_row_ring_start(discmc_row_ring** ring, const discmc_row_ring_config* config) {
  const uint64_t bytes = RowRing::bytes_for(config->row_bytes, config->rows);
  const discmc_memory& memory = config->memory;
  if (memory.data == nullptr || memory.bytes < bytes) return DISCMC_TOO_LITTLE_MEMORY;
  const auto ring_bytes = static_cast<size_t>(bytes);
  Memory rest;
  auto* const object = begin<discmc_row_ring>(
      {static_cast<uint8_t*>(memory.data) + ring_bytes, memory.bytes - ring_bytes}, rest);
  if (object == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  const Status status =
      object->ring.start(config->row_bytes, config->rows, {memory.data, ring_bytes});
  if (status == Status::ok) *ring = object;
  return c(status);
}
void* discmc_row_ring_free_row(const discmc_row_ring* ring, uint32_t ahead) {
  return ring->ring.free_row(ahead);
}
void discmc_row_ring_commit(discmc_row_ring* ring) {
  ring->ring.commit();
}
uint32_t discmc_row_ring_drop(discmc_row_ring* ring, uint32_t rows) {
  ring->ring.drop(rows);
  return ring->ring.produced();
}
void discmc_row_ring_end(discmc_row_ring* ring) {
  ring->ring.end();
}
discmc_row discmc_row_ring_peek(const discmc_row_ring* ring) {
  return {static_cast<uint8_t>(ring->ring.peek()), ring->ring.row(), ring->ring.consumed()};
}
void discmc_row_ring_pop(discmc_row_ring* ring) {
  ring->ring.pop();
}

uint32_t discmc_packed_bytes(uint8_t packing, uint32_t count) {
  return packed_bytes(static_cast<Packing>(packing), count);
}
void discmc_unpack(uint8_t packing, const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack(static_cast<Packing>(packing), packed, count, samples);
}

}  // extern "C"

}  // namespace discmc

#include <discmc/c/object.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc {

static uint8_t* place_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  const size_t least = object_bytes + object_alignment - 1;
  if (memory.data == nullptr || memory.bytes < least) return nullptr;
  uint8_t* const data = static_cast<uint8_t*>(memory.data);
  uint8_t* const object = data + (0 - reinterpret_cast<uintptr_t>(data)) % object_alignment;
  rest = {object + object_bytes, memory.bytes - least};
  return object;
}

void* begin_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  uint8_t* const object = place_object(memory, object_bytes, rest);
  if (object == nullptr) return nullptr;
  for (size_t i = 0; i < object_bytes; ++i) object[i] = 0;
  return object;
}

static uint32_t checksum_of(const Sealed& object) {
  const auto* const bytes = reinterpret_cast<const uint8_t*>(&object);
  return crc32(bytes + sizeof object.checksum, object.bytes - sizeof object.checksum);
}

void Sealed::close(size_t bytes_from_here) {
  bytes = bytes_from_here;
  checksum = checksum_of(*this);
}

discmc_memory Sealed::part(size_t bytes_from_here) const {
  const auto before =
      reinterpret_cast<const uint8_t*>(this) - static_cast<const uint8_t*>(memory.data);
  return {memory.data, static_cast<size_t>(before) + bytes_from_here};
}

Sealed* begin_sealed(const discmc_memory& memory, const Kind& kind, Memory& rest) {
  auto* const object = static_cast<Sealed*>(begin_object(memory, kind.object_bytes, rest));
  if (object == nullptr) return nullptr;
  object->layout = kind.layout;
  object->memory = memory;
  object->kind = &kind;
  return object;
}

Sealed* open_sealed(const discmc_memory& memory, const Kind& kind, Memory& rest,
                    discmc_status& status) {
  auto* const object = reinterpret_cast<Sealed*>(place_object(memory, kind.object_bytes, rest));
  status = object == nullptr ? DISCMC_TOO_LITTLE_MEMORY : DISCMC_BAD_CHECKPOINT;
  // Every member of a damaged object may have any value.
  if (object == nullptr || object->layout != kind.layout || object->bytes < sizeof(Sealed) ||
      object->bytes > kind.object_bytes + rest.bytes || object->checksum != checksum_of(*object))
    return nullptr;
  status = DISCMC_OK;
  object->memory = memory;
  object->kind = &kind;
  return object;
}

}  // namespace discmc

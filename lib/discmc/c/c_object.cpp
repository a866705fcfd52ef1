#include <discmc/c/object.hpp>

namespace discmc {

static uint8_t* place_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  const size_t needed = object_bytes + object_alignment - 1;
  if (memory.data == nullptr || memory.bytes < needed) return nullptr;
  uint8_t* const data = static_cast<uint8_t*>(memory.data);
  uint8_t* const object = data + (0 - reinterpret_cast<uintptr_t>(data)) % object_alignment;
  rest = {object + object_bytes, memory.bytes - needed};
  return object;
}

void* begin_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  uint8_t* const object = place_object(memory, object_bytes, rest);
  if (object == nullptr) return nullptr;
  for (size_t i = 0; i < object_bytes; ++i) object[i] = 0;
  return object;
}

KindObject* begin_kind_object(const discmc_memory& memory, const Kind& kind, Memory& rest) {
  auto* const object = static_cast<KindObject*>(begin_object(memory, kind.object_bytes, rest));
  if (object == nullptr) return nullptr;
  object->layout = kind.layout;
  object->memory = memory;
  object->kind = &kind;
  return object;
}

// The C++ object checks the rest.
KindObject* saved_kind_object(const discmc_memory& memory, const Kind& kind, Memory& rest,
                              discmc_status& status) {
  void* const object_memory = place_object(memory, kind.object_bytes, rest);
  auto* const object = static_cast<KindObject*>(object_memory);
  status = object == nullptr ? DISCMC_TOO_LITTLE_MEMORY : DISCMC_BAD_CHECKPOINT;
  if (object == nullptr || object->layout != kind.layout) return nullptr;
  object->memory = memory;
  object->kind = &kind;
  return object;
}

}  // namespace discmc

// The objects of C in the caller's memory, and how they are saved there.
#ifndef DISCMC_C_OBJECT_HPP
#define DISCMC_C_OBJECT_HPP

#include <discmc/discmc.h>
#include <discmc/memory.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// The alignment of every object. The bytes that alignment may cost are always reserved.
constexpr size_t object_alignment = 8;
constexpr uint64_t bytes_with_object(size_t object_bytes, uint64_t rest) {
  return object_alignment - 1 + object_bytes + rest;
}

/// Places an object of this many bytes in a memory, filled with zeros, which are an object that was
/// not started. Sets `rest` to the rest of the memory. Null if the memory has no room.
void* begin_object(const discmc_memory& memory, size_t object_bytes, Memory& rest);

template <class Object>
Object* begin(const discmc_memory& memory, Memory& rest) {
  static_assert(alignof(Object) <= object_alignment, "objects are aligned");
  static_assert(__is_trivially_copyable(Object), "an object is no more than its bytes");
  return static_cast<Object*>(begin_object(memory, sizeof(Object), rest));
}

/// The first members of every kind.
struct Kind {
  uint32_t layout;  ///< of the object: differs between builds and kinds
  uint32_t object_bytes;
};

/// The first members of an object that has a kind and can be saved.
struct KindObject {
  uint32_t layout;       // of the kind
  discmc_memory memory;  // of the config
  const Kind* kind;

  /// The first bytes of the config's memory: up to this many after the object.
  discmc_memory part_with(size_t used_bytes) const {
    const auto* const begin = static_cast<const uint8_t*>(memory.data);
    const auto* const object = reinterpret_cast<const uint8_t*>(this);
    return {memory.data, static_cast<size_t>(object - begin) + kind->object_bytes + used_bytes};
  }
};

/// Returns the object of a config, or null if the memory has no room. The object is not started, or
/// is the one saved there, with a status.
KindObject* begin_kind_object(const discmc_memory& memory, const Kind& kind, Memory& rest);
KindObject* saved_kind_object(const discmc_memory& memory, const Kind& kind, Memory& rest,
                              discmc_status& status);

/// Starts the object of a config by `call`, with the object and the rest of its memory. A suspended
/// object has started.
template <class Object, class Config, class Call>
discmc_status start(Object** object, const Config& config, Call call) {
  if (config.kind == nullptr) return DISCMC_NO_KIND;
  Memory rest;
  auto* const begun = static_cast<Object*>(begin_kind_object(config.memory, *config.kind, rest));
  if (begun == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  const Status status = call(*begun, rest);
  if (status == Status::ok || status == Status::suspended) *object = begun;
  return static_cast<discmc_status>(status);
}
template <class Object, class Config, class Call>
discmc_status restore(Object** object, const Config& config, Call call) {
  if (config.kind == nullptr) return DISCMC_NO_KIND;
  Memory rest;
  discmc_status status;
  auto* const saved =
      static_cast<Object*>(saved_kind_object(config.memory, *config.kind, rest, status));
  if (saved != nullptr) status = static_cast<discmc_status>(call(*saved, rest));
  if (status == DISCMC_OK) *object = saved;
  return status;
}

}  // namespace discmc

#endif

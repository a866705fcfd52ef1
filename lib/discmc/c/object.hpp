// Where objects of C's lie in the memory of the caller, and how they are saved there.
#ifndef DISCMC_C_OBJECT_HPP
#define DISCMC_C_OBJECT_HPP

#include <discmc/discmc.h>
#include <discmc/arena.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Of every object. What it may cost at the beginning is set aside, needed or not.
constexpr size_t object_alignment = 8;
constexpr uint64_t bytes_with_object(size_t object_bytes, uint64_t rest) {
  return object_alignment - 1 + object_bytes + rest;
}

/// Where an object of so many bytes lies in a memory, and what of the memory is left; null if it
/// has no room.
void* place_object(const discmc_memory& memory, size_t object_bytes, Memory& rest);
/// The same, and fills the place with zeros, which are an object that was never started.
void* begin_object(const discmc_memory& memory, size_t object_bytes, Memory& rest);

/// The same for an object of a type.
template <class Object>
Object* begin(const discmc_memory& memory, Memory& rest) {
  static_assert(alignof(Object) <= object_alignment, "objects are aligned");
  static_assert(__is_trivially_copyable(Object), "an object is no more than its bytes");
  return static_cast<Object*>(begin_object(memory, sizeof(Object), rest));
}

/// What an object that can be saved begins with.
struct Seal {
  uint32_t checksum;     // of the bytes that follow this
  uint32_t layout;       // of the object: another build, or kind, has another number
  size_t bytes;          // that are sealed, from here on
  discmc_memory memory;  // of the config

  /// So many bytes from here on, and what lies before them in the memory.
  discmc_memory part(size_t bytes_from_here) const {
    const auto before = reinterpret_cast<const uint8_t*>(this) - static_cast<uint8_t*>(memory.data);
    return {memory.data, static_cast<size_t>(before) + bytes_from_here};
  }
  /// Seals them, and returns the same.
  discmc_memory close(size_t bytes_from_here);
};

/// Whether bytes are those that were sealed with this layout, as far as they lie within so many.
bool is_whole(const Seal& seal, uint32_t layout, size_t most_bytes);

/// Starts the object of a config by `start`, at the beginning of its memory. It begins with a seal
/// and a kind.
template <class Object, class Config, class Start>
discmc_status start(Object** object, const Config& config, Start start) {
  static_assert(alignof(Object) <= object_alignment, "objects are aligned");
  Memory rest;
  auto* const place =
      static_cast<Object*>(begin_object(config.memory, config.kind->object_bytes, rest));
  if (place == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  place->seal.layout = config.kind->layout;
  place->seal.memory = config.memory;
  place->kind = config.kind;
  const Status status = start(*place, rest);
  if (status == Status::ok) *object = place;
  return static_cast<discmc_status>(status);
}

/// The same of an object that was sealed there.
template <class Object, class Config, class Start>
discmc_status restore(Object** object, const Config& config, Start start) {
  Memory rest;
  auto* const place =
      static_cast<Object*>(place_object(config.memory, config.kind->object_bytes, rest));
  if (place == nullptr) return DISCMC_TOO_LITTLE_MEMORY;
  if (!is_whole(place->seal, config.kind->layout, config.kind->object_bytes + rest.bytes))
    return DISCMC_BAD_CHECKPOINT;
  place->seal.memory = config.memory;
  place->kind = config.kind;
  const Status status = start(*place, rest);
  if (status == Status::ok) *object = place;
  return static_cast<discmc_status>(status);
}

}  // namespace discmc

#endif

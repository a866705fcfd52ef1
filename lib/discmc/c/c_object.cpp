#include <discmc/c/object.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc {

void* place_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  const size_t least = object_bytes + object_alignment - 1;
  if (memory.data == nullptr || memory.bytes < least) return nullptr;
  uint8_t* const data = static_cast<uint8_t*>(memory.data);
  uint8_t* const object = data + (0 - reinterpret_cast<uintptr_t>(data)) % object_alignment;
  rest = {object + object_bytes, memory.bytes - least};
  return object;
}

void* begin_object(const discmc_memory& memory, size_t object_bytes, Memory& rest) {
  auto* const object = static_cast<uint8_t*>(place_object(memory, object_bytes, rest));
  if (object == nullptr) return nullptr;
  for (size_t i = 0; i < object_bytes; ++i) object[i] = 0;
  return object;
}

static uint32_t checksum_of(const Seal& seal) {
  const auto* const bytes = reinterpret_cast<const uint8_t*>(&seal);
  return crc32(bytes + sizeof seal.checksum, seal.bytes - sizeof seal.checksum);
}

discmc_memory Seal::close(size_t bytes_from_here) {
  bytes = bytes_from_here;
  checksum = checksum_of(*this);
  return part(bytes_from_here);
}

bool is_whole(const Seal& seal, uint32_t layout, size_t most_bytes) {
  return seal.layout == layout && seal.bytes >= sizeof seal && seal.bytes <= most_bytes &&
         seal.checksum == checksum_of(seal);
}

}  // namespace discmc

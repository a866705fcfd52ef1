#include <discmc/checkpoint.hpp>

#include <discmc/base/arena.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc::detail {

// The checksum begins with the properties that a restored object must share with the saved one.
uint32_t Seal::checksum_of(const void* object, uint32_t object_bytes, uint32_t layout,
                           const void* memory) {
  const uint32_t own_checksum = checksum_;
  checksum_ = 0;  // the seal is part of the object
  const uint32_t offset = reinterpret_cast<uintptr_t>(memory) % Arena::alignment;
  const uint32_t common = layout << 16 ^ object_bytes << 2 ^ offset;
  const uint32_t object_checksum = crc32(static_cast<const uint8_t*>(object), object_bytes, common);
  checksum_ = own_checksum;
  return crc32(static_cast<const uint8_t*>(memory), memory_bytes_, object_checksum);
}

void Seal::close(void* object, uint32_t object_bytes, uint32_t layout, Memory used) {
  unpoison(used.data, used.bytes);  // including free slots
  memory_bytes_ = used.bytes;
  checksum_ = checksum_of(object, object_bytes, layout, used.data);
}

// Reads no more than the memory, because a damaged seal may contain any length.
bool Seal::is_intact(void* object, uint32_t object_bytes, uint32_t layout, Memory memory) {
  if (memory_bytes_ > memory.bytes) return false;
  unpoison(memory.data, memory_bytes_);
  return checksum_ == checksum_of(object, object_bytes, layout, memory.data);
}

}  // namespace discmc::detail

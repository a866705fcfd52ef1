#include <discmc/checkpoint.hpp>

#include <discmc/stream/crc32.hpp>

namespace discmc::detail {

namespace {

// The version of the sealed state. Another byte order results in another checksum.
constexpr uint32_t format = 0x334B4344;  // "DCK3"

uint32_t layout_with(uint32_t layout, const void* memory) {
  return layout << 2 | reinterpret_cast<uintptr_t>(memory) % Arena::alignment;
}

}  // namespace

uint32_t Seal::checksum_of(const void* object, uint32_t object_bytes, const void* memory) {
  const uint32_t before = checksum_;
  checksum_ = 0;  // the seal is a part of the object
  const uint32_t of_object = crc32(static_cast<const uint8_t*>(object), object_bytes, format);
  checksum_ = before;
  return crc32(static_cast<const uint8_t*>(memory), memory_bytes_, of_object);
}

void Seal::close(void* object, uint32_t object_bytes, uint32_t layout, Memory used) {
  unpoison(used.data, used.bytes);  // free slots, too
  layout_ = layout_with(layout, used.data);
  memory_bytes_ = used.bytes;
  checksum_ = checksum_of(object, object_bytes, used.data);
}

// Reads no more than the memory, as a damaged seal may contain any length.
bool Seal::is_intact(void* object, uint32_t object_bytes, uint32_t layout, Memory memory) {
  if (layout_ != layout_with(layout, memory.data) || memory_bytes_ > memory.bytes) return false;
  unpoison(memory.data, memory_bytes_);
  return checksum_ == checksum_of(object, object_bytes, memory.data);
}

}  // namespace discmc::detail

// A checkpoint: the state of objects between two calls, as bytes that survive a power failure.
//
// The state of an object is its own bytes, and the used bytes of the memory that it works in.
// save() seals both with a checksum, and names them as parts. Copy the parts before the next call
// of the object, for example into flash (checkpoint_store.hpp).
//
//   Memory parts[3];
//   Status status = encoder.save(parts);                                  // 1 part
//   if (status == Status::ok) status = extractor.save(parts + 1);         // 2 parts
//   if (status == Status::ok) ...                                         // copy the parts
//
// After the failure, read the parts back to where they were: into the objects and their memory.
// restore() checks the seal, and continues the scan:
//
//   const Memory parts[] = {memory_of(encoder), memory_of(extractor), memory_of(memory)};
//   ...                                                                   // read the parts back
//   if (encoder.restore(output) == Status::ok &&
//       extractor.restore(memory_of(memory), make_sink(encoder)) == Status::ok)
//     ...                       // continue with row extractor.rows() of slice extractor.slices()
//
// Nothing is lost if the output reports its unsent bytes (byte_output.hpp): save() waits for them.
// The encoder sends everything after the checkpoint again. Truncate a stored stream to its first
// encoder.bytes() bytes. On a link, send one zero byte first: a decoder then counts the repeated
// packets and decodes each packet once.
//
// Each object checks its own parts. Write the parts of all objects as one unit, as a store does:
// an old encoder with a new extractor would continue another stream. Only the build that saved a
// checkpoint can restore it. A piece of memory may lie at another
// address that is the same modulo Arena::alignment. The checksum detects accidents, not attacks:
// store checkpoints where no one else writes.
#ifndef DISCMC_CHECKPOINT_HPP
#define DISCMC_CHECKPOINT_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/memory.hpp>

namespace discmc {

namespace detail {

/// The seal of an object, which is one of its members.
class Seal {
 public:
  /// Seals the object and the used bytes of its memory. layout: differs between types of objects.
  void close(void* object, uint32_t object_bytes, uint32_t layout, Memory used);
  /// Whether the object and the sealed bytes at the beginning of this memory are unchanged.
  bool is_intact(void* object, uint32_t object_bytes, uint32_t layout, Memory memory);

 private:
  uint32_t checksum_of(const void* object, uint32_t object_bytes, uint32_t layout,
                       const void* memory);

  uint32_t checksum_ = 0;  // of all, with 0 here
  size_t memory_bytes_ = 0;
};

}  // namespace detail

/// The memory of an object that is saved as its own bytes, such as an encoder.
template <class Object, class = decltype(&Object::save)>
Memory memory_of(Object& object) {
  return {&object, sizeof object};
}

}  // namespace discmc

#endif

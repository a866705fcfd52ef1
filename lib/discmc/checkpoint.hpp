// A checkpoint: what an object is between two calls, as bytes that survive a power failure.
//
// An extractor's goes with the memory that it works in, an encoder's stands alone. Both at once are
// a scan: written between two rows they let it go on later with the same bytes of stream as if
// nothing had happened. A SliceEncoder's goes with its memory and is a scan of its own.
//
//   static Checkpoint<Extractor16> scan;
//   static Checkpoint<Encoder> stream;
//   if (extractor.save(scan) == Status::ok && encoder.save(stream) == Status::ok)
//     ...             // write scan, stream and the first extractor.bytes_used() bytes of memory
//
//   ...               // after the failure: read all three back, the memory into the memory
//   if (encoder.restore(stream, output) == Status::ok &&
//       extractor.restore(scan, memory, make_sink(encoder)) == Status::ok)
//     ...             // go on with row extractor.rows() of slice extractor.slices()
//
// A failure while they are written leaves them torn, which restore() finds out; so write two in
// turn, and go back to the other. What was sent after the checkpoint is sent again: whoever keeps
// the stream goes back to its first encoder.bytes() bytes, or sends a zero byte between the torn
// end and the rest. Then a decoder finds repeated packets, and takes each once.
#ifndef DISCMC_CHECKPOINT_HPP
#define DISCMC_CHECKPOINT_HPP

#include <discmc/arena.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc {

/// What a checkpoint says of itself.
struct CheckpointHead {
  /// Of this layout and of the state within; another byte order reads another number.
  static constexpr uint32_t current_format = 0x324B4344;  // "DCK2"

  uint32_t format;
  uint32_t layout;         ///< of the object: another build's has another number
  uint64_t memory_bytes;   ///< the first ones of the memory, which belong to the checkpoint
  uint32_t memory_offset;  ///< of the memory from a multiple of Arena::alignment
  uint32_t checksum;       ///< of the head with 0 in this place, of the object and of the memory
};

/// An Object and the memory it works in, at one moment. It holds no addresses, is copied as plain
/// bytes, unlike the object itself, and can be restored by the build that saved it, wherever its
/// memory then lies. The checksum finds accidents, not attacks: store it where nobody else writes.
template <class Object>
struct Checkpoint {
  CheckpointHead head;
  Object object;

  /// Seals what `object` holds, and the memory in use. Cost: some 50 instructions a byte of both.
  void seal(Memory used) { head = head_with(used); }

  /// Whether this and the memory are what was sealed. Never reads beyond memory.bytes.
  /// Cost: as seal().
  bool is_whole(Memory memory) const {
    if (head.memory_bytes > memory.bytes) return false;
    const CheckpointHead now = head_with({memory.data, static_cast<size_t>(head.memory_bytes)});
    return head.format == now.format && head.layout == now.layout &&
           head.memory_offset == now.memory_offset && head.checksum == now.checksum;
  }

 private:
  CheckpointHead head_with(Memory used) const {
    const auto offset = reinterpret_cast<uintptr_t>(used.data) % Arena::alignment;
    CheckpointHead described{CheckpointHead::current_format, sizeof(Object) | Object::layout << 16,
                             used.bytes, static_cast<uint32_t>(offset), 0};
    uint32_t checksum = crc32(reinterpret_cast<const uint8_t*>(&described), sizeof described);
    checksum = crc32(reinterpret_cast<const uint8_t*>(&object), sizeof object, checksum);
    described.checksum = crc32(static_cast<const uint8_t*>(used.data), used.bytes, checksum);
    return described;
  }
};

}  // namespace discmc

#endif

// A checkpoint: the state of an object between two calls, as bytes that survive a power failure.
//
// The checkpoint of an extractor needs the memory of the extractor as well; the checkpoint of an
// encoder needs nothing else. Save both between two rows: after restore() the stream continues byte
// for byte as if nothing had happened. A SliceEncoder needs only its own checkpoint and memory.
//
//   static Checkpoint<Extractor16> scan;
//   static Checkpoint<Encoder> stream;
//   if (extractor.save(scan) == Status::ok && encoder.save(stream) == Status::ok)
//     ...             // write scan, stream and the first extractor.bytes_used() bytes of memory
//
//   ...               // after the failure: read scan, stream and memory back
//   if (encoder.restore(stream, output) == Status::ok &&
//       extractor.restore(scan, memory, make_sink(encoder)) == Status::ok)
//     ...             // continue with row extractor.rows() of slice extractor.slices()
//
// A failure during the write leaves a torn checkpoint, which restore() rejects. So write to two
// places in turn, and restore the newer checkpoint that is whole; checkpoint_store.hpp does so in
// flash. The encoder sends everything after the checkpoint again. Truncate a stored stream to its
// first encoder.bytes() bytes. On a link, send one zero byte first: a decoder then counts the
// repeated packets and decodes each packet once.
#ifndef DISCMC_CHECKPOINT_HPP
#define DISCMC_CHECKPOINT_HPP

#include <discmc/arena.hpp>
#include <discmc/stream/crc32.hpp>

namespace discmc {

/// The header of a checkpoint.
struct CheckpointHead {
  /// The version of the header and of the state. Another byte order reads another number.
  static constexpr uint32_t current_format = 0x324B4344;  // "DCK2"

  uint32_t format;
  uint32_t layout;         ///< from sizeof(Object) and Object::layout; builds may agree in it
  uint64_t memory_bytes;   ///< the first bytes of the memory, which belong to the checkpoint
  uint32_t memory_offset;  ///< address of the memory modulo Arena::alignment
  uint32_t checksum;       ///< of the header with 0 in this member, of the object and of the memory
};

/// The state of an Object at one moment, with the checksum of its memory. A checkpoint holds no
/// addresses and is copied as plain bytes, unlike the object itself. The same build restores the
/// checkpoint, with the memory at any address that is the same modulo Arena::alignment. The
/// checksum detects accidents, not attacks: store checkpoints where no one else writes.
template <class Object>
struct Checkpoint {
  CheckpointHead head;
  Object object;

  /// Computes the header for `object` and the used memory. Cost: about 50 instructions per byte of
  /// both.
  void seal(Memory used) { head = head_with(used); }

  /// Whether this and the memory are unchanged since seal(). Never reads beyond memory.bytes. Cost:
  /// as seal().
  bool is_whole(Memory memory) const {
    if (head.memory_bytes > memory.bytes) return false;
    const CheckpointHead now = head_with({memory.data, static_cast<size_t>(head.memory_bytes)});
    return head.format == now.format && head.layout == now.layout &&
           head.memory_offset == now.memory_offset && head.checksum == now.checksum;
  }

 private:
  CheckpointHead head_with(Memory used) const {
    unpoison(used.data, used.bytes);  // free slots, too
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

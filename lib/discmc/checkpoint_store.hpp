// A store of checkpoints in flash: the newest whole one is there after a power failure, whenever
// that came.
//
//   store.start(device, max_bytes, buffer)   once: finds the newest whole checkpoint
//   store.restore(parts, count)               if has_checkpoint(): reads it back
//   store.erase_ahead(bytes)                  between rows, while a scan goes on: saves time later
//   store.save(parts, count)                  between two rows; while it says `suspended`, resume()
//
// A checkpoint is the bytes of some parts, one behind the other: objects of checkpoint.hpp, and the
// memory in use. While it is saved they must stay as they are, so the scan stands still, but the
// firmware need not: each call erases one block or programs one unit.
//
// The flash is divided into slots, as many as it has room for, at least two, which are written in
// turn. So all blocks wear alike, and the newest checkpoint is never in a block that is erased.
#ifndef DISCMC_CHECKPOINT_STORE_HPP
#define DISCMC_CHECKPOINT_STORE_HPP

#include <stdint.h>
#include <discmc/arena.hpp>
#include <discmc/status.hpp>

namespace discmc {

// ---- A flash memory as its driver shows it: what checkpoints are written to.

/// The part of a memory that is for checkpoints. Units: bytes, but for the blocks.
struct FlashGeometry {
  uint32_t program_bytes = 0;  ///< programmed and read at once; may be several units of the device
  uint32_t block_bytes = 0;    ///< erased at once; a multiple of program_bytes
  uint32_t blocks = 0;         ///< how many; numbered from 0

  static constexpr uint32_t min_program_bytes = 16;
  static constexpr uint32_t max_block_bytes = uint32_t{1} << 30;

  constexpr uint32_t units_per_block() const { return block_bytes / program_bytes; }
  constexpr bool is_valid() const {
    return program_bytes >= min_program_bytes && block_bytes >= program_bytes &&
           block_bytes <= max_block_bytes && block_bytes % program_bytes == 0 && blocks > 0 &&
           blocks <= UINT32_MAX / units_per_block();
  }
};

/// The functions of a driver; those of littlefs's lfs_config do the same. Each returns 0, or any
/// other number for an error. They are called within calls of the CheckpointStore that has them, by
/// the same thread, and at no other time. They may wait, or return while the device is still at
/// work, where each call that follows waits until it is done. They must not call the store, nor
/// throw. Owner: the context is the caller's.
struct FlashDevice {
  void* context = nullptr;
  /// Reads a unit: `bytes` is geometry.program_bytes, and `offset` a multiple of it, within a
  /// block.
  int (*read)(void* context, uint32_t block, uint32_t offset, void* buffer,
              uint32_t bytes) = nullptr;
  /// Programs a unit of a block that was erased, once: a unit is never programmed again before the
  /// block is erased again, and those of a block are programmed in their order.
  int (*program)(void* context, uint32_t block, uint32_t offset, const void* buffer,
                 uint32_t bytes) = nullptr;
  /// Erases a block. Null where the device needs none, as FRAM and MRAM.
  int (*erase)(void* context, uint32_t block) = nullptr;
  /// Comes back when all is in the memory to stay. Null where it always is.
  int (*sync)(void* context) = nullptr;
  FlashGeometry geometry;
};

// ---- Checkpoints in it.

/// What a checkpoint says of itself in flash. Behind it come the bytes of its parts and a checksum
/// of all that.
struct StoredHead {
  static constexpr uint32_t current_format = 0x31534344;  // "DCS1"

  uint32_t format;
  uint32_t sequence;  ///< one more than of the checkpoint before, modulo 2^32
  uint32_t bytes;     ///< of all parts
  uint32_t checksum;  ///< of the three above
};

/// How checkpoints lie in a flash, what they wear, and how long they take. A checkpoint that is
/// larger than a block has blocks of its own; of smaller ones several share a block, which is
/// erased for the first of them.
struct StorePlan {
  FlashGeometry geometry;
  uint32_t max_bytes = 0;        ///< of the parts of a checkpoint
  uint32_t slot_units = 0;       ///< program units of a slot
  uint32_t slots_per_block = 0;  ///< 1 where a slot has one block or several of its own
  uint32_t blocks_per_slot = 0;  ///< 1 where several slots share a block
  uint32_t slots = 0;            ///< checkpoints that there is room for

  static constexpr uint32_t head_bytes = sizeof(StoredHead);
  static constexpr uint32_t tail_bytes = sizeof(uint32_t);
  static constexpr uint32_t max_checkpoint_bytes = uint32_t{1} << 30;

  /// Whether one checkpoint stays whole while another is written.
  constexpr bool is_valid() const { return slots >= 2 * slots_per_block && slots > 0; }

  /// What a checkpoint of so many bytes programs, and erases where nothing was erased ahead and its
  /// slot is the first of its block. Limit: is_valid().
  constexpr uint32_t units(uint32_t bytes) const {
    return (head_bytes + bytes + tail_bytes + geometry.program_bytes - 1) / geometry.program_bytes;
  }
  constexpr uint32_t blocks(uint32_t bytes) const {
    const uint32_t per_block = geometry.units_per_block();
    return slots_per_block > 1 ? 1 : (units(bytes) + per_block - 1) / per_block;
  }

  /// So many checkpoints wear a flash out whose blocks bear so many erasures. A start that finds a
  /// block begun goes on with the next, so it may count as slots_per_block of them.
  constexpr uint64_t checkpoints_until_worn(uint32_t erasures) const {
    return uint64_t{slots} * erasures;
  }

  /// The time that a checkpoint of so many bytes takes in flash; without the erasing, if that was
  /// done ahead, it is that of erase_us = 0. erase_us: of a block; program_us: of a program unit.
  constexpr uint64_t microseconds(uint32_t bytes, uint32_t erase_us, uint32_t program_us) const {
    return uint64_t{blocks(bytes)} * erase_us + uint64_t{units(bytes)} * program_us;
  }
};

/// How checkpoints of at most so many bytes lie in a flash. Not is_valid() where the geometry is
/// not, or has no room for two of them in blocks of their own.
constexpr StorePlan store_plan(const FlashGeometry& geometry, uint32_t max_bytes) {
  StorePlan plan{geometry, max_bytes};
  if (!geometry.is_valid() || max_bytes == 0 || max_bytes > StorePlan::max_checkpoint_bytes)
    return plan;
  plan.slot_units = plan.units(max_bytes);
  const uint32_t per_block = geometry.units_per_block();
  plan.slots_per_block = plan.slot_units <= per_block ? per_block / plan.slot_units : 1;
  plan.blocks_per_slot = (plan.slot_units + per_block - 1) / per_block;
  plan.slots = geometry.blocks / plan.blocks_per_slot * plan.slots_per_block;
  return plan;
}

/// Keeps checkpoints in flash. It points into itself, so it is neither copied nor moved.
class CheckpointStore {
 public:
  static constexpr uint32_t max_parts = 4;

  CheckpointStore() = default;
  CheckpointStore(const CheckpointStore&) = delete;
  CheckpointStore& operator=(const CheckpointStore&) = delete;

  /// Finds the newest whole checkpoint of a flash; what else is there, erased or not, is of no
  /// matter. max_bytes: of all parts of a checkpoint; another number than before may not find what
  /// was saved then. buffer: at least geometry.program_bytes; Owner: the caller, as for the device,
  /// as long as the store is used. Errors: bad_device (no read() or program(), or no valid
  /// store_plan()), too_little_memory (the buffer). device_error: a read failed, and no checkpoint
  /// was found; the store is started all the same, and may save over what could not be read.
  /// Cost: a unit is read of every slot, all units of the newest, and its checksum.
  [[nodiscard]] Status start(const FlashDevice& device, uint32_t max_bytes, Memory buffer);

  /// Whether there is a whole checkpoint, how many bytes it has, and its number: one more than of
  /// the one before. Without one, 0.
  bool has_checkpoint() const { return has_newest_; }
  uint32_t bytes() const { return has_newest_ ? newest_bytes_ : 0; }
  uint32_t sequence() const { return has_newest_ ? newest_sequence_ : 0; }

  /// Reads the newest checkpoint. parts: as they were saved, but the last may have more bytes than
  /// then: the rest stays as it is. Breaks off a save that is under way. Errors: not_started,
  /// bad_checkpoint (there is none; its bytes are not as many as the parts', then nothing is
  /// written; or it is damaged since start()), device_error. Cost: it is read, and its checksum.
  [[nodiscard]] Status restore(const Memory* parts, uint32_t count);

  /// Erases a block for the next checkpoint, if one is left to erase for so many bytes. The scan
  /// may go on between calls. Status::suspended: call again. Errors: not_started, device_error.
  [[nodiscard]] Status erase_ahead(uint32_t bytes);

  /// Begins to save a checkpoint, and does the first step of resume(). parts: copied, at most
  /// max_parts; Owner: what they lead to is the caller's, and stays as it is up to another status
  /// than `suspended`. Until then the checkpoint before is the newest. Breaks off a save that is
  /// under way. Errors: not_started, too_little_memory (more parts or bytes than there is room
  /// for), device_error.
  [[nodiscard]] Status save(const Memory* parts, uint32_t count);

  /// Goes on with the save that is under way, if there is one: erases a block, or programs a unit
  /// and reads it again. Errors: not_started. device_error: a call of the device failed, or a unit
  /// reads otherwise than it was programmed. Then the save is broken off, and the next one takes
  /// other blocks if there are more than two slots. Cost: an erasure or a unit, and its checksum
  /// three times: some 150 instructions a byte.
  [[nodiscard]] Status resume();

  const StorePlan& plan() const { return plan_; }

 private:
  // The bytes of a slot, piece by piece: the head, the parts, the checksum.
  struct Pieces {
    Memory of[max_parts + 2];
    uint32_t count;
    uint32_t at;
    size_t offset;
    uint32_t checksum;  // of the pieces before the last
  };

  bool is_started() const { return buffer_ != nullptr; }
  Status find_newest();
  bool find_head_before(const StoredHead* bound, StoredHead& head, uint32_t& slot);
  bool is_whole(uint32_t slot, const StoredHead& head);
  Status read_slot(uint32_t slot);
  bool read_head(uint32_t slot, StoredHead& head);

  bool set_parts(const Memory* parts, uint32_t count);
  void begin_pieces();
  void move_pieces(bool to_unit);

  Status step();
  bool program_unit();
  bool erase_block();
  bool read(uint32_t slot, uint32_t unit);
  void place_of(uint32_t slot, uint32_t unit, uint32_t& block, uint32_t& offset) const;
  void complete();
  Status fail();
  void break_off();
  uint32_t group_of(uint32_t slot) const { return slot / plan_.slots_per_block; }
  void go_to_other_blocks();

  FlashDevice device_;
  StorePlan plan_;
  uint8_t* buffer_ = nullptr;

  bool has_newest_ = false;
  bool read_failed_ = false;
  bool is_saving_ = false;
  uint32_t newest_ = 0;  // its slot
  uint32_t newest_bytes_ = 0;
  uint32_t newest_sequence_ = 0;
  uint32_t sequence_ = 0;  // the last that was given
  uint32_t slot_ = 0;      // of the next checkpoint, or of that which is saved
  uint32_t erased_ = 0;    // its first blocks that are erased
  uint32_t unit_ = 0;      // the next to program
  StoredHead head_{};
  uint32_t tail_ = 0;
  Pieces pieces_{};
};

}  // namespace discmc

#endif

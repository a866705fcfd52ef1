// A store of checkpoints in flash. After a power failure at any time, the store finds the newest
// complete checkpoint.
//
//   store.start(device, max_bytes, buffer)   at power-on: finds the newest complete checkpoint
//   store.restore(parts, count)               if has_checkpoint(): reads it back
//   store.discard()                           before a scan that starts from its beginning
//   store.erase_ahead(bytes)                  between rows during a scan: saves time later
//   store.save(parts, count)                  between two rows; while `suspended`, call resume()
//   store.discard()                           after a scan whose last byte has left the output
//
// A checkpoint consists of the parts that the save() functions of objects name (checkpoint.hpp).
// The parts must not change during a save, so the scan pauses. The firmware keeps running: each
// call erases one block or programs one unit.
//
// The store divides the flash into as many flash slots as fit, at least two, and writes them in
// turn. So all blocks wear alike, and an erase never hits the newest checkpoint.
#ifndef DISCMC_CHECKPOINT_STORE_HPP
#define DISCMC_CHECKPOINT_STORE_HPP

#include <stdint.h>
#include <discmc/memory.hpp>
#include <discmc/status.hpp>

namespace discmc {

// ---- The interface of a flash driver.

/// The geometry of the flash area for checkpoints. Units: bytes, except `blocks`.
struct FlashGeometry {
  uint32_t program_bytes = 0;  ///< programmed and read at once; may be several units of the device
  uint32_t block_bytes = 0;    ///< erased at once; a multiple of program_bytes
  uint32_t blocks = 0;         ///< number of blocks, which count from 0

  static constexpr uint32_t min_program_bytes = 16;
  static constexpr uint32_t max_block_bytes = uint32_t{1} << 30;

  constexpr uint32_t units_per_block() const { return block_bytes / program_bytes; }
  constexpr bool is_valid() const {
    return program_bytes >= min_program_bytes && block_bytes >= program_bytes &&
           block_bytes <= max_block_bytes && block_bytes % program_bytes == 0 && blocks > 0 &&
           blocks <= UINT32_MAX / units_per_block();
  }
};

/// The functions of a driver, as in littlefs's lfs_config. Each returns 0, or any other number on
/// an error. The CheckpointStore calls them during its own calls, in the caller's thread. A
/// function may block, or may return while the device is busy if the next call then waits. It must
/// not call the store, and must not throw. Owner: the context belongs to the caller.
struct FlashDevice {
  void* context = nullptr;
  /// Reads a unit: `bytes` is geometry.program_bytes, and `offset` is a multiple of it within a
  /// block.
  int (*read)(void* context, uint32_t block, uint32_t offset, void* buffer,
              uint32_t bytes) = nullptr;
  /// Programs a unit of an erased block. The store programs the units of a block in ascending
  /// order, and each unit once per erase.
  int (*program)(void* context, uint32_t block, uint32_t offset, const void* buffer,
                 uint32_t bytes) = nullptr;
  /// Erases a block. Null if the device needs no erase, as FRAM and MRAM.
  int (*erase)(void* context, uint32_t block) = nullptr;
  /// Returns when all data is non-volatile. Null if the driver buffers nothing.
  int (*sync)(void* context) = nullptr;
  FlashGeometry geometry;
};

// ---- The store.

/// The header of a checkpoint in flash. The lengths of the parts, their bytes and a checksum follow
/// it: the CRC of lengths and bytes, continued from the checksum of the header.
struct StoredHead {
  static constexpr uint32_t current_format = 0x32534344;  // "DCS2"

  uint32_t format;
  uint32_t sequence;  ///< the number of the previous checkpoint plus 1, modulo 2^32
  uint32_t bytes;     ///< of all parts; 0 if the checkpoint only makes older ones void
  uint32_t checksum;  ///< of the three members above
};

/// The layout of checkpoints in flash, their wear and their duration. A checkpoint larger than a
/// block has blocks of its own. Smaller checkpoints share a block, which the store erases for the
/// first of them.
struct StorePlan {
  static constexpr uint32_t max_parts = 6;

  FlashGeometry geometry;
  uint32_t max_bytes = 0;        ///< of all parts of a checkpoint
  uint32_t slot_units = 0;       ///< program units of a flash slot
  uint32_t slots_per_block = 0;  ///< 1 if a slot has one or more blocks of its own
  uint32_t blocks_per_slot = 0;  ///< 1 if several slots share a block
  uint32_t slots = 0;            ///< checkpoints that fit

  static constexpr uint32_t head_bytes = sizeof(StoredHead) + max_parts * sizeof(uint32_t);
  static constexpr uint32_t tail_bytes = sizeof(uint32_t);
  static constexpr uint32_t max_checkpoint_bytes = uint32_t{1} << 30;

  /// Whether the plan is usable: one checkpoint stays complete while the store writes another.
  constexpr bool is_valid() const { return slots >= 2 * slots_per_block && slots > 0; }

  /// units(): the units that a checkpoint of this many bytes programs. blocks(): the blocks that it
  /// erases if its slot is the first of its block and nothing was erased ahead. Limit: is_valid().
  constexpr uint32_t units(uint32_t bytes) const {
    return (head_bytes + bytes + tail_bytes + geometry.program_bytes - 1) / geometry.program_bytes;
  }
  constexpr uint32_t blocks(uint32_t bytes) const {
    const uint32_t per_block = geometry.units_per_block();
    return slots_per_block > 1 ? 1 : (units(bytes) + per_block - 1) / per_block;
  }
};

/// Computes the layout for checkpoints of at most max_bytes. The plan is not is_valid() if the
/// geometry is invalid, or if two checkpoints in separate blocks do not fit.
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

/// Stores checkpoints in flash. A store contains pointers to itself, so it is neither copied nor
/// moved.
///
/// save() and discard() may need several calls. Status::suspended: call resume() until it returns
/// another status.
class CheckpointStore {
 public:
  static constexpr uint32_t max_parts = StorePlan::max_parts;

  CheckpointStore() = default;
  CheckpointStore(const CheckpointStore&) = delete;
  CheckpointStore& operator=(const CheckpointStore&) = delete;

  /// Finds the newest complete checkpoint in flash, whatever else the flash contains.
  ///
  /// max_bytes: of all parts of a checkpoint; with another value than at save(), the store may not
  /// find the checkpoint. device: copied. buffer: at least geometry.program_bytes. Owner: the
  /// caller keeps the buffer and device.context while the store is in use. Errors: bad_device (no
  /// read() or program(), or no valid store_plan()), too_little_memory (the buffer). device_error:
  /// a read failed, and no checkpoint was found; the store has started, and may overwrite what it
  /// could not read. Cost: reads one unit per slot and all units of the newest checkpoint, and
  /// computes its checksum.
  [[nodiscard]] Status start(const FlashDevice& device, uint32_t max_bytes, Memory buffer);

  /// Whether a scan can continue: the newest complete entry in flash is a checkpoint that was not
  /// discarded.
  bool has_checkpoint() const { return bytes() > 0; }
  /// The bytes of all parts of the newest checkpoint; 0 without a checkpoint.
  uint32_t bytes() const { return has_newest_ ? newest_bytes_ : 0; }
  /// The number of the newest entry, one more than that of the previous one, modulo 2^32; 0 without
  /// an entry. discard() writes an entry, too.
  uint32_t sequence() const { return has_newest_ ? newest_sequence_ : 0; }

  /// Reads the newest checkpoint. parts: in number and order as at save(), each at least as large
  /// as it was; bytes beyond the saved ones stay unchanged. Cancels a save in progress. Errors:
  /// not_started; device_error; bad_checkpoint (there is none; a part is too small or missing, and
  /// nothing is written; or it was damaged after start()). After damage or device_error the
  /// contents of the parts are undefined. Cost: reads the checkpoint and computes its checksum.
  [[nodiscard]] Status restore(const Memory* parts, uint32_t count);

  /// Erases one block for the next checkpoint of this many bytes, unless its blocks are all erased.
  /// The scan may continue between calls. Status::suspended: another block is left, call again.
  /// Errors: not_started, device_error. Cost: at most one erasure.
  [[nodiscard]] Status erase_ahead(uint32_t bytes);

  /// Starts to save a checkpoint, and performs the first step of resume(). parts: copied, at most
  /// max_parts; Owner: the caller keeps the memory behind them unchanged until the status is not
  /// `suspended`. Until then the previous checkpoint is the newest. Cancels a save in progress.
  /// Errors: not_started, too_little_memory (no byte, or too many parts or bytes), device_error.
  [[nodiscard]] Status save(const Memory* parts, uint32_t count);

  /// Makes the newest checkpoint void, so that no later start() finds a scan to continue. Call it
  /// before the first row of a scan that starts from its beginning, and after a scan whose last
  /// byte has left the output. Does nothing if has_checkpoint() is false. Cancels a save in
  /// progress. Errors: not_started, device_error. Cost: as a save of no bytes.
  [[nodiscard]] Status discard();

  /// Continues a save in progress: erases a block, or programs a unit and reads it back. Returns ok
  /// if no save is in progress. Errors: not_started. device_error: a call of the device failed, or
  /// a unit reads back with other bytes. Then the save is cancelled, and the next save uses blocks
  /// other than these and those of the previous checkpoint, if there are any. Cost: an erasure or a
  /// unit, and three checksums of the unit: about 150 instructions per byte.
  [[nodiscard]] Status resume();

  const StorePlan& plan() const { return plan_; }

 private:
  // The bytes of a slot: header, lengths, parts, checksum.
  struct Pieces {
    Memory memory[max_parts + 3];
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
  void set_pieces(const Memory* parts, uint32_t count);
  Status begin_save();
  void begin_pieces();
  void move_pieces(bool is_to_unit);

  Status step();
  bool program_unit();
  bool erase_block();
  bool read(uint32_t slot, uint32_t unit);
  void place_of(uint32_t slot, uint32_t unit, uint32_t& block, uint32_t& offset) const;
  void complete();
  Status fail();
  void cancel_save();
  uint32_t group_of(uint32_t slot) const { return slot / plan_.slots_per_block; }
  void skip_to_next_blocks();

  FlashDevice device_;
  StorePlan plan_;
  uint8_t* buffer_ = nullptr;

  bool has_newest_ = false;
  bool has_read_failed_ = false;
  bool is_saving_ = false;
  uint32_t newest_ = 0;  // its slot
  uint32_t newest_bytes_ = 0;
  uint32_t newest_sequence_ = 0;
  uint32_t sequence_ = 0;  // the last one that was assigned
  uint32_t slot_ = 0;      // of the next checkpoint, or of the one that is being saved
  uint32_t erased_ = 0;    // its first blocks that are erased
  uint32_t unit_ = 0;      // the next to program
  StoredHead head_{};
  uint32_t lengths_[max_parts] = {};  // of the parts
  uint32_t tail_ = 0;
  Pieces pieces_{};
};

}  // namespace discmc

#endif

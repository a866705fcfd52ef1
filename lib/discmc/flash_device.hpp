// A flash memory as its driver shows it: what checkpoints are written to.
#ifndef DISCMC_FLASH_DEVICE_HPP
#define DISCMC_FLASH_DEVICE_HPP

#include <stdint.h>

namespace discmc {

/// The part of a memory that is for checkpoints. Units: bytes, but for the blocks.
struct FlashGeometry {
  uint32_t program_bytes = 0;  ///< programmed and read at once; may be several units of the device
  uint32_t block_bytes = 0;    ///< erased at once; a multiple of program_bytes
  uint32_t blocks = 0;         ///< how many; numbered from 0

  static constexpr uint32_t least_program_bytes = 16;
  static constexpr uint32_t most_block_bytes = uint32_t{1} << 30;

  constexpr uint32_t units_per_block() const { return block_bytes / program_bytes; }
  constexpr bool is_valid() const {
    return program_bytes >= least_program_bytes && block_bytes >= program_bytes &&
           block_bytes <= most_block_bytes && block_bytes % program_bytes == 0 && blocks > 0 &&
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

}  // namespace discmc

#endif

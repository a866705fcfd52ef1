// A ring of rows between an interrupt and a task. The sensor's DMA controller writes each row in
// place, and the extractor reads it from there.
//
//   the interrupt of the sensor             the task
//
//   ring.free_row()  the row to fill        ring.peek()  row:     extractor.push(ring.row(), width)
//   ring.commit()    the row is filled                   lost:    extractor.skip_row(substitute)
//   ring.drop()      or the row is lost                  nothing: sleep until an interrupt has come
//   ring.end()       no row follows                      end:     extractor.finish()
//                                           ring.pop()  after a row, and after a lost row
//
// A row that arrives while the ring is full is lost. The task sees the lost row in its place, so
// later rows do not shift.
//
// One producer, one consumer. Only one side writes each word of the ring, so loads and stores
// suffice and interrupts stay enabled. Threads work as well.
#ifndef DISCMC_ROW_RING_HPP
#define DISCMC_ROW_RING_HPP

#include <discmc/base/arena.hpp>
#include <discmc/base/compiler.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Rows in transit from a sensor to a task. A ring is neither copied nor moved: two copies would
/// write to the same memory.
class RowRing {
 public:
  /// The next item for the consumer.
  enum class Next : uint8_t {
    none,   ///< nothing has arrived yet
    ready,  ///< row() holds the next row
    lost,   ///< a lost row
    end,    ///< no row follows
  };

  RowRing() = default;
  RowRing(const RowRing&) = delete;
  RowRing& operator=(const RowRing&) = delete;

  /// The memory for start(). Units: bytes.
  static constexpr uint64_t bytes_for(uint32_t row_bytes, uint32_t rows) {
    return uint64_t{rows} * Arena::aligned(row_bytes) + red_zone_bytes + Arena::bytes_of(rows, 4) +
           Arena::alignment - 1;
  }

  /// Begins a scan, with room for this many rows. Rows lie consecutively from the beginning of the
  /// memory. Each row is aligned to four bytes, or to a cache line if the memory is and row_bytes
  /// is a multiple of a line. memory: at least bytes_for(row_bytes, rows); Owner: the caller, while
  /// the ring is in use. Limit: neither side is active. Errors: bad_capacities (no rows, empty
  /// rows, or more than 4 GiB), too_little_memory; then nothing has changed.
  [[nodiscard]] Status start(uint32_t row_bytes, uint32_t rows, Memory memory) {
    // Inline, so that constant sizes fold.
    const uint64_t bytes = bytes_for(row_bytes, rows);
    if (row_bytes == 0 || rows == 0 || bytes > UINT32_MAX) return Status::bad_capacities;
    if (memory.data == nullptr || memory.bytes < bytes) return Status::too_little_memory;
    Arena arena(memory);
    row_bytes_ = static_cast<uint32_t>(Arena::aligned(row_bytes));
    rows_ = arena.allocate<uint8_t>(row_bytes_ * rows);
    numbers_ = arena.allocate<uint32_t>(rows);
    room_ = rows;
    filled_ = produced_ = ended_ = fill_index_ = 0;
    emptied_ = consumed_ = empty_index_ = 0;
    return Status::ok;
  }

  // ---- the producer: an interrupt, or several that do not interrupt each other ----

  /// Returns the row to fill next, or, for a DMA controller that is set up early, the row `ahead`
  /// rows later. Null if there is no room. Limit: started.
  void* free_row(uint32_t ahead = 0) const;

  /// Marks the free row as filled. Limit: there is a free row.
  void commit();

  /// Records lost rows before the row that is filled next: without room, damaged, or missed. Limit:
  /// fewer than 2^31 in succession.
  void drop(uint32_t rows = 1) { store_release(produced_, produced_ + rows); }

  /// Marks the end: no row follows.
  void end() { store_release(ended_, 1); }

  /// The number of the next row, which is the number of filled and lost rows before it. Units:
  /// rows, modulo 2^32.
  uint32_t produced() const { return produced_; }

  // ---- the consumer: a task, or the main loop ----

  /// Returns the next item, and changes nothing.
  Next peek() const;

  /// The bytes of the row, which may be changed in place: see packed_samples.hpp. Limit: peek() is
  /// `ready`.
  void* row() const { return rows_ + size_t{empty_index_} * row_bytes_; }

  /// Removes what peek() returned, and frees its row. Limit: peek() is `ready` or `lost`.
  void pop();

  /// The number of the next row, as produced(), and the number of lost rows before it.
  uint32_t consumed() const { return consumed_; }
  uint32_t lost() const { return consumed_ - emptied_; }

 private:
  uint8_t* rows_ = nullptr;
  uint32_t* numbers_ = nullptr;  // numbers of the rows
  uint32_t row_bytes_ = 0;
  uint32_t room_ = 0;
  // The producer writes these.
  uint32_t filled_ = 0;      // rows filled so far
  uint32_t produced_ = 0;    // rows filled or lost; written after filled_
  uint32_t ended_ = 0;       // 1: produced_ includes the last row
  uint32_t fill_index_ = 0;  // in the ring
  // The consumer writes these.
  uint32_t emptied_ = 0;
  uint32_t consumed_ = 0;
  uint32_t empty_index_ = 0;
};

}  // namespace discmc

#endif

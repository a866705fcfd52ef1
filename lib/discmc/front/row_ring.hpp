// A ring of rows between an interrupt and a task: the sensor's DMA controller writes each row where
// it stays until the extractor has read it.
//
//   the interrupt of the sensor             the task
//
//   ring.free_row()  where a row goes       ring.peek()  row:     extractor.push(ring.row(), width)
//   ring.commit()      it is there                         lost:    extractor.skip_row(substitute)
//   ring.drop()      or it is lost                       nothing: sleep until an interrupt has come
//   ring.end()       none follows                        end:     extractor.finish()
//                                           ring.pop()  after a row, and after a lost one
//
// A row that comes while the ring is full is lost, and so known to the task in its place among the
// others: what is behind it does not shift.
//
// One producer and one consumer. Each word of the ring is written by one of them, and loads and
// stores are all that is needed of a processor: interrupts need not be masked. Threads do as well.
#ifndef DISCMC_ROW_RING_HPP
#define DISCMC_ROW_RING_HPP

#include <discmc/arena.hpp>
#include <discmc/compiler.hpp>
#include <discmc/status.hpp>

namespace discmc {

/// Rows on their way from a sensor to whoever takes them. It is neither copied nor moved: two would
/// write to the same memory.
class RowRing {
 public:
  /// What comes next on the consumer's side.
  enum class Next : uint8_t {
    nothing,  ///< it has not come yet
    row,      ///< row() holds it
    lost,     ///< a row that was lost
    end,      ///< no row follows
  };

  RowRing() = default;
  RowRing(const RowRing&) = delete;
  RowRing& operator=(const RowRing&) = delete;

  /// The memory that start() takes. Units: bytes.
  static constexpr uint64_t bytes_for(uint32_t row_bytes, uint32_t rows) {
    return uint64_t{rows} * Arena::bytes_of(1, row_bytes) + Arena::bytes_of(rows, 4) +
           Arena::alignment - 1;
  }

  /// Begins a scan, with room for so many rows. Rows lie one after the other from the beginning of
  /// the memory, each aligned to four bytes; or to a cache line, where the memory is and row_bytes
  /// is a multiple of one. memory: at least bytes_for(row_bytes, rows); Owner: the caller, for as
  /// long as the ring is in use. Limit: neither side is at work. Errors: bad_capacities (no rows,
  /// empty ones, or 4 GiB of them), too_little_memory; then nothing has changed.
  [[nodiscard]] Status start(uint32_t row_bytes, uint32_t rows, Memory memory) {
    // Here, where sizes may be constants: then little is left of it.
    const uint64_t bytes = bytes_for(row_bytes, rows);
    if (row_bytes == 0 || rows == 0 || bytes > UINT32_MAX) return Status::bad_capacities;
    if (memory.data == nullptr || memory.bytes < bytes) return Status::too_little_memory;
    Arena arena(memory);
    row_bytes_ = static_cast<uint32_t>(Arena::bytes_of(1, row_bytes));
    rows_ = arena.take<uint8_t>(row_bytes_ * rows);
    numbers_ = arena.take<uint32_t>(rows);
    room_ = rows;
    filled_ = produced_ = ended_ = fill_place_ = 0;
    emptied_ = consumed_ = empty_place_ = 0;
    return Status::ok;
  }

  // ---- the producer: an interrupt, or several that do not interrupt each other ----

  /// The row to fill next, or, for a DMA controller that is told early, one that comes `ahead` rows
  /// later; null while there is no room for it. Limit: a started ring.
  void* free_row(uint32_t ahead = 0) const;

  /// The free row has been filled. Limit: there was one.
  void commit();

  /// Rows were lost, before the one that will be filled next: without room, damaged, or missed.
  /// Limit: fewer than 2^31 in succession.
  void drop(uint32_t rows = 1) { store_release(produced_, produced_ + rows); }

  /// No row follows.
  void end() { store_release(ended_, 1); }

  /// The number of the row that comes next: of so many before it, each was filled or lost. Units:
  /// rows, modulo 2^32.
  uint32_t produced() const { return produced_; }

  // ---- the consumer: a task, or the main loop ----

  /// What comes next. Harmless at any time.
  Next peek() const;

  /// The bytes of the row, which may be changed in place: see packed_samples.hpp. Limit: peek() is
  /// `row`.
  void* row() const { return rows_ + size_t{empty_place_} * row_bytes_; }

  /// Goes on behind what peek() told; a row is free again. Limit: peek() is `row` or `lost`.
  void pop();

  /// The number of what comes next, as produced(), and how many rows were lost before it.
  uint32_t consumed() const { return consumed_; }
  uint32_t lost() const { return consumed_ - emptied_; }

 private:
  uint8_t* rows_ = nullptr;
  uint32_t* numbers_ = nullptr;  // of the rows
  uint32_t row_bytes_ = 0;
  uint32_t room_ = 0;
  // Written by the producer.
  uint32_t filled_ = 0;      // rows so far
  uint32_t produced_ = 0;    // those and the lost ones; written after filled_
  uint32_t ended_ = 0;       // 1: produced_ is the last
  uint32_t fill_place_ = 0;  // in the ring
  // Written by the consumer.
  uint32_t emptied_ = 0;
  uint32_t consumed_ = 0;
  uint32_t empty_place_ = 0;
};

}  // namespace discmc

#endif

// Rows of cells cut off for lack of memory, where the sink takes no fragments.
//
// Before a row of cells is swept the records are counted that it may come to need. When they are
// not there, the row is sealed: its cells are delivered at once, each as the regions that it is
// made of, and the sweep takes them for absent. Both sides of every face of a sealed cell are then
// boundary, so the surface is the same, and a scan never runs out of records.
//
// The functions are reached through the sink, so that others do not link them.
#ifndef DISCMC_TRACE_SEALING_HPP
#define DISCMC_TRACE_SEALING_HPP

#include <discmc/capacities.hpp>
#include <discmc/sink.hpp>
#include <discmc/trace/swept_row.hpp>

namespace discmc::trace {

/// Which rows of cells are sealed, and where the delivery of the last of them is.
struct SealedRows {
  enum class Stage : uint8_t { none, cells, vertices };  ///< of the row under way

  uint32_t* bits = nullptr;  ///< sizing::sealed_words(), of the layers above even and odd slices
  uint32_t layer_words = 0;  ///< of each of the two
  int32_t last_row = 0;      ///< of voxels
  uint32_t committed = 0;    ///< records that rows of cells under way may need
  Stage stage = Stage::none;
  uint8_t patch = 0;
  uint8_t event = 0;
  bool is_word_begun = false;
  uint32_t word = 0;
  uint32_t cells = 0;  ///< of the word
};

/// What a sink that takes no fragments has an extractor do.
struct Sealing {
  void (*clear)(SealedRows& sealed, const Limits& limits);
  /// Seals the row of cells above and behind a row if it must, delivers its cells, and adds what is
  /// sealed to the absent rows. False when the sink said "not now": call again. spare: records that
  /// are free.
  bool (*begin_row)(SealedRows& sealed, SweptRow& row, uint32_t spare, const Sink& sink,
                    Statistics& statistics);
  /// A row is swept: rows of cells that it was the last around need no more records.
  void (*end_row)(SealedRows& sealed, const SweptRow& row);
};

}  // namespace discmc::trace

#endif

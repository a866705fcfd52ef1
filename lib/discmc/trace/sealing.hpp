// Rows of cells cut off for lack of memory, where the sink takes no fragments.
//
// Before a row of cells is swept the records are counted that it may come to need. When they are
// not there, the row is sealed: its cells are delivered at once, each as the regions that it is
// made of, and the sweep takes them for absent. Both sides of every face of a sealed cell are then
// boundary, so the surface is the same, and a scan never runs out of records.
#ifndef DISCMC_TRACE_SEALING_HPP
#define DISCMC_TRACE_SEALING_HPP

#include <discmc/capacities.hpp>
#include <discmc/sink.hpp>
#include <discmc/trace/bit_rows.hpp>
#include <discmc/trace/cell_patches.hpp>

namespace discmc::trace {

class Sealing {
 public:
  /// sealed: sizing::sealed_words() words.
  void start(uint32_t* sealed, const Limits& limits, bool is_in_use);
  void clear();

  /// Whether the row of cells behind voxel row y is sealed, in the layer above the slice that is
  /// swept or in the layer below it. False for y = -2, where there are none.
  bool is_sealed(int32_t y, bool is_below) const {
    return is_in_use_ && y >= -1 && (word_of(y, is_below) >> bit_of(y) & 1) != 0;
  }

  /// Decides on the row of cells above row y. spare: records that are free.
  void begin_row(const RowBlock& rows, int32_t y, uint32_t spare);
  /// Delivers the cells of a sealed row; true at once for others. False when the sink said "not
  /// now": call again. z: of the slice below them.
  bool deliver(const RowBlock& rows, int32_t y, int32_t z, const Sink& sink,
               Statistics& statistics);
  /// Row y is swept: the cells below need no more records, those in front of it and, where no row
  /// follows, those behind it. Limit: there are such cells.
  void end_front(const RowBlock& rows, int32_t y);
  void end_back(const RowBlock& rows, int32_t y);
  void end_slice() { is_odd_layer_ = !is_odd_layer_; }

 private:
  // The four rows of voxels around a row of cells.
  struct CellRow {
    const uint32_t* row[4];
  };
  static CellRow above(const RowBlock& rows) {
    return {{rows.row[1][1], rows.row[1][2], rows.row[2][1], rows.row[2][2]}};
  }
  void end(const CellRow& cells, int32_t y) {
    if (is_in_use_ && !is_sealed(y, true)) committed_ -= need(cells);
  }

  uint32_t& word_of(int32_t y, bool is_below) const {
    const uint32_t layer = is_odd_layer_ != is_below ? layer_words_ : 0;
    return sealed_[layer + static_cast<uint32_t>(y + 1) / 32];
  }
  static uint32_t bit_of(int32_t y) { return static_cast<uint32_t>(y + 1) % 32; }

  uint32_t active(const CellRow& cells, uint32_t word) const;
  uint32_t need(const CellRow& cells) const;
  bool tell(const CellPatch& patch, const Vertex& start, const Sink& sink,
            Statistics& statistics);

  uint32_t* sealed_ = nullptr;
  uint32_t layer_words_ = 0;
  uint32_t words_ = 0;
  uint32_t width_ = 0;
  uint32_t committed_ = 0;  // records that rows of cells under way may need
  bool is_in_use_ = false;
  bool is_open_ = false;
  bool is_odd_layer_ = false;

  // Where the delivery is: the word and its cells, the patch and the event.
  bool is_word_begun_ = false;
  uint8_t patch_ = 0;
  uint8_t event_ = 0;
  uint32_t word_ = 0;
  uint32_t cells_ = 0;
};

}  // namespace discmc::trace

#endif

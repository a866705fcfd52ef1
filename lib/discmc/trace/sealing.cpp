#include <discmc/compiler.hpp>
#include <discmc/trace/sealing.hpp>

namespace discmc::trace {

void Sealing::start(uint32_t* sealed, const Limits& limits, bool is_in_use) {
  sealed_ = sealed;
  layer_words_ = sizing::sealed_words(limits) / 2;
  words_ = row_words(limits.width);
  width_ = limits.width;
  is_open_ = limits.border == Border::open;
  is_in_use_ = is_in_use;
}

void Sealing::clear() {
  for (uint32_t i = 0; i < 2 * layer_words_; ++i) sealed_[i] = 0;
  committed_ = 0;
  is_odd_layer_ = false;
  is_word_begun_ = false;
  patch_ = 0;
  event_ = 0;
  word_ = 0;
}

void Sealing::begin_row(const RowBlock& rows, int32_t y, uint32_t spare) {
  if (!is_in_use_) return;
  const uint32_t needed = need(above(rows));
  const uint32_t bit = uint32_t{1} << bit_of(y);
  uint32_t& word = word_of(y, false);
  word &= ~bit;
  if (needed + committed_ > spare)
    word |= bit;
  else
    committed_ += needed;
}

void Sealing::end_front(const RowBlock& rows, int32_t y) {
  end({{rows.row[0][0], rows.row[0][1], rows.row[1][0], rows.row[1][1]}}, y - 1);
}

void Sealing::end_back(const RowBlock& rows, int32_t y) {
  end({{rows.row[0][1], rows.row[0][2], rows.row[1][1], rows.row[1][2]}}, y);
}

// Cells that are neither all on nor all off: bit i stands for the cell of bits i and i + 1.
uint32_t Sealing::active(const CellRow& cells, uint32_t word) const {
  uint32_t any = 0, all = ~uint32_t{0};
  for (const uint32_t* const row : cells.row) {
    any |= row[word] | row[word] >> 1;
    all &= row[word] & row[word] >> 1;
  }
  return any & ~all & own_columns & (is_open_ ? inner_columns(word, width_) : ~uint32_t{0});
}

uint32_t Sealing::need(const CellRow& cells) const {
  uint32_t count = 0;
  for (uint32_t word = 0; word < words_; ++word)
    for (uint32_t left = active(cells, word); left != 0; left &= left - 1) ++count;
  return count * sizing::records_a_cell;
}

bool Sealing::deliver(const RowBlock& rows, int32_t y, int32_t z, const Sink& sink,
                      Statistics& statistics) {
  if (!is_sealed(y, false)) return true;
  const CellRow cells = above(rows);
  for (; word_ < words_; ++word_) {
    if (!is_word_begun_) cells_ = active(cells, word_);
    is_word_begun_ = true;
    for (; cells_ != 0; cells_ &= cells_ - 1) {
      const uint32_t bit = trailing_zeros(cells_);
      uint32_t configuration = 0;
      for (int i = 0; i < 4; ++i) configuration |= (cells.row[i][word_] >> bit & 3) << 2 * i;
      const uint32_t x = word_ * columns_per_word + bit - 2;  // -1 wraps
      const Vertex origin{2 * static_cast<int32_t>(x), 2 * y, 2 * z};
      for (;; ++patch_) {
        const CellPatch patch = cell_patch(static_cast<Configuration>(configuration), patch_);
        if (patch.count == 0) break;
        if (!tell(patch, origin + position(patch.start), sink, statistics)) return false;
      }
      patch_ = 0;
      const CellCounts counts = cell_counts(static_cast<Configuration>(configuration));
      ++statistics.cells;
      statistics.facets += counts.facets;
      statistics.classic_triangles += counts.classic_triangles;
    }
    is_word_begun_ = false;
  }
  word_ = 0;
  return true;
}

// Delivers a patch as a region: its event number `event_` comes next.
bool Sealing::tell(const CellPatch& patch, const Vertex& start, const Sink& sink,
                   Statistics& statistics) {
  const uint8_t end = static_cast<uint8_t>(patch.count + 2);
  for (; event_ <= end; ++event_) {
    Event event{};
    event.kind = event_ == 0     ? Event::Kind::region
                 : event_ == 1   ? Event::Kind::ring
                 : event_ < end ? Event::Kind::run
                                 : Event::Kind::region_end;
    event.incidence = patch.incidence;
    event.start = start;
    if (event.kind == Event::Kind::run) event.run = patch.run[event_ - 2];
    if (sink.take(sink.context, event) != Answer::taken) return false;
    statistics.links += event.run.length();
  }
  event_ = 0;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

}  // namespace discmc::trace

#include <discmc/compiler.hpp>
#include <discmc/trace/cell_patches.hpp>
#include <discmc/trace/sealing.hpp>

namespace discmc::trace {

namespace {

// ---- rows of cells ----

// The four rows of voxels around a row of cells.
struct RowsAround {
  const uint32_t* row[4];
};

// Those around the cells of layer z - 1 or z, and of row y - 1 or y, as 0 or 1.
RowsAround rows_around(const RowBlock& rows, int layer, int row) {
  return {{rows.row[layer][row], rows.row[layer][row + 1], rows.row[layer + 1][row],
           rows.row[layer + 1][row + 1]}};
}

// Cells that are neither all on nor all off: bit i stands for the cell of bits i and i + 1.
uint32_t active(const RowsAround& around, const Limits& limits, uint32_t word) {
  uint32_t any = 0, all = ~uint32_t{0};
  for (const uint32_t* const row : around.row) {
    any |= row[word] | row[word] >> 1;
    all &= row[word] & row[word] >> 1;
  }
  const bool is_open = limits.border == Border::open;
  return any & ~all & (is_open ? inner_columns(word, limits.width) : own_columns);
}

// The records that a row of cells may come to need.
uint32_t need(const RowsAround& around, const Limits& limits) {
  uint32_t count = 0;
  for (uint32_t word = 0; word < row_words(limits.width); ++word)
    for (uint32_t left = active(around, limits, word); left != 0; left &= left - 1) ++count;
  return count * sizing::records_a_cell;
}

// ---- which are sealed ----

// The bit of the row of cells behind voxel row y, in the layer above slice z.
struct SealedBit {
  uint32_t& word;
  uint32_t bit;

  SealedBit(const SealedRows& sealed, const Limits& limits, int32_t y, int32_t z)
      : word(sealed.bits[(z & 1) * static_cast<int32_t>(sizing::sealed_words(limits) / 2) +
                         (y + 1) / 32]),
        bit(uint32_t{1} << (y + 1) % 32) {}
};

void mark_absent(const SealedRows& sealed, const CellRows& cells) {
  for (int layer = 0; layer < 2; ++layer)
    for (int row = cells.y < 0 ? 1 : 0; row < 2; ++row) {
      const SealedBit place(sealed, cells.limits, cells.y - 1 + row, cells.z - 1 + layer);
      if ((place.word & place.bit) != 0) cells.absent |= 1U << (2 * layer + row);
    }
}

// Decides on the row of cells above row y.
bool decide(SealedRows& sealed, const CellRows& cells, uint32_t spare) {
  const uint32_t needed = need(rows_around(cells.rows, 1, 1), cells.limits);
  const SealedBit place(sealed, cells.limits, cells.y, cells.z);
  place.word &= ~place.bit;
  if (needed + sealed.committed <= spare) {
    sealed.committed += needed;
    return false;
  }
  place.word |= place.bit;
  return true;
}

// ---- their cells ----

// Delivers a patch as a region: its event number `event` comes next.
bool tell(SealedRows& sealed, const CellPatch& patch, const Vertex& start, const Sink& sink,
          Statistics& statistics) {
  const uint8_t end = static_cast<uint8_t>(patch.count + 2);
  for (; sealed.event <= end; ++sealed.event) {
    Event event{};
    event.kind = sealed.event == 0    ? Event::Kind::region
                 : sealed.event == 1  ? Event::Kind::ring
                 : sealed.event < end ? Event::Kind::run
                                      : Event::Kind::region_end;
    event.incidence = patch.incidence;
    event.start = start;
    if (event.kind == Event::Kind::run) event.run = patch.run[sealed.event - 2];
    if (sink.take(sink.context, event) != Answer::taken) return false;
    statistics.links += event.run.length();
  }
  sealed.event = 0;
  ++statistics.rings;
  ++statistics.regions;
  return true;
}

bool deliver_cell(SealedRows& sealed, Configuration configuration, const Vertex& origin,
                  const Sink& sink, Statistics& statistics) {
  for (;; ++sealed.patch) {
    const CellPatch patch = cell_patch(configuration, sealed.patch);
    if (patch.count == 0) break;
    if (!tell(sealed, patch, origin + position(patch.start), sink, statistics)) return false;
  }
  sealed.patch = 0;
  const CellCounts counts = cell_counts(configuration);
  ++statistics.cells;
  statistics.facets += counts.facets;
  statistics.classic_triangles += counts.classic_triangles;
  return true;
}

// Delivers the cells of the row above row y, or goes on with them.
bool deliver(SealedRows& sealed, const CellRows& cells, const Sink& sink, Statistics& statistics) {
  const RowsAround around = rows_around(cells.rows, 1, 1);
  for (; sealed.word < row_words(cells.limits.width); ++sealed.word) {
    if (!sealed.is_word_begun) sealed.cells = active(around, cells.limits, sealed.word);
    sealed.is_word_begun = true;
    for (; sealed.cells != 0; sealed.cells &= sealed.cells - 1) {
      const uint32_t bit = trailing_zeros(sealed.cells);
      uint32_t configuration = 0;
      for (int i = 0; i < 4; ++i) configuration |= (around.row[i][sealed.word] >> bit & 3) << 2 * i;
      const uint32_t x = sealed.word * columns_per_word + bit - 2;  // -1 wraps
      const Vertex origin{2 * static_cast<int32_t>(x), 2 * cells.y, 2 * cells.z};
      if (!deliver_cell(sealed, static_cast<Configuration>(configuration), origin, sink,
                        statistics))
        return false;
    }
    sealed.is_word_begun = false;
  }
  sealed.word = 0;
  return true;
}

// ---- the table ----

void clear(SealedRows& sealed, const Limits& limits) {
  uint32_t* const bits = sealed.bits;
  for (uint32_t i = 0; i < sizing::sealed_words(limits); ++i) bits[i] = 0;
  sealed = {};
  sealed.bits = bits;
}

bool begin_row(SealedRows& sealed, const CellRows& cells, uint32_t spare, const Sink& sink,
               Statistics& statistics) {
  using Stage = SealedRows::Stage;
  if (sealed.stage == Stage::none) {
    const bool has_cells = (cells.absent & CellRowBits::back & CellRowBits::above) == 0;
    sealed.stage = has_cells && decide(sealed, cells, spare) ? Stage::cells : Stage::vertices;
  }
  if (sealed.stage == Stage::cells) {
    if (!deliver(sealed, cells, sink, statistics)) return false;
    sealed.stage = Stage::vertices;
  }
  mark_absent(sealed, cells);
  return true;
}

// Around the cells below, before row y, it is the last row; the last of all also behind it.
void end_row(SealedRows& sealed, const CellRows& cells) {
  const bool is_last = cells.y + 1 == static_cast<int32_t>(cells.limits.height);
  for (int row = 0; row < (is_last ? 2 : 1); ++row)
    if ((cells.absent >> row & 1) == 0)
      sealed.committed -= need(rows_around(cells.rows, 0, row), cells.limits);
  sealed.stage = SealedRows::Stage::none;
}

}  // namespace

const Sealing sealing = {clear, begin_row, end_row};

}  // namespace discmc::trace

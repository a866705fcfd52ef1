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
uint32_t active(const RowsAround& around, const SweptRow& row, uint32_t word) {
  uint32_t any = 0, all = ~uint32_t{0};
  for (const uint32_t* const voxels : around.row) {
    any |= voxels[word] | voxels[word] >> 1;
    all &= voxels[word] & voxels[word] >> 1;
  }
  return any & ~all & (row.has_open_ends ? inner_columns(word, row.width) : own_columns);
}

// The records that a row of cells may come to need.
uint32_t need(const RowsAround& around, const SweptRow& row) {
  uint32_t count = 0;
  for (uint32_t word = 0; word < row.words; ++word)
    for (uint32_t left = active(around, row, word); left != 0; left &= left - 1) ++count;
  return count * sizing::records_a_cell;
}

// ---- which are sealed ----

// The bit of the row of cells behind voxel row y, in the layer above slice z.
struct SealedBit {
  uint32_t& word;
  uint32_t bit;

  SealedBit(const SealedRows& sealed, int32_t y, int32_t z)
      : word(sealed.bits[(z & 1) * static_cast<int32_t>(sealed.layer_words) + (y + 1) / 32]),
        bit(uint32_t{1} << (y + 1) % 32) {}
};

void mark_absent(const SealedRows& sealed, SweptRow& row) {
  for (int layer = 0; layer < 2; ++layer)
    for (int back = row.y < 0 ? 1 : 0; back < 2; ++back) {
      const SealedBit place(sealed, row.y - 1 + back, row.z - 1 + layer);
      if ((place.word & place.bit) != 0) row.absent_rows |= 1U << (2 * layer + back);
    }
}

// Decides on the row of cells above row y.
bool decide(SealedRows& sealed, const SweptRow& row, uint32_t spare) {
  const uint32_t needed = need(rows_around(row.rows, 1, 1), row);
  const SealedBit place(sealed, row.y, row.z);
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
bool deliver(SealedRows& sealed, const SweptRow& row, const Sink& sink, Statistics& statistics) {
  const RowsAround around = rows_around(row.rows, 1, 1);
  for (; sealed.word < row.words; ++sealed.word) {
    if (!sealed.is_word_begun) sealed.cells = active(around, row, sealed.word);
    sealed.is_word_begun = true;
    for (; sealed.cells != 0; sealed.cells &= sealed.cells - 1) {
      const uint32_t bit = trailing_zeros(sealed.cells);
      uint32_t configuration = 0;
      for (int i = 0; i < 4; ++i) configuration |= (around.row[i][sealed.word] >> bit & 3) << 2 * i;
      const auto x = static_cast<int32_t>(column_of(sealed.word, bit));
      const Vertex origin{2 * x, 2 * row.y, 2 * row.z};
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
  sealed.layer_words = sizing::sealed_words(limits) / 2;
  sealed.last_row = static_cast<int32_t>(limits.height) - 1;
}

bool begin_row(SealedRows& sealed, SweptRow& row, uint32_t spare, const Sink& sink,
               Statistics& statistics) {
  using Stage = SealedRows::Stage;
  if (sealed.stage == Stage::none) {
    const bool has_cells = (row.absent_rows & CellRowBits::back & CellRowBits::above) == 0;
    sealed.stage = has_cells && decide(sealed, row, spare) ? Stage::cells : Stage::vertices;
  }
  if (sealed.stage == Stage::cells) {
    if (!deliver(sealed, row, sink, statistics)) return false;
    sealed.stage = Stage::vertices;
  }
  mark_absent(sealed, row);
  return true;
}

// Around the cells below, before row y, it is the last row; the last of all also behind it.
void end_row(SealedRows& sealed, const SweptRow& row) {
  for (int back = 0; back < (row.y == sealed.last_row ? 2 : 1); ++back)
    if ((row.absent_rows >> back & 1) == 0)
      sealed.committed -= need(rows_around(row.rows, 0, back), row);
  sealed.stage = SealedRows::Stage::none;
}

}  // namespace

const Sealing sealing = {clear, begin_row, end_row};

}  // namespace discmc::trace

#include "stream_surface.hpp"

#include "samples/spacing.hpp"

namespace discmc::web {

StreamSurface::StreamSurface(const meshing::StreamChoice& choice)
    : reader_(make_sink(*this), choice) {}

void StreamSurface::push(const std::uint8_t* bytes, std::size_t count) {
  reader_.push(bytes, count);
  surface_.surface().spacing_mm = meshing::spacing_mm(reader_.header());
}

SinkResult StreamSurface::accept(const Event& event) {
  if (event.kind == Event::Kind::skipped) note_skipped(event.slice, event.row);
  Placement placement;
  if (event.kind == Event::Kind::application && read_placement(*event.application, placement))
    placement_ = placement;
  fractions_.accept(event);
  return surface_.accept(event);
}

// Joins successive rows of a slice, and successive slices.
void StreamSurface::note_skipped(std::uint32_t slice, std::uint32_t row) {
  constexpr std::size_t max_entries = std::size_t{1} << 16;
  if (!rows_.empty() && rows_.back().slices.last == slice && rows_.back().last_row + 1 == row)
    rows_.back().last_row = row;
  else if (rows_.size() < max_entries)
    rows_.push_back({{slice, slice}, row, row});
  else
    return;
  if (rows_.size() < 2) return;
  const MissingRows& last = rows_.back();
  MissingRows& before = rows_[rows_.size() - 2];
  const bool is_more_of_it = before.slices.last + 1 == slice && before.first_row == 0 &&
                             last.first_row == 0 && before.last_row == last.last_row &&
                             last.last_row + 1 == reader_.header().height;
  if (!is_more_of_it) return;
  before.slices.last = slice;
  rows_.pop_back();
}

Missing StreamSurface::missing(bool is_end) const {
  StreamHeader header = reader_.header();
  const StreamReport state = report();
  if (state.has_trailer) header.depth = state.slices;
  Missing missing(header);
  missing.add_rows(rows_);
  if (is_end && !state.is_complete()) missing.add_open_links(polygons());
  return missing;
}

void StreamSurface::finish() {
  reader_.finish();
  surface_.finish();
}

StreamReport StreamSurface::report() const {
  StreamReport report = reader_.report();
  report.lost_pieces += surface_.builder().incomplete_regions();
  return report;
}

}  // namespace discmc::web

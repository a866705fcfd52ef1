// The missing parts of a surface, as lines and as slices.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <discmc/sink.hpp>

#include "surface/surface.hpp"

namespace discmc::web {

/// Units: half-steps.
struct MissingLine {
  std::array<std::int16_t, 3> from, to;
};
static_assert(sizeof(MissingLine) == 12, "the page reads them so");

/// From the first to the last, both included.
struct SliceRange {
  std::uint32_t first, last;
};

/// Rows of one slice, or of several slices all.
struct MissingRows {
  SliceRange slices;
  std::uint32_t first_row, last_row;
};

class Missing {
 public:
  static constexpr std::size_t max_open_links = std::size_t{1} << 21;

  /// header: of the stream, with its depth if that is known.
  explicit Missing(const StreamHeader& header) : header_(header) {}

  /// Boxes around missing rows.
  void add_rows(const std::vector<MissingRows>& rows);

  /// Links of a polygon without a neighbour. A complete surface has none, except at the ends of an
  /// open one. Returns false, and adds nothing, if there are more than max_open_links, or
  /// coordinates beyond 16 bits.
  bool add_open_links(const meshing::Polygons& polygons);

  const std::vector<MissingLine>& lines() const { return lines_; }
  /// In order, not adjacent to each other.
  std::vector<SliceRange> slices() const;

 private:
  bool is_at_border(const Vertex& from, const Vertex& to) const;
  void add_line(const Vertex& from, const Vertex& to);
  void add_box(const Vertex& low, const Vertex& high);

  StreamHeader header_;
  std::vector<MissingLine> lines_;
  std::vector<SliceRange> slices_;  // in no order
};

}  // namespace discmc::web

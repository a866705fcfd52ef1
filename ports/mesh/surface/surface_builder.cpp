#include "surface_builder.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <discmc/polygon.hpp>

#include "plane_axes.hpp"

namespace discmc::meshing {
namespace {

constexpr std::uint32_t no_end = 0xFFFFFFFFu;

Vertex after_links(const Vertex& from, const Side& side, std::int32_t links) {
  return from + Vertex{links * side.link.x, links * side.link.y, links * side.link.z};
}

// Returns the link of a side behind which a vertex lies; 0 if the vertex is not within the side.
std::int32_t link_at(const Vertex& from, const Side& side, const Vertex& vertex) {
  const Vertex vector = vertex - from;
  const std::int32_t link = side.link.x != 0   ? vector.x / side.link.x
                            : side.link.y != 0 ? vector.y / side.link.y
                                               : vector.z / side.link.z;
  const bool is_between = link > 0 && link < side.links;
  return is_between && after_links(from, side, link) == vertex ? link : 0;
}

template <class Iterator>
void begin_at_last(Iterator begin, Iterator end) {
  std::rotate(begin, std::max_element(begin, end, precedes), end);
}

// Whether a ring turns at one of its vertices.
bool turns(const Vertex* vertices, std::uint32_t count, std::uint32_t i) {
  const Vertex& before = vertices[i > 0 ? i - 1 : count - 1];
  const Vertex& after = vertices[i + 1 < count ? i + 1 : 0];
  return side_between(before, vertices[i]).link != side_between(vertices[i], after).link;
}

}  // namespace

SinkResult SurfaceBuilder::accept(const Event& event) {
  switch (event.kind) {
    case Event::Kind::region:
      incidence_ = event.incidence;
      rings_.clear();
      runs_.clear();
      normals_.clear();
      break;
    case Event::Kind::ring:
      rings_.push_back({event.start, runs_.size()});
      break;
    case Event::Kind::run:
      if (rings_.empty()) break;
      runs_.push_back(event.run);
      normals_.push_back(event.normal);
      break;
    case Event::Kind::region_end:
      end_region();
      break;
    case Event::Kind::fragment:
      rings_.clear();
      break;
    case Event::Kind::fragment_end:
      ++incomplete_regions_;
      break;
    case Event::Kind::start:
    case Event::Kind::lost:
    case Event::Kind::skipped:
    case Event::Kind::application:
    case Event::Kind::layer:
    case Event::Kind::fractions:
      break;
    case Event::Kind::finish:
      surface_.polygons.sort(jobs_);
      break;
  }
  return SinkResult::accepted;
}

void SurfaceBuilder::accept_region(const OneRingRegion& region) {
  incidence_ = region.incidence();
  rings_.clear();
  begin_polygon();
  if (!read_region_corners(region) && !is_simple_in_window(0)) {
    ends_.assign(corners_.begin(), corners_.end());
    add_touching_rings(0);
    return end_polygon();
  }
  // This is an outer ring that begins at its last vertex.
  simple_rings_.push_back({0, corners_.size()});
  keep_or_count();
}

void SurfaceBuilder::append(SurfaceBuilder&& other) {
  counts_ += other.counts_;
  incomplete_regions_ += other.incomplete_regions_;
  surface_.polygons.append(other.surface_.polygons);
  surface_.normals.merge(other.surface_.normals);
}

SurfaceBuilder::Chain SurfaceBuilder::chain(std::size_t ring) const {
  const std::size_t end = ring + 1 < rings_.size() ? rings_[ring + 1].first_run : runs_.size();
  return {rings_[ring].start, runs_.data() + rings_[ring].first_run, runs_.data() + end};
}

// Whether a chain closes, within the coordinates of a scan, which have 32 bits.
bool SurfaceBuilder::is_sound(const Chain& chain) const {
  constexpr std::int64_t min_coordinate = -1, max_coordinate = (std::int64_t{1} << 31) - 3;
  std::int64_t x = chain.start.x, y = chain.start.y, z = chain.start.z;
  const auto is_inside = [&] {
    return std::min({x, y, z}) >= min_coordinate && std::max({x, y, z}) <= max_coordinate;
  };
  bool is_always_inside = is_inside();
  for (const Run* run = chain.begin; run != chain.end; ++run) {
    const Vertex step = direction_vector(incidence_, run->direction());
    const std::int64_t length = run->length();
    x += step.x * length;
    y += step.y * length;
    z += step.z * length;
    is_always_inside = is_always_inside && is_inside();
  }
  return is_always_inside && x == chain.start.x && y == chain.start.y && z == chain.start.z;
}

// Reads the corners of a ring. Returns whether it only turns left. Such rings are simple, because
// no ring of a sweep crosses itself.
bool SurfaceBuilder::read_region_corners(const OneRingRegion& region) {
  const std::uint32_t count = region.corner_count(), full_turn = direction_count(incidence_);
  std::uint32_t max_turn = 0;
  corners_.resize(count);
  Vertex* corner = corners_.begin();
  for (std::uint32_t i = 0; i < count; ++i) {
    corner[i] = region.corner(i);
    max_turn = std::max(max_turn, region.left_turn(i));
  }
  return 2 * max_turn < full_turn;
}

// Reads the corners of a ring. Returns whether it only turns to one side, and winds once, which
// makes it simple. A stream may contain any ring.
bool SurfaceBuilder::read_chain_corners(const Chain& chain) {
  if (chain.begin == chain.end) return false;
  const int full_turn = direction_count(incidence_);
  int left_turns = 0, right_turns = 0;
  Vertex vertex = chain.start;
  Direction before = chain.end[-1].direction();
  for (const Run* run = chain.begin; run != chain.end; ++run) {
    const Direction direction = run->direction();
    if (direction != before) {
      const int turn = direction - before + (direction < before ? full_turn : 0);
      if (2 * turn < full_turn)
        left_turns += turn;
      else
        right_turns +=
            2 * turn == full_turn ? full_turn : full_turn - turn;  // back: no such ring is simple
      corners_.push_back(vertex);
    }
    before = direction;
    translate(vertex, incidence_, direction, run->length());
  }
  return left_turns + right_turns == full_turn && (left_turns == 0 || right_turns == 0);
}

// Whether a ring meets no vertex twice, by a bit for each vertex in a window around it. Returns
// false for rings larger than the window.
bool SurfaceBuilder::is_simple_in_window(std::size_t first_corner) const {
  if (first_corner == corners_.size()) return true;
  constexpr std::int64_t size = 64;
  const auto [u_axis, v_axis, left_out] = plane_axes(incidence_);
  const Vertex* corner = corners_.data() + first_corner;
  const Vertex* const end = corners_.data() + corners_.size();
  std::int64_t min_u = corner->*u_axis, min_v = corner->*v_axis, max_u = min_u, max_v = min_v;
  for (const Vertex* other = corner; other != end; ++other) {
    min_u = std::min<std::int64_t>(min_u, other->*u_axis);
    max_u = std::max<std::int64_t>(max_u, other->*u_axis);
    min_v = std::min<std::int64_t>(min_v, other->*v_axis);
    max_v = std::max<std::int64_t>(max_v, other->*v_axis);
  }
  if (max_u - min_u >= size || max_v - min_v >= size) return false;
  std::uint64_t rows[size];
  std::fill_n(rows, max_v - min_v + 1, 0);
  std::int64_t u = corner->*u_axis - min_u, v = corner->*v_axis - min_v;
  std::uint64_t recurring = 0;
  for (const Vertex* from = corner; from != end; ++from) {
    const Side side = side_between(*from, from + 1 != end ? from[1] : *corner);
    const std::int64_t along_u = side.link.*u_axis, along_v = side.link.*v_axis;
    for (std::int32_t left = side.links; left > 0; --left) {
      u += along_u;
      v += along_v;
      const std::uint64_t bit = std::uint64_t{1} << u;
      recurring |= rows[v] & bit;
      rows[v] |= bit;
    }
  }
  return recurring == 0;
}

// Makes a simple ring of the corners since the last ring. It begins at its last vertex, as rings of
// an extractor do.
void SurfaceBuilder::end_ring() {
  const std::size_t begin = simple_rings_.empty() ? 0 : simple_rings_.back().end;
  begin_at_last(corners_.begin() + begin, corners_.end());
  simple_rings_.push_back({begin, corners_.size()});
}

void SurfaceBuilder::collect_ends(const Chain& chain) {
  ends_.clear();
  if (chain.begin == chain.end) return;
  Vertex vertex = chain.start;
  Direction before = chain.end[-1].direction();
  for (const Run* run = chain.begin; run != chain.end; ++run) {
    if (run == chain.begin || run->direction() != before) ends_.push_back(vertex);
    before = run->direction();
    translate(vertex, incidence_, before, run->length());
  }
}

// Fills the hash table of ends, by open addressing, at most half full. Returns whether an end
// recurs.
bool SurfaceBuilder::index_ends() {
  std::size_t slots = 8;
  while (slots < 2 * ends_.size()) slots *= 2;
  slots_.assign(slots, no_end);
  bool recurs = false;
  for (std::uint32_t i = 0; i < ends_.size(); ++i) {
    std::size_t slot = VertexHash()(ends_[i]) & (slots - 1);
    while (slots_[slot] != no_end && ends_[slots_[slot]] != ends_[i])
      slot = (slot + 1) & (slots - 1);
    recurs = recurs || slots_[slot] != no_end;
    slots_[slot] = i;
  }
  return recurs;
}

bool SurfaceBuilder::is_end(const Vertex& vertex) const {
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t slot = VertexHash()(vertex) & mask; slots_[slot] != no_end;
       slot = (slot + 1) & mask)
    if (ends_[slots_[slot]] == vertex) return true;
  return false;
}

// Whether a vertex of the ring recurs. A ring never crosses itself: one of two passes through a
// vertex turns there, so the vertex is an end.
bool SurfaceBuilder::find_touches() {
  const bool recurs = index_ends();
  vertices_.clear();
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    vertices_.push_back(ends_[i]);
    add_touches_of(ends_[i], side_between(ends_[i], ends_[i + 1 < ends_.size() ? i + 1 : 0]));
  }
  return recurs || vertices_.size() > ends_.size();
}

// Adds the ends that a side passes through, in order: found link by link, or end by end if the side
// has more links.
void SurfaceBuilder::add_touches_of(const Vertex& from, const Side& side) {
  if (static_cast<std::size_t>(side.links) <= ends_.size()) {
    Vertex vertex = from;
    for (std::int32_t link = 1; link < side.links; ++link) {
      vertex = vertex + side.link;
      if (is_end(vertex)) vertices_.push_back(vertex);
    }
    return;
  }
  touches_.clear();
  for (const Vertex& end : ends_)
    if (const std::int32_t link = link_at(from, side, end); link > 0) touches_.push_back(link);
  std::sort(touches_.begin(), touches_.end());
  touches_.erase(std::unique(touches_.begin(), touches_.end()), touches_.end());
  for (const std::int32_t link : touches_) vertices_.push_back(after_links(from, side, link));
}

// Divides a ring where it touches itself. Its corners were added from first_corner.
void SurfaceBuilder::add_touching_rings(std::size_t first_corner) {
  if (!find_touches()) return end_ring();
  corners_.resize(first_corner);
  begin_at_last(vertices_.begin(), vertices_.end());
  scratch_.resize(2 * vertices_.size());
  const auto add = [](void* context, const Vertex* vertices, std::uint32_t count) {
    auto& builder = *static_cast<SurfaceBuilder*>(context);
    for (std::uint32_t i = 0; i < count; ++i)
      if (turns(vertices, count, i)) builder.corners_.push_back(vertices[i]);
    builder.end_ring();
  };
  split_ring(vertices_.data(), static_cast<std::uint32_t>(vertices_.size()), scratch_.data(),
             {this, add});
}

Ring SurfaceBuilder::simple_ring(const Span& span) const {
  return {corners_.data() + span.begin, corners_.data() + span.end};
}

// Moves the outer ring to the front. Returns whether there is one.
bool SurfaceBuilder::put_outer_first() {
  const auto is_outer = [this](const Span& span) {
    const Ring ring = simple_ring(span);
    return twice_area(incidence_, ring.data(), static_cast<std::uint32_t>(ring.size())) > 0;
  };
  const auto outer = std::find_if(simple_rings_.begin(), simple_rings_.end(), is_outer);
  if (outer == simple_rings_.end()) return false;
  std::iter_swap(simple_rings_.begin(), outer);
  return true;
}

// Sorts holes by their corners, so that the order of closing does not matter.
void SurfaceBuilder::sort_holes() {
  if (simple_rings_.size() < 3) return;
  std::sort(simple_rings_.begin() + 1, simple_rings_.end(), [this](const Span& a, const Span& b) {
    const Ring first = simple_ring(a), second = simple_ring(b);
    return std::lexicographical_compare(first.begin(), first.end(), second.begin(), second.end(),
                                        precedes);
  });
}

void SurfaceBuilder::end_region() {
  begin_polygon();
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const Chain ring = chain(i);
    if (!is_sound(ring)) {
      ++incomplete_regions_;
      return;
    }
    const std::size_t first_corner = corners_.size();
    if (read_chain_corners(ring) || is_simple_in_window(first_corner)) {
      end_ring();
    } else {
      collect_ends(ring);
      add_touching_rings(first_corner);
    }
  }
  end_polygon();
}

void SurfaceBuilder::begin_polygon() {
  simple_rings_.clear();
  corners_.resize(0);
}

void SurfaceBuilder::end_polygon() {
  if (!put_outer_first())
    ++incomplete_regions_;
  else
    keep_or_count();
}

void SurfaceBuilder::keep_or_count() {
  if (kept_ == Kept::polygons)
    keep_region();
  else
    count_region();
}

void SurfaceBuilder::count_region() {
  ++counts_.regions;
  counts_.rings += simple_rings_.size();
  counts_.holes += simple_rings_.size() - 1;
  counts_.corners += corners_.size();
  ++(corners_.size() == 3   ? counts_.of_three_corners
     : corners_.size() == 4 ? counts_.of_four_corners
                            : counts_.of_more_corners);
  for (const Span& span : simple_rings_) {
    const Ring ring = simple_ring(span);
    for (std::size_t i = 0; i < ring.size(); ++i)
      counts_.links +=
          static_cast<std::uint64_t>(links_between(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]));
  }
  if (rings_.empty()) return;  // no events, no normals
  for (const OctahedralNormal& each : normals_)
    if (!each.is_none()) ++counts_.normals;
}

void SurfaceBuilder::keep_region() {
  sort_holes();
  surface_.polygons.add_polygon(incidence_);
  for (const Span& span : simple_rings_) surface_.polygons.add_ring(simple_ring(span));
  for (std::size_t i = 0; i < rings_.size(); ++i) keep_normals(i);
}

void SurfaceBuilder::keep_normals(std::size_t ring) {
  const Chain runs = chain(ring);
  const OctahedralNormal* normal = normals_.data() + rings_[ring].first_run;
  Vertex vertex = runs.start;
  for (const Run* run = runs.begin; run != runs.end; ++run, ++normal) {
    if (!normal->is_none()) surface_.normals.emplace(vertex, *normal);
    translate(vertex, incidence_, run->direction(), run->length());
  }
}

}  // namespace discmc::meshing

#include "surface_builder.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <discmc/polygon.hpp>

namespace discmc::command {

SinkResult SurfaceBuilder::take(const Event& event) {
  switch (event.kind) {
    case Event::Kind::region:
      incidence_ = event.incidence;
      rings_.clear();
      runs_.clear();
      break;
    case Event::Kind::ring:
      rings_.push_back({event.start, runs_.size()});
      break;
    case Event::Kind::run:
      if (!rings_.empty()) runs_.push_back({event.run, event.normal});
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
    case Event::Kind::finish:
      break;
  }
  return SinkResult::accepted;
}

void SurfaceBuilder::append(SurfaceBuilder&& other) {
  add_links(other.links_);
  incomplete_regions_ += other.incomplete_regions_;
  surface_.polygons.append(other.surface_.polygons);
  surface_.normals.merge(other.surface_.normals);
}

SurfaceBuilder::Chain SurfaceBuilder::chain(std::size_t ring) const {
  const std::size_t end = ring + 1 < rings_.size() ? rings_[ring + 1].first_run : runs_.size();
  return {rings_[ring].start, runs_.data() + rings_[ring].first_run, runs_.data() + end};
}

// Whether a chain closes, and within the coordinates that a scan can have: rings are unfolded in
// 32 bits.
bool SurfaceBuilder::is_sound(const Chain& chain) {
  constexpr std::int64_t least = -1, most = (std::int64_t{1} << 31) - 3;
  std::int64_t x = chain.start.x, y = chain.start.y, z = chain.start.z;
  const auto is_inside = [&] {
    return std::min({x, y, z}) >= least && std::max({x, y, z}) <= most;
  };
  std::uint64_t links = 0;
  bool is_always_inside = is_inside();
  for (const PlacedRun* at = chain.begin; at != chain.end; ++at) {
    const Vertex step = direction_vector(incidence_, at->run.direction());
    const std::int64_t length = at->run.length();
    x += step.x * length;
    y += step.y * length;
    z += step.z * length;
    links += at->run.length();
    is_always_inside = is_always_inside && is_inside();
  }
  const bool is_closed = x == chain.start.x && y == chain.start.y && z == chain.start.z;
  if (!is_always_inside || !is_closed) return false;
  add_links(links);
  return true;
}

void SurfaceBuilder::add_links(std::uint64_t links) {
  links_ += links;
  if (links_ > max_links)
    throw std::runtime_error(
        "more than " + std::to_string(max_links) +
        " links, more than is kept in memory: take less at once, of a volume by --crop or "
        "--shrink");
}

// Whether a closed chain turns to one side only, and once round. Most do, and are simple.
bool SurfaceBuilder::is_convex(const Chain& chain) const {
  if (chain.begin == chain.end) return false;
  const int round = direction_count(incidence_);
  int left = 0, right = 0;
  Direction before = chain.end[-1].run.direction();
  for (const PlacedRun* at = chain.begin; at != chain.end; ++at) {
    const Direction direction = at->run.direction();
    const int turn = direction - before + (direction < before ? round : 0);
    if (2 * turn == round) return false;
    if (2 * turn < round)
      left += turn;
    else
      right += round - turn;
    before = direction;
  }
  return left + right == round && (left == 0 || right == 0);
}

void SurfaceBuilder::add_corners(const Chain& chain) {
  if (chain.begin == chain.end) return;
  Vertex vertex = chain.start;
  Direction before = chain.end[-1].run.direction();
  for (const PlacedRun* at = chain.begin; at != chain.end; ++at) {
    if (at->run.direction() != before) corners_.push_back(vertex);
    before = at->run.direction();
    move(vertex, incidence_, before, at->run.length());
  }
}

// The corners since the last one are a simple ring.
void SurfaceBuilder::end_ring() {
  const std::size_t begin = simple_rings_.empty() ? 0 : simple_rings_.back().end;
  simple_rings_.push_back({begin, corners_.size()});
}

// Whether the vertices of the ring under way have one twice. By a hash table with open addressing,
// half full at most.
bool SurfaceBuilder::has_recurrence() {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  std::size_t slots = 8;
  while (slots < 2 * vertices_.size()) slots *= 2;
  scratch_.assign(slots, none);
  for (std::uint32_t i = 0; i < vertices_.size(); ++i) {
    std::size_t slot = VertexHash()(vertices_[i]) & (slots - 1);
    for (; scratch_[slot] != none; slot = (slot + 1) & (slots - 1))
      if (vertices_[scratch_[slot]] == vertices_[i]) return true;
    scratch_[slot] = i;
  }
  return false;
}

void SurfaceBuilder::add_simple_rings(const Chain& chain) {
  const auto add_whole = [&] {
    add_corners(chain);
    end_ring();
  };
  if (is_convex(chain)) return add_whole();
  ring_runs_.clear();
  for (const PlacedRun* at = chain.begin; at != chain.end; ++at) ring_runs_.push_back(at->run);
  const auto run_count = static_cast<std::uint32_t>(ring_runs_.size());
  vertices_.resize(link_count(ring_runs_.data(), run_count));
  ring_vertices(incidence_, chain.start, ring_runs_.data(), run_count, vertices_.data());
  if (!has_recurrence()) return add_whole();
  scratch_.resize(2 * vertices_.size());
  const auto add = [](void* context, const Vertex* vertices, std::uint32_t count) {
    auto& builder = *static_cast<SurfaceBuilder*>(context);
    for (std::uint32_t i = 0; i < count; ++i)
      if (is_corner(vertices, count, i)) builder.corners_.push_back(vertices[i]);
    builder.end_ring();
  };
  split_ring(vertices_.data(), static_cast<std::uint32_t>(vertices_.size()), scratch_.data(),
             {this, add});
}

void SurfaceBuilder::add_normals(const Chain& chain) {
  Vertex vertex = chain.start;
  for (const PlacedRun* at = chain.begin; at != chain.end; ++at) {
    if (!at->normal.is_none()) surface_.normals.emplace(vertex, at->normal);
    move(vertex, incidence_, at->run.direction(), at->run.length());
  }
}

Ring SurfaceBuilder::simple_ring(const Span& span) const {
  return {corners_.data() + span.begin, corners_.data() + span.end};
}

// Whether there is one.
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

void SurfaceBuilder::end_region() {
  simple_rings_.clear();
  corners_.clear();
  bool is_whole = true;
  for (std::size_t i = 0; i < rings_.size(); ++i) {
    const Chain ring = chain(i);
    is_whole = is_whole && is_sound(ring);
    if (!is_whole) continue;
    add_simple_rings(ring);
    add_normals(ring);
  }
  if (!is_whole || !put_outer_first()) {
    ++incomplete_regions_;
    return;
  }
  surface_.polygons.add_polygon(incidence_);
  for (const Span& span : simple_rings_) surface_.polygons.add_ring(simple_ring(span));
}

}  // namespace discmc::command

#include "region_check.hpp"

#include <stdexcept>

#include "oracle/surface.hpp"

namespace discmc::prove {

namespace {

void require(bool holds, const char* broken) {
  if (!holds) throw std::runtime_error(broken);
}

bool lies_on_end(int32_t a, int32_t b) {
  return a == b && (a == Lattice::first + 1 || a == Lattice::last - 1);
}

}  // namespace

Lattice::Lattice(Border border) {
  for (size_t i = 0; i < vertices; ++i)
    for (Link link = 0; link < link_codes; ++link) {
      const Vertex from = vertex(i);
      const Vertex to = from + link_vector(link);
      const bool is_inner =
          border == Border::closed ||
          (!lies_on_end(from.x, to.x) && !lies_on_end(from.y, to.y) && !lies_on_end(from.z, to.z));
      const auto end = static_cast<int16_t>(contains(to) ? static_cast<int>(index(to)) : -1);
      steps_.push_back({reference::link_hash(from, to), end, is_inner});
    }
}

bool Lattice::contains(const Vertex& vertex) {
  const auto fits = [](int32_t coordinate) { return coordinate >= first && coordinate <= last; };
  return fits(vertex.x) && fits(vertex.y) && fits(vertex.z);
}

size_t Lattice::index(const Vertex& vertex) {
  const auto at = [](int32_t coordinate) { return static_cast<size_t>(coordinate - first); };
  return (at(vertex.z) * side + at(vertex.y)) * side + at(vertex.x);
}

Vertex Lattice::vertex(size_t index) {
  const auto i = static_cast<int32_t>(index);
  return {first + i % side, first + i / side % side, first + i / side / side};
}

SinkResult RegionCheck::accept(const Event& event) {
  switch (event.kind) {
    case Event::Kind::region:
      incidence_ = event.incidence;
      boundary_ = 0;
      rings_ = 0;
      break;
    case Event::Kind::ring:
      if (rings_ > 0) end_ring();
      begin_ring(event);
      break;
    case Event::Kind::run:
      add_run(event.run);
      break;
    case Event::Kind::region_end:
      end_ring();
      sum_.fingerprint += reference::mix(reference::of_incidence(boundary_, incidence_));
      break;
    case Event::Kind::start:
    case Event::Kind::layer:
    case Event::Kind::finish:
      break;
    default:
      require(false, "a fragment, for which there is no need");
  }
  return SinkResult::accepted;
}

void RegionCheck::begin_ring(const Event& event) {
  require(event.is_hole == (rings_ > 0), "the outer ring is not the first, or not alone");
  require(Lattice::contains(event.start), "a ring starts outside the block");
  ++rings_;
  hole_ = event.is_hole;
  start_ = at_ = Lattice::index(event.start);
  area_ = 0;
}

void RegionCheck::add_run(Run run) {
  require(run.direction() < direction_count(incidence_), "a run of no links");
  const Link link = link_of(incidence_, run.direction());
  const Vertex moment = cross(Lattice::vertex(at_), link_vector(link));
  area_ += static_cast<int32_t>(run.length()) * dot_product(incidence_normal(incidence_), moment);
  for (uint32_t i = 0; i < run.length(); ++i) {
    const Lattice::Step& step = lattice_.step(at_, link);
    require(step.to >= 0, "a ring leaves the block");
    require((sum_.is_used[at_] >> link & 1) == 0, "a link is used twice in one direction");
    sum_.is_used[at_] |= uint32_t{1} << link;
    at_ = static_cast<size_t>(step.to);
    const bool has_opposite = (sum_.is_used[at_] >> opposite_link(link) & 1) != 0;
    if (step.is_inner) sum_.unpaired += has_opposite ? -1 : 1;
    boundary_ += step.hash;
  }
  sum_.links += run.length();
}

void RegionCheck::end_ring() const {
  require(at_ == start_, "a ring that is not closed");
  require(hole_ == (area_ <= 0), "the hole flag contradicts the sign of the area");
}

}  // namespace discmc::prove

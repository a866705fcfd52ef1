#include "collector.hpp"

#include <algorithm>
#include <unordered_map>

namespace discmc::reference {

namespace {

void require(bool holds, const char* broken) {
  if (!holds) throw GrammarError(broken);
}

bool is_incidence(Incidence incidence) {
  return incidence < incidence_codes && incidence != no_incidence;
}

int32_t top(const Region& region) {
  int32_t z = INT32_MIN;
  for (const Ring& ring : region.rings)
    for (const Vertex& vertex : ring) z = std::max(z, vertex.z);
  return z;
}

// The key is exact, because coordinates in x and y fit 16 bits once they start at 0.
uint64_t key_of(const Vertex& vertex) {
  const auto bits = [](int32_t coordinate) {
    return static_cast<uint64_t>(coordinate + int64_t{1});
  };
  return bits(vertex.z) << 32 | bits(vertex.y) << 16 | bits(vertex.x);
}

bool recurs(const Ring& ring) {
  Ring sorted = ring;
  std::sort(sorted.begin(), sorted.end(), before);
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

void add_simple(const Ring& ring, std::vector<Ring>& rings) {
  if (ring.size() > 2) rings.push_back(ring);
}

// Walks the ring. If a vertex recurs, the loop since its first visit becomes a separate ring.
void split(const Ring& ring, std::vector<Ring>& rings) {
  if (!recurs(ring)) return add_simple(ring, rings);
  Ring path;
  std::unordered_map<uint64_t, size_t> place_on_path;
  for (const Vertex& vertex : ring) {
    const auto [entry, is_new] = place_on_path.try_emplace(key_of(vertex), path.size());
    if (is_new) {
      path.push_back(vertex);
      continue;
    }
    const auto loop = path.begin() + static_cast<std::ptrdiff_t>(entry->second);
    for (auto gone = loop + 1; gone != path.end(); ++gone) place_on_path.erase(key_of(*gone));
    add_simple(Ring(loop, path.end()), rings);
    path.erase(loop + 1, path.end());
  }
  add_simple(path, rings);
}

}  // namespace

SinkResult Collector::accept(const Event& event) {
  require(state_ != State::over, "an event after finish");
  switch (event.kind) {
    case Event::Kind::start:
      break;
    case Event::Kind::region:
      begin_region(event);
      break;
    case Event::Kind::ring:
      begin_ring(event);
      break;
    case Event::Kind::run:
      add_run(event.run);
      break;
    case Event::Kind::region_end:
      end_region();
      break;
    case Event::Kind::fragment:
      begin_fragment(event);
      break;
    case Event::Kind::fragment_end:
      end_fragment();
      break;
    case Event::Kind::skipped:
      add_skipped(event);
      break;
    case Event::Kind::layer:
      add_layer(event);
      break;
    case Event::Kind::finish:
      finish(event);
      break;
    case Event::Kind::application:
    case Event::Kind::lost:
    case Event::Kind::fractions:
      require(false, "an extractor loses nothing, and knows of no other data");
  }
  return SinkResult::accepted;
}

void Collector::begin_region(const Event& event) {
  require(state_ == State::between, "a region begins inside something else");
  require(is_incidence(event.incidence), "a region without incidence");
  region_ = {event.incidence, {}};
  state_ = State::region;
}

void Collector::begin_ring(const Event& event) {
  require(state_ == State::region || state_ == State::ring, "a ring outside a region");
  if (state_ == State::ring) end_ring();
  require(event.is_hole == !region_.rings.empty(), "the outer ring is not the first, or not alone");
  require(((event.start.x ^ event.start.y ^ event.start.z) & 1) != 0,
          "a ring starts off the lattice");
  const int32_t plane = dot_product(incidence_normal(region_.incidence), event.start);
  require(region_.rings.empty() || plane == plane_, "a ring on another plane than its region");
  plane_ = plane;
  start_ = event.start;
  hole_ = event.is_hole;
  runs_.clear();
  last_run_ = Run();
  state_ = State::ring;
}

void Collector::add_run(const Run& run) {
  require(state_ == State::ring || state_ == State::fragment, "a run outside a ring or fragment");
  require(!run.is_empty(), "an empty run");
  require(run.length() > 0, "a run of no links");
  require(run.direction() < direction_count(region_.incidence),
          "a direction that the plane does not have");
  Run merged = last_run_;
  if (!last_run_.is_empty() && merged.absorb(run)) ++split_sides_;
  runs_.push_back(run);
  links_ += run.length();
  last_run_ = run;
}

void Collector::end_ring() {
  require(!runs_.empty(), "a ring without runs");
  const auto count = static_cast<uint32_t>(runs_.size());
  require(is_closed(region_.incidence, runs_.data(), count), "a ring that is not closed");
  const int64_t area = twice_area(region_.incidence, runs_.data(), count);
  require(hole_ == (area <= 0), "the hole flag contradicts the sign of the area");
  region_.rings.push_back(vertices_of(region_.incidence, start_, runs_));
}

void Collector::end_region() {
  require(state_ == State::ring, "a region ends without a ring");
  end_ring();
  const int64_t z = top(region_);
  const int64_t last = int64_t{slice()} - 1;  // of the layer mark
  require(z >= 2 * last, "a region that the last layer mark promised to be over");
  require(z <= 2 * (last + 1), "a region beyond the slices seen");
  rings_ += region_.rings.size();
  regions_.push_back(std::move(region_));
  state_ = State::between;
}

void Collector::begin_fragment(const Event& event) {
  require(state_ == State::between, "a fragment begins inside something else");
  require(is_incidence(event.incidence), "a fragment without incidence");
  require(((event.start.x ^ event.start.y ^ event.start.z) & 1) != 0,
          "a fragment starts off the lattice");
  require(event.incoming_direction < direction_count(event.incidence),
          "a fragment that came by a direction that the plane does not have");
  region_ = {event.incidence, {}};
  start_ = event.start;
  came_ = event.incoming_direction;
  runs_.clear();
  last_run_ = Run();
  state_ = State::fragment;
}

void Collector::end_fragment() {
  require(state_ == State::fragment, "a fragment ends that never began");
  require(!runs_.empty(), "a fragment without runs");
  loose_.push_back({region_.incidence, start_, came_, runs_});
  state_ = State::between;
}

void Collector::add_skipped(const Event& event) {
  require(state_ == State::between, "a skipped row inside something else");
  require(event.slice == slice(), "a skipped row of another slice");
  require(
      skipped_.empty() || skipped_.back().slice < event.slice || skipped_.back().row < event.row,
      "skipped rows out of order");
  skipped_.push_back({event.slice, event.row, event.is_repeated});
}

void Collector::add_layer(const Event& event) {
  require(state_ == State::between, "a layer mark inside something else");
  require(event.slice == slice(), "a layer mark out of order");
  layers_.push_back({event.slice, regions_.size()});
}

void Collector::finish(const Event& event) {
  require(state_ == State::between, "finish inside something else");
  require(event.slice == own_slices(), "finish counts other slices than were marked");
  require(event.statistics != nullptr, "finish without statistics");
  statistics_ = *event.statistics;
  was_abandoned_ = event.is_abandoned;
  require(statistics_.regions == regions_.size(), "statistics count other regions");
  require(statistics_.rings == rings_, "statistics count other rings");
  require(statistics_.links == links_, "statistics count other links");
  require(statistics_.fragments == loose_.size(), "statistics count other fragments");
  require(statistics_.skipped_rows == skipped_.size(), "statistics count other skipped rows");
  state_ = State::over;
}

Ring vertices_of(Incidence incidence, Vertex vertex, const std::vector<Run>& runs) {
  Ring ring;
  for (const Run& run : runs) {
    const Vertex step = direction_vector(incidence, run.direction());
    for (uint32_t i = 0; i < run.length(); ++i) {
      ring.push_back(vertex);
      vertex = vertex + step;
    }
  }
  return ring;
}

std::vector<Region> simple_rings(const std::vector<Region>& regions) {
  std::vector<Region> result;
  result.reserve(regions.size());
  for (const Region& region : regions) {
    Region& simple = result.emplace_back(Region{region.incidence, {}});
    for (const Ring& ring : region.rings) split(ring, simple.rings);
    std::stable_partition(simple.rings.begin(), simple.rings.end(), [&](const Ring& ring) {
      return signed_area(region.incidence, ring) > 0;
    });
  }
  return result;
}

}  // namespace discmc::reference

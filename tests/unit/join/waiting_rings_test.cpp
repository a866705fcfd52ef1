// The waiting rings inside another ring, compared with a search of all rings.
#include <discmc/join/waiting_rings.hpp>

#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::detail::join;
using test::Chance;

namespace {

// Chains in memory of their own. Slot 0 exists, so an incorrect access finds an empty chain.
class Waiting {
 public:
  Waiting() : chains_(401), runs_(4001) {
    held_.start(&chains_[1], 400, &runs_[1], 4000);
    held_.clear();
    rings_.clear();
  }

  uint32_t insert(Incidence incidence, const Vertex& start, const std::vector<Run>& runs) {
    const uint32_t ring = held_.add(incidence, start, runs.back().direction());
    for (const Run run : runs) held_.append(ring, run, {});
    held_.close(ring);
    rings_.insert(held_, ring);
    return ring;
  }
  /// The same ring in two chains. The second has this many runs.
  void insert_joined(Incidence incidence, Vertex at, const std::vector<Run>& runs, size_t count) {
    const uint32_t ring = held_.add(incidence, at, runs.back().direction());
    const size_t cut = runs.size() - count;
    for (size_t i = 0; i < cut; ++i) {
      held_.append(ring, runs[i], {});
      at = after_run(incidence, at, runs[i]);
    }
    const uint32_t rest = held_.add(incidence, at, runs[cut - 1].direction());
    for (size_t i = cut; i < runs.size(); ++i) held_.append(rest, runs[i], {});
    held_.join(ring, rest);
    held_.close(ring);
    rings_.insert(held_, ring);
  }
  void note(Incidence incidence, Vertex at, const std::vector<Run>& runs) {
    for (const Run run : runs) {
      rings_.note(held_, incidence, at, run);
      at = after_run(incidence, at, run);
    }
  }
  std::multiset<uint32_t> rings_beside_notes(bool is_left) {
    std::multiset<uint32_t> found;
    rings_.take_beside_notes(held_, is_left, [&](uint32_t ring) { found.insert(ring); });
    return found;
  }
  /// Removes this many outer rings.
  std::vector<uint32_t> remove_outers(size_t count) {
    std::vector<uint32_t> outer_rings;
    while (outer_rings.size() < count) outer_rings.push_back(rings_.remove_outer(held_));
    return outer_rings;
  }
  void forget_notes() { rings_.forget_notes(held_); }
  void clear() { rings_.clear(); }
  bool has_any(Incidence incidence, const Vertex& at) {
    return rings_.has_any(held_, incidence, at);
  }

 private:
  std::vector<HeldChain> chains_;
  std::vector<HeldRun> runs_;
  HeldChains held_;
  WaitingRings rings_;
};

// A convex ring with some of the directions, starting at any of its corners; also with sharp
// corners at top and bottom.
std::vector<Run> any_convex(Incidence incidence, Chance& chance) {
  const auto half = static_cast<uint32_t>(direction_count(incidence) / 2);
  std::vector<uint32_t> lengths(half);
  size_t sides = 0;
  while (sides < 2) {
    for (uint32_t& length : lengths) length = chance.below(2) * (1 + chance.below(9));
    sides = half - static_cast<size_t>(std::count(lengths.begin(), lengths.end(), 0U));
  }
  std::vector<Run> runs;
  for (uint32_t direction = 0; direction < 2 * half; ++direction)
    if (const uint32_t length = lengths[direction % half])
      runs.push_back(Run::straight(static_cast<Direction>(direction), length));
  std::rotate(runs.begin(), runs.begin() + chance.below(static_cast<uint32_t>(runs.size())),
              runs.end());
  return runs;
}

std::vector<Run> backwards(Incidence incidence, std::vector<Run> runs) {
  reverse(incidence, runs.data(), static_cast<uint32_t>(runs.size()));
  return runs;
}

Vertex any_vertex(Incidence incidence, uint32_t extent, Chance& chance) {
  Vertex at{0, 0, static_cast<int32_t>(chance.below(2))};
  const auto count = static_cast<uint32_t>(direction_count(incidence));
  for (int i = 0; i < 3; ++i)
    translate(at, incidence, static_cast<Direction>(chance.below(count)), chance.below(extent));
  return at;
}

int64_t highest(Incidence incidence, Vertex at, const std::vector<Run>& runs) {
  int64_t height = projected(incidence, at).v;
  for (const Run run : runs) {
    at = after_run(incidence, at, run);
    height = std::max(height, projected(incidence, at).v);
  }
  return height;
}

enum class Place { outside, inside, on_a_side };

// The sides before a point on its line. Their number is odd if the point lies inside.
Place place_of(const ProjectedPoint& point, Incidence incidence, Vertex at,
               const std::vector<Run>& runs) {
  Place place = Place::outside;
  for (const Run run : runs) {
    const RingSide side(incidence, at, run);
    at = after_run(incidence, at, run);
    if (point.v < side.first_line() || point.v >= side.end_line()) continue;
    if (side.crossing(point.v) == point.u) return Place::on_a_side;
    if (side.crossing(point.v) < point.u)
      place = place == Place::inside ? Place::outside : Place::inside;
  }
  return place;
}

constexpr Incidence up = incidence_of({0, 0, 1});
const std::vector<Run> outer = {Run::straight(0, 1), Run::straight(2, 1), Run::straight(4, 1),
                                Run::straight(6, 1)};

}  // namespace

TEST_CASE("the waiting rings inside an outer ring are found, and the outer rings around a hole") {
  Chance chance(1);
  uint32_t insides = 0;
  for (int round = 0; round < 3000; ++round) {
    Incidence incidence = 0;
    do incidence = static_cast<Incidence>(chance.below(incidence_codes));
    while (!is_incidence(incidence));
    const Vertex start = any_vertex(incidence, 6, chance);
    const bool is_outer = chance.below(2) == 0;
    std::vector<Run> runs = any_convex(incidence, chance);
    Vertex forgotten_start = any_vertex(incidence, 6, chance);
    const std::vector<Run> forgotten = any_convex(incidence, chance);
    Waiting waiting;
    std::multiset<uint32_t> expected;
    std::set<std::pair<int64_t, int64_t>> points[2];
    for (int i = 0; i < 20; ++i) {
      const Vertex at = any_vertex(incidence, 10, chance);
      const std::vector<Run> ring = any_convex(incidence, chance);
      const ProjectedPoint point = point_beside(incidence, at, ring[0].direction());
      const bool is_on_plane = plane_offset(incidence, at) == plane_offset(incidence, start);
      const Place place = place_of(point, incidence, start, runs);
      if (place == Place::on_a_side || !points[is_on_plane].emplace(point.u, point.v).second)
        continue;
      const uint32_t number = waiting.insert(incidence, at, ring);
      if (is_on_plane && place == Place::inside) expected.insert(number);
    }
    waiting.note(incidence, forgotten_start, forgotten);
    waiting.forget_notes();
    waiting.note(incidence, start, is_outer ? runs : backwards(incidence, runs));
    CAPTURE(round);
    REQUIRE(waiting.rings_beside_notes(is_outer) == expected);
    REQUIRE(waiting.rings_beside_notes(is_outer).empty());
    insides += static_cast<uint32_t>(expected.size());
  }
  CHECK(insides > 1000);
}

TEST_CASE(
    "outer rings are removed in ascending order, and equally high rings in order of arrival") {
  Waiting waiting;
  std::vector<uint32_t> low, high;
  for (int32_t i = 0; i < 40; ++i) {
    high.push_back(waiting.insert(up, {4 * i, 8, 1}, outer));
    low.push_back(waiting.insert(up, {4 * i, 4, 1}, outer));
    waiting.insert(up, {4 * i, 0, 1}, backwards(up, outer));
  }
  CHECK(waiting.remove_outers(10) == std::vector<uint32_t>(low.begin(), low.begin() + 10));
  // Rings that come later find the others sorted.
  const uint32_t lowest = waiting.insert(up, {0, -8, 1}, outer);
  const uint32_t highest = waiting.insert(up, {0, 12, 1}, outer);
  CHECK(waiting.remove_outers(1) == std::vector<uint32_t>{lowest});
  CHECK(waiting.remove_outers(30) == std::vector<uint32_t>(low.begin() + 10, low.end()));
  CHECK(waiting.remove_outers(40) == high);
  CHECK(waiting.remove_outers(2) == std::vector<uint32_t>{highest, no_chain});
  CHECK(waiting.has_any(up, {0, 0, 1}));
}

TEST_CASE("outer rings are removed in ascending order for any start and any order of joining") {
  Chance chance(2);
  for (int round = 0; round < 1000; ++round) {
    Waiting waiting;
    std::vector<int64_t> expected, heights;
    Incidence incidence = 0;
    do incidence = static_cast<Incidence>(chance.below(incidence_codes));
    while (!is_incidence(incidence));
    for (int i = 0; i < 8; ++i) {
      Vertex at = any_vertex(incidence, 10, chance);
      const std::vector<Run> ring = any_convex(incidence, chance);
      const auto cuts = static_cast<uint32_t>(ring.size() - 1);
      waiting.insert_joined(incidence, at, ring, 1 + chance.below(cuts));
      expected.push_back(highest(incidence, at, ring));
    }
    for (const uint32_t ring : waiting.remove_outers(8)) heights.push_back(expected[ring - 1]);
    std::sort(expected.begin(), expected.end());
    CAPTURE(round);
    REQUIRE(heights == expected);
  }
}

TEST_CASE("clear() removes all waiting rings") {
  Waiting waiting;
  for (int32_t x = 0; x < 3; ++x) waiting.insert(up, {4 * x, 0, 1}, outer);
  waiting.remove_outers(1);
  waiting.insert(up, {20, 0, 1}, outer);
  waiting.clear();
  CHECK_FALSE(waiting.has_any(up, {0, 0, 1}));
  CHECK(waiting.remove_outers(1) == std::vector<uint32_t>{no_chain});
}

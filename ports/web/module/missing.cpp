#include "missing.hpp"

#include <algorithm>
#include <cstddef>
#include <unordered_map>

namespace discmc::web {
namespace {

// A link without direction: its ends in order, packed in a number.
class UndirectedLink {
 public:
  UndirectedLink(Vertex from, Vertex vector) {
    is_turned_ =
        vector.z < 0 || (vector.z == 0 && (vector.y < 0 || (vector.y == 0 && vector.x < 0)));
    if (is_turned_) {
      from = from + vector;
      vector = Vertex{} - vector;
    }
    // Coordinates are -1 or more, and those of a vector -2 to 2.
    for (const std::int32_t part : {from.x + 1, from.y + 1, from.z + 1})
      key_ = key_ << 16 | static_cast<std::uint16_t>(part);
    for (const std::int32_t part : {vector.x + 2, vector.y + 2, vector.z + 2})
      key_ = key_ << 3 | static_cast<std::uint64_t>(part);
  }
  explicit UndirectedLink(std::uint64_t key) : key_(key) {}

  std::uint64_t key() const { return key_; }
  bool is_turned() const { return is_turned_; }
  Vertex from() const { return {part(41, 16) - 1, part(25, 16) - 1, part(9, 16) - 1}; }
  Vertex vector() const { return {part(6, 3) - 2, part(3, 3) - 2, part(0, 3) - 2}; }
  UndirectedLink before() const { return UndirectedLink(from() - vector(), vector()); }
  UndirectedLink after() const { return UndirectedLink(from() + vector(), vector()); }

 private:
  std::int32_t part(int shift, int bits) const {
    return static_cast<std::int32_t>(key_ >> shift & ((1U << bits) - 1));
  }

  std::uint64_t key_ = 0;
  bool is_turned_ = false;
};

// For each link, the number of polygons that have it forwards minus backwards. Links with 0 are
// omitted.
using Balance = std::unordered_map<std::uint64_t, int>;

void add_link(const UndirectedLink& link, Balance& balance) {
  const auto place = balance.try_emplace(link.key(), 0).first;
  place->second += link.is_turned() ? -1 : 1;
  if (place->second == 0) balance.erase(place);
}

bool is_packable(const Vertex& vertex) {
  constexpr std::int32_t max_coordinate = 32767;
  return std::max({vertex.x, vertex.y, vertex.z}) <= max_coordinate;
}

void add_ring(const meshing::Ring& ring, Balance& balance) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const meshing::Side side =
        meshing::side_between(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
    Vertex vertex = ring[i];
    for (std::int32_t link = 0; link < side.links; ++link) {
      if (balance.size() > Missing::max_open_links) return;
      add_link({vertex, side.link}, balance);
      vertex = vertex + side.link;
    }
  }
}

}  // namespace

bool Missing::add_open_links(const meshing::Polygons& polygons) {
  Balance balance;
  for (const meshing::Polygon& polygon : polygons) {
    for (const meshing::Ring& ring : polygon.rings) {
      if (!std::all_of(ring.begin(), ring.end(), is_packable)) return false;
      add_ring(ring, balance);
    }
    if (balance.size() > max_open_links) return false;
  }
  // Joins open links in a straight line, to draw fewer lines.
  for (const auto& entry : balance) {
    const UndirectedLink first(entry.first);
    if (balance.count(first.before().key()) != 0) continue;
    UndirectedLink last = first;
    while (balance.count(last.after().key()) != 0) last = last.after();
    const Vertex end = last.from() + last.vector();
    if (!is_at_border(first.from(), end)) add_line(first.from(), end);
  }
  return true;
}

// An open surface ends there.
bool Missing::is_at_border(const Vertex& from, const Vertex& to) const {
  if (header_.border == Border::closed) return false;
  const auto on_face = [](std::int32_t a, std::int32_t b, std::uint32_t extent) {
    return a == b && (a == 0 || a == 2 * static_cast<std::int32_t>(extent) - 2);
  };
  return on_face(from.x, to.x, header_.width) || on_face(from.y, to.y, header_.height) ||
         on_face(from.z, to.z, header_.depth);
}

void Missing::add_rows(const std::vector<MissingRows>& rows) {
  const auto at = [](std::uint32_t voxel) { return 2 * static_cast<std::int32_t>(voxel); };
  for (const MissingRows& range : rows) {
    add_box({-1, at(range.first_row) - 1, at(range.slices.first) - 1},
            {at(header_.width) - 1, at(range.last_row) + 1, at(range.slices.last) + 1});
    slices_.push_back(range.slices);
  }
}

void Missing::add_line(const Vertex& from, const Vertex& to) {
  const auto narrow = [](const Vertex& vertex) {
    return std::array<std::int16_t, 3>{static_cast<std::int16_t>(vertex.x),
                                       static_cast<std::int16_t>(vertex.y),
                                       static_cast<std::int16_t>(vertex.z)};
  };
  lines_.push_back({narrow(from), narrow(to)});
  // Between two slices, it belongs to both.
  const auto [low, high] = std::minmax(from.z, to.z);
  const auto first = static_cast<std::uint32_t>(std::max(0, low) / 2);
  const auto last = static_cast<std::uint32_t>((high + 1) / 2);
  const std::uint32_t end = header_.depth > 0 ? header_.depth - 1 : last;
  slices_.push_back({std::min(first, end), std::min(last, end)});
}

void Missing::add_box(const Vertex& low, const Vertex& high) {
  const std::size_t slices = slices_.size();
  for (const std::int32_t a : {0, 1})
    for (const std::int32_t b : {0, 1}) {
      const std::int32_t x = a != 0 ? high.x : low.x, y = a != 0 ? high.y : low.y;
      const std::int32_t y_of_b = b != 0 ? high.y : low.y, z = b != 0 ? high.z : low.z;
      add_line({low.x, y, z}, {high.x, y, z});
      add_line({x, low.y, z}, {x, high.y, z});
      add_line({x, y_of_b, low.z}, {x, y_of_b, high.z});
    }
  slices_.resize(slices);  // the lines show these slices more exactly
}

std::vector<SliceRange> Missing::slices() const {
  std::vector<SliceRange> sorted = slices_, merged;
  std::sort(sorted.begin(), sorted.end(),
            [](const SliceRange& a, const SliceRange& b) { return a.first < b.first; });
  for (const SliceRange& range : sorted) {
    if (merged.empty() || range.first > merged.back().last + 1)
      merged.push_back(range);
    else
      merged.back().last = std::max(merged.back().last, range.last);
  }
  return merged;
}

}  // namespace discmc::web

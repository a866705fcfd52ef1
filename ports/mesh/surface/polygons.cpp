#include "polygons.hpp"

#include <algorithm>
#include <vector>

namespace discmc::meshing {

// A polygon with its first corner, which mostly decides the order.
struct Polygons::Placed {
  Vertex at;
  Record record;
};

// Polygons come nearly in this order: a row at a time, in layers of few coordinates z.
void Polygons::sort() {
  constexpr std::int64_t max_layers = 1 << 11;
  std::int64_t low = std::int64_t{1} << 31, high = -low;
  for (const Record& record : records_) {
    low = std::min<std::int64_t>(low, first_corner(record).z);
    high = std::max<std::int64_t>(high, first_corner(record).z);
  }
  int shift = 0;
  while ((high - low) >> shift >= max_layers) ++shift;
  const auto layer_of = [&](const Record& record) {
    return static_cast<std::size_t>((first_corner(record).z - low) >> shift);
  };
  std::vector<std::size_t> ends(max_layers + 1);  // of each layer: first its begin
  for (const Record& record : records_) ++ends[layer_of(record) + 1];
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  Array<Record> in_order;
  in_order.resize(records_.size());
  for (const Record& record : records_) in_order[ends[layer_of(record)]++] = record;
  std::size_t begin = 0;
  Array<Placed> layer;
  for (const std::size_t end : ends) {
    layer.resize(end - begin);
    std::transform(in_order.begin() + begin, in_order.begin() + end, layer.begin(),
                   [this](const Record& record) {
                     return Placed{first_corner(record), record};
                   });
    std::sort(layer.begin(), layer.end(), [this](const Placed& a, const Placed& b) {
      return a.at != b.at ? precedes(a.at, b.at) : is_before(a.record, b.record);
    });
    std::transform(layer.begin(), layer.end(), records_.begin() + begin,
                   [](const Placed& placed) { return placed.record; });
    begin = end;
  }
}

// Compares two polygons whose first corners are the same.
bool Polygons::is_before(const Record& a, const Record& b) const {
  const auto begin_of = [this](const Record& record) {
    return corners_.begin() + ring_begins_[record.first_ring];
  };
  const auto end_of = [this](const Record& record) {
    return corners_.begin() + ring_begins_[record.first_ring + record.rings];
  };
  if (a.incidence != b.incidence) return a.incidence < b.incidence;
  return std::lexicographical_compare(begin_of(a), end_of(a), begin_of(b), end_of(b), precedes);
}

}  // namespace discmc::meshing

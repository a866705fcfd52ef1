#include "polygons.hpp"

#include <algorithm>
#include <vector>

#include "jobs/parallel.hpp"

namespace discmc::meshing {

// A polygon with its first corner, which mostly decides the order.
struct Polygons::Placed {
  Vertex at;
  Record record;
};

namespace {

// Sorts items by their keys; items with equal keys keep their order. Returns the end of each key's
// items.
template <class Item, class KeyOf>
std::vector<std::size_t> distribute(Array<Item>& items, std::size_t keys, KeyOf key_of) {
  std::vector<std::size_t> ends(keys + 1);  // at first the begins
  for (const Item& item : items) ++ends[key_of(item) + 1];
  for (std::size_t i = 1; i < ends.size(); ++i) ends[i] += ends[i - 1];
  Array<Item> distributed;
  distributed.resize(items.size());
  for (const Item& item : items) distributed[ends[key_of(item)]++] = item;
  items.swap(distributed);
  ends.pop_back();
  return ends;
}

// The least and the greatest of some values.
struct Range {
  std::int64_t low = std::int64_t{1} << 31, high = -low;

  void include(std::int64_t value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace

// Polygons are nearly in order already, row by row, within layers of few coordinates z.
void Polygons::sort(unsigned jobs) {
  constexpr std::int64_t max_layers = 1 << 11;
  Range z;
  for (const Record& record : records_) z.include(first_corner(record).z);
  int shift = 0;
  while ((z.high - z.low) >> shift >= max_layers) ++shift;
  const std::vector<std::size_t> ends = distribute(records_, max_layers, [&](const Record& record) {
    return static_cast<std::size_t>((first_corner(record).z - z.low) >> shift);
  });
  constexpr std::size_t layers_per_step = 1 << 4, polygons_per_job = 1 << 12;
  jobs = static_cast<unsigned>(std::min<std::size_t>(jobs, 1 + size() / polygons_per_job));
  for_each_in_parallel(jobs, max_layers / layers_per_step, [&](std::size_t step) {
    for (std::size_t i = step * layers_per_step; i < (step + 1) * layers_per_step; ++i)
      sort_layer(records_.begin() + (i > 0 ? ends[i - 1] : 0), records_.begin() + ends[i],
                 shift == 0);
  });
}

// is_flat: whether all first corners have the same coordinate z.
void Polygons::sort_layer(Record* begin, Record* end, bool is_flat) {
  Array<Placed> layer;
  layer.resize(static_cast<std::size_t>(end - begin));
  std::transform(begin, end, layer.begin(), [this](const Record& record) {
    return Placed{first_corner(record), record};
  });
  if (is_flat)
    sort_rows(layer);
  else
    sort(layer.begin(), layer.end());
  std::transform(layer.begin(), layer.end(), begin,
                 [](const Placed& placed) { return placed.record; });
}

void Polygons::sort(Placed* begin, Placed* end) const {
  std::sort(begin, end, [this](const Placed& a, const Placed& b) {
    return a.at != b.at ? precedes(a.at, b.at) : is_before(a.record, b.record);
  });
}

// Sorts polygons whose first corners have the same coordinate z.
void Polygons::sort_rows(Array<Placed>& layer) const {
  if (layer.empty()) return;
  Range y;
  for (const Placed& placed : layer) y.include(placed.at.y);
  const std::int64_t rows = y.high - y.low + 1;
  if (rows > 4 * static_cast<std::int64_t>(layer.size())) return sort(layer.begin(), layer.end());
  std::size_t begin = 0;
  for (const std::size_t end : distribute(
           layer, static_cast<std::size_t>(rows),
           [&](const Placed& placed) { return static_cast<std::size_t>(placed.at.y - y.low); })) {
    sort(layer.begin() + begin, layer.begin() + end);
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

#include "crossings.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "mask_bits.hpp"
#include "surface/polygon_crossings.hpp"
#include "surface/surface.hpp"

namespace discmc::meshing {
namespace {

// Returns the loop of each configuration that is a fan about the centroid; without points if there
// is none.
std::array<Loop, configurations> fan_loops() {
  const auto axis_of = [](CellPoint point) {
    const Vertex at = position(point);
    return at.x == 1 ? 0 : at.y == 1 ? 1 : 2;
  };
  const auto is_fan = [&](const Loop& loop) {
    const bool is_flat = std::all_of(loop.point, loop.point + loop.count, [&](CellPoint point) {
      return axis_of(point) == axis_of(loop.point[0]);
    });
    return loop.count > 4 || (loop.count == 4 && is_flat);
  };
  std::array<Loop, configurations> result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    const Loops loops = detail::derive::loops(static_cast<Configuration>(c));
    const Loop* const fan = std::find_if(loops.loop, loops.loop + loops.count, is_fan);
    if (fan != loops.loop + loops.count) result[c] = *fan;
  }
  return result;
}

Vertex corner_at(const Vertex& centroid, unsigned corner) {
  return {(centroid.x - 1) / 2 + static_cast<int>(corner & 1),
          (centroid.y - 1) / 2 + static_cast<int>(corner >> 1 & 1),
          (centroid.z - 1) / 2 + static_cast<int>(corner >> 2)};
}

}  // namespace

// Finds the crossings, one axis after another.
class Crossings::PolygonFinder {
 public:
  PolygonFinder(Crossings& crossings, const Polygons& polygons)
      : crossings_(crossings), polygons_(polygons) {}

  void find(std::size_t axis) {
    found_.clear();
    for (const Polygon& polygon : polygons_)
      meshing::for_each_crossing(polygon, axis,
                                 [&](const Vertex& middle) { add(axis, polygon, middle); });
    store(crossings_.along_[axis]);
    add_rims(axis);
  }

 private:
  struct RowCrossing {
    std::uint64_t row;
    Crossing crossing;
    bool operator<(const RowCrossing& other) const {
      return row != other.row ? row < other.row : crossing.x < other.crossing.x;
    }
    bool operator==(const RowCrossing& other) const {
      return row == other.row && crossing.x == other.crossing.x;
    }
  };

  void add(std::size_t axis, const Polygon& polygon, const Vertex& middle) {
    const Vertex at = middle - crossings_.first_;
    const Vertex begin = {at.x >> 1, at.y >> 1, at.z >> 1};
    if (!crossings_.is_inside(begin) || !crossings_.is_inside(at - begin)) return;
    constexpr std::size_t max_crossings = std::size_t{1} << 27;
    if (found_.size() == max_crossings)
      throw std::length_error("the surface crosses more than " + std::to_string(max_crossings) +
                              " edges along an axis; extract a part, or shrink the volume");
    const Vertex normal = incidence_normal(polygon.incidence);
    const bool falls = component(normal, static_cast<int>(axis)) > 0;
    const std::uint64_t row = std::uint64_t{crossings_.dims_[1]} * static_cast<unsigned>(begin.z) +
                              static_cast<unsigned>(begin.y);
    found_.push_back({row, {static_cast<std::uint16_t>(begin.x), falls, 1, 1}});
  }

  void store(Rows& rows) {
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    rows.crossings.clear();
    rows.begin.clear();
    for (const RowCrossing& found : found_) {
      rows.begin.resize(found.row + 1, rows.crossings.size());
      rows.crossings.push_back(found.crossing);
    }
    rows.begin.resize(std::size_t{crossings_.dims_[1]} * crossings_.dims_[2] + 1,
                      rows.crossings.size());
  }

  // An edge through a side, at the rim of an open surface, may not count as crossing the polygon.
  void add_rims(std::size_t axis) {
    const std::size_t count = found_.size();
    for (const Polygon& polygon : polygons_)
      for (const Ring& ring : polygon.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Side side = side_between(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
          Vertex vertex = ring[i];
          for (std::int32_t link = 0; link < side.links; ++link, vertex = vertex + side.link)
            if (is_middle(vertex) && axis_of(vertex) == axis && !crossings_.find(vertex))
              add(axis, polygon, vertex);
        }
    if (found_.size() > count) store(crossings_.along_[axis]);
  }

  Crossings& crossings_;
  const Polygons& polygons_;
  std::vector<RowCrossing> found_;
};

Crossings::Crossings(const std::array<std::uint32_t, 3>& dims, const Polygons& polygons)
    : dims_{0, 0, 0}, first_{0, 0, 0} {
  // Limits the search to the part of the volume that the polygons span; otherwise a small surface
  // would need all rows.
  std::array<std::int64_t, 3> low{}, high{-1, -1, -1};
  for (const Polygon& polygon : polygons)
    for (const Vertex& corner : polygon.rings[0]) {
      const std::array<std::int64_t, 3> at = {corner.x, corner.y, corner.z};
      const bool is_first = high[0] < low[0];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = is_first ? at[axis] : std::min(low[axis], at[axis]);
        high[axis] = is_first ? at[axis] : std::max(high[axis], at[axis]);
      }
    }
  std::array<std::int32_t, 3> first{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t begin = std::max(low[axis] / 2 - 1, std::int64_t{0});
    const std::int64_t end = std::min(high[axis] / 2 + 2, std::int64_t{dims[axis]});
    if (begin >= end) return;
    first[axis] = static_cast<std::int32_t>(2 * begin);
    dims_[axis] = static_cast<std::uint32_t>(end - begin);
  }
  first_ = {first[0], first[1], first[2]};
  constexpr std::uint64_t max_rows = std::uint64_t{1} << 26;
  if (std::uint64_t{dims_[1]} * dims_[2] > max_rows)
    throw std::length_error("the surface spans more than " + std::to_string(max_rows) +
                            " rows of voxels; extract a part, or shrink the volume");
  PolygonFinder finder(*this, polygons);
  for (std::size_t axis = 0; axis < 3; ++axis) finder.find(axis);
}

bool Crossings::is_inside(const Vertex& voxel) const {
  const std::int32_t at[] = {voxel.x, voxel.y, voxel.z};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (at[axis] < 0 || static_cast<std::uint32_t>(at[axis]) >= dims_[axis]) return false;
  return true;
}

const Crossings::Crossing* Crossings::crossing_of(const Vertex& middle) const {
  const Vertex voxel = {middle.x >> 1, middle.y >> 1, middle.z >> 1};
  if (!is_inside(voxel)) return nullptr;
  const Rows& rows = along_[axis_of(middle)];
  const auto x = static_cast<std::uint32_t>(voxel.x);
  const std::size_t row =
      static_cast<std::size_t>(voxel.z) * dims_[1] + static_cast<std::size_t>(voxel.y);
  if (row + 1 >= rows.begin.size()) return nullptr;
  const Crossing* const end = rows.crossings.data() + rows.begin[row + 1];
  const Crossing* const found =
      std::lower_bound(rows.crossings.data() + rows.begin[row], end, x,
                       [](const Crossing& crossing, std::uint32_t at) { return crossing.x < at; });
  return found != end && found->x == x ? found : nullptr;
}

std::optional<Crossings::Id> Crossings::find(const Vertex& middle) const {
  const Vertex at = middle - first_;
  const Crossing* const crossing = crossing_of(at);
  if (crossing == nullptr) return std::nullopt;
  const std::uint32_t axis = axis_of(at);
  return Id{static_cast<std::uint8_t>(axis),
            static_cast<std::uint32_t>(crossing - along_[axis].crossings.data())};
}

// Starts at a corner inside the volume and reaches the others across the edges between them.
Configuration Crossings::configuration_around(const Vertex& centroid) const {
  unsigned base = 0;
  while (!is_inside(corner_at(centroid, base))) ++base;
  unsigned differ = 0;      // from the base
  bool is_base_on = false;  // irrelevant if no corner differs
  for (unsigned away = 1; away < 8; ++away) {
    const unsigned corner = base ^ away, before = base ^ (away & (away - 1));
    const Vertex to = corner_at(centroid, corner);
    if (!is_inside(to)) continue;
    const Vertex from = corner_at(centroid, before);
    const Crossing* const crossing = crossing_of(from + to);
    const unsigned differs_before = differ >> before & 1;
    differ |= (differs_before ^ (crossing != nullptr ? 1U : 0U)) << corner;
    if (crossing == nullptr) continue;
    const bool is_from_first = from.x + from.y + from.z < to.x + to.y + to.z;
    const bool is_from_on = crossing->falls == is_from_first;
    is_base_on = is_from_on != (differs_before != 0);
  }
  unsigned configuration = 0;
  for (unsigned corner = 0; corner < 8; ++corner)
    if (is_inside(corner_at(centroid, corner)) && ((differ >> corner & 1) == 0) == is_base_on)
      configuration |= 1U << corner;
  return static_cast<Configuration>(configuration);
}

Point Crossings::on_edge(const Vertex& middle) const {
  Point point = {static_cast<double>(middle.x), static_cast<double>(middle.y),
                 static_cast<double>(middle.z)};
  if (const Crossing* const crossing = crossing_of(middle))
    point[axis_of(middle)] += static_cast<double>(crossing->at) - 1;
  return point;
}

Vertex Crossings::middle_of(std::size_t axis, std::size_t row, std::uint32_t x) const {
  const auto step = [axis](std::size_t coordinate) { return axis == coordinate ? 1 : 0; };
  return first_ + Vertex{2 * static_cast<std::int32_t>(x) + step(0),
                         2 * static_cast<std::int32_t>(row % dims_[1]) + step(1),
                         2 * static_cast<std::int32_t>(row / dims_[1]) + step(2)};
}

Point Crossings::interpolated(const Vertex& vertex) const {
  const Point point = in_volume(vertex - first_);
  return {point[0] + first_.x, point[1] + first_.y, point[2] + first_.z};
}

Point Crossings::in_volume(const Vertex& vertex) const {
  const bool is_centroid = (vertex.x & vertex.y & vertex.z & 1) != 0;
  if (!is_centroid) return on_edge(vertex);
  static const std::array<Loop, configurations> loops = fan_loops();
  const Loop& loop = loops[configuration_around(vertex)];
  if (loop.count == 0)
    return {static_cast<double>(vertex.x), static_cast<double>(vertex.y),
            static_cast<double>(vertex.z)};
  Point mean{};
  for (int i = 0; i < loop.count; ++i) {
    const Point crossing = on_edge(vertex - Vertex{1, 1, 1} + position(loop.point[i]));
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += crossing[axis] / loop.count;
  }
  return mean;
}

// The bits that are on and the samples, slice by slice.
class CrossingFinder::Slices {
 public:
  // Slices are numbered in the order of arrival.
  Slices(const SampleGrid& info, const Vertex& first)
      : crossings_({info.dims[0], info.dims[1], 0}, first) {}
  Slices(const Slices&) = delete;
  Slices& operator=(const Slices&) = delete;
  virtual ~Slices() = default;

  virtual void add(const void* samples, const std::uint8_t* mask) = 0;
  Crossings& crossings() { return crossings_; }

 protected:
  Crossings crossings_;
};

template <class Sample>
class CrossingFinder::TypedSlices final : public Slices {
 public:
  TypedSlices(const SampleGrid& info, const Selection& selection, const Vertex& first,
              bool keeps_ends)
      : Slices(info, first),
        keeps_ends_(keeps_ends),
        selector_(info, selection),
        width_(info.dims[0]),
        height_(info.dims[1]),
        row_bytes_(bit_row_bytes(width_)),
        range_(selected_samples<Sample>(info, selection)) {
    const double half = is_floating(info.type) ? 0 : 0.5;
    low_level_ = static_cast<double>(range_.low) - half;
    high_level_ = static_cast<double>(range_.high) + half;
    for (Slice* slice : {&below_, &above_}) slice->bits.resize(row_bytes_ * height_);
    changes_.resize(row_bytes_);
  }

  void add(const void* samples, const std::uint8_t* mask) override {
    std::swap(below_, above_);
    ++crossings_.dims_[2];
    const auto* first = static_cast<const Sample*>(samples);
    above_.samples.assign(first, first + std::size_t{width_} * height_);
    selector_.select(samples, above_.bits.data(), row_bytes_);
    if (mask != nullptr) keep_masked(above_.bits.data(), mask, above_.bits.size());
    for (std::uint32_t y = 0; y < height_; ++y) add_row(y);
  }

 private:
  struct Slice {
    std::vector<std::uint8_t> bits;
    std::vector<Sample> samples;
  };

  const std::uint8_t* bits(const Slice& slice, std::uint32_t y) const {
    return slice.bits.data() + y * row_bytes_;
  }
  const Sample* samples(const Slice& slice, std::uint32_t y) const {
    return slice.samples.data() + std::size_t{y} * width_;
  }

  void add_row(std::uint32_t y) {
    const std::uint8_t* const row = bits(above_, y);
    for (std::size_t i = 0; i < row_bytes_; ++i) {
      const unsigned next = i + 1 < row_bytes_ ? row[i + 1] : 0U;
      changes_[i] = static_cast<std::uint8_t>(row[i] ^ (row[i] >> 1 | next << 7));
    }
    const std::uint32_t last = width_ - 1;  // no edge begins there
    changes_[last / 8] &= static_cast<std::uint8_t>(~(1U << last % 8));
    add_crossings(0, row, samples(above_, y), samples(above_, y) + 1);

    if (y + 1 < height_) {
      set_changes(row, bits(above_, y + 1));
      add_crossings(1, row, samples(above_, y), samples(above_, y + 1));
    } else {
      end_row(1);
    }
    if (below_.samples.empty()) return;
    set_changes(bits(below_, y), row);
    add_crossings(2, bits(below_, y), samples(below_, y), samples(above_, y));
  }

  void set_changes(const std::uint8_t* from, const std::uint8_t* to) {
    for (std::size_t i = 0; i < row_bytes_; ++i)
      changes_[i] = static_cast<std::uint8_t>(from[i] ^ to[i]);
  }

  void add_crossings(std::size_t axis, const std::uint8_t* bits, const Sample* from,
                     const Sample* to) {
    auto& crossings = crossings_.along_[axis].crossings;
    for (std::size_t i = 0; i < row_bytes_; ++i) {
      if (changes_[i] == 0) continue;
      for (unsigned bit = 0; bit < 8; ++bit) {
        if ((changes_[i] >> bit & 1) == 0) continue;
        const std::size_t x = 8 * i + bit;
        const bool falls = (bits[i] >> bit & 1) != 0;
        const float at = falls ? crossing(from[x], to[x]) : 2 - crossing(to[x], from[x]);
        crossings.push_back({static_cast<std::uint16_t>(x), falls, 1, at});
        if (keeps_ends_)
          crossings_.along_[axis].ends.push_back(
              {static_cast<float>(static_cast<double>(from[x]) - low_level_),
               static_cast<float>(static_cast<double>(to[x]) - low_level_)});
      }
    }
    end_row(axis);
  }

  void end_row(std::size_t axis) {
    Crossings::Rows& rows = crossings_.along_[axis];
    rows.begin.push_back(rows.crossings.size());
  }

  float crossing(Sample on_sample, Sample off_sample) const {
    if (range_.holds(off_sample)) return 1;  // off because of the mask
    const auto on = static_cast<double>(on_sample), off = static_cast<double>(off_sample);
    const double level = off_sample < range_.low ? low_level_ : high_level_;
    const double at = 2 * (on - level) / (on - off);
    if (!std::isfinite(on) || !std::isfinite(off) || !std::isfinite(at)) return 1;
    return static_cast<float>(std::clamp(at, Crossings::margin, 2 - Crossings::margin));
  }

  bool keeps_ends_;
  SliceSelector selector_;
  std::uint32_t width_, height_;
  std::size_t row_bytes_;
  SampleRange<Sample> range_;
  double low_level_, high_level_;
  Slice below_, above_;
  std::vector<std::uint8_t> changes_;  // along the current row
};

CrossingFinder::CrossingFinder(const SampleGrid& info, const Selection& selection,
                               const Vertex& first, bool keeps_ends)
    : slices_(with_sample_type(info.type, [&](auto type) -> std::unique_ptr<Slices> {
        return std::make_unique<TypedSlices<decltype(type)>>(info, selection, first, keeps_ends);
      })) {}

CrossingFinder::CrossingFinder(CrossingFinder&&) noexcept = default;
CrossingFinder& CrossingFinder::operator=(CrossingFinder&&) noexcept = default;
CrossingFinder::~CrossingFinder() = default;

void CrossingFinder::add_slice(const void* samples, const std::uint8_t* mask) {
  slices_->add(samples, mask);
}

const Crossings& CrossingFinder::crossings() const {
  return slices_->crossings();
}
Crossings& CrossingFinder::crossings() {
  return slices_->crossings();
}

}  // namespace discmc::meshing

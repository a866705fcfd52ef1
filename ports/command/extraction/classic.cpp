#include "classic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <discmc/geometry/cell.hpp>
#include <limits>
#include <utility>
#include <vector>

#include "meshes/outline.hpp"

namespace discmc::command {
namespace {

// Whether all diagonals of a fan avoid the faces of the cell. On a face, the neighbour's fan may
// have the same diagonal.
bool is_inside(const Loop& loop, int apex) {
  for (int i = 2; i + 1 < loop.count; ++i)
    if (face_of(loop.point[apex], loop.point[(apex + i) % loop.count]) != faces) return false;
  return true;
}

// Rotates every loop to begin at the apex of its fan. Each loop has such an apex.
std::array<Loops, configurations> fans() {
  std::array<Loops, configurations> result{};
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = detail::derive::loops(static_cast<Configuration>(c));
    for (int i = 0; i < result[c].count; ++i) {
      Loop& loop = result[c].loop[i];
      int apex = 0;
      while (!is_inside(loop, apex)) ++apex;
      std::rotate(loop.point, loop.point + apex, loop.point + loop.count);
    }
  }
  return result;
}

constexpr std::uint32_t no_vertex = 0xFFFFFFFFu;
constexpr double halo = -std::numeric_limits<double>::infinity();

// Returns a level that exactly the samples that are on exceed: for whole numbers, half a unit below
// the least of them.
double level_below(const VolumeInfo& info, const Selection& selection) {
  return with_sample_type(info.type, [&](auto type) {
    using Sample = decltype(type);
    const SampleRange<Sample> range = selected_samples<Sample>(info, selection);
    if (range.low > range.high) return std::numeric_limits<double>::infinity();
    const auto low = static_cast<double>(range.low);
    return is_floating(info.type) ? std::nextafter(low, -std::numeric_limits<double>::infinity())
                                  : low - 0.5;
  });
}

class Cubes {
 public:
  Cubes(const VolumeInfo& info, const ExtractionOptions& options)
      : border_(options.border == Border::closed ? 1 : 0),
        width_(info.dims[0] + 2 * border_),
        height_(info.dims[1] + 2 * border_),
        level_(level_below(info, options.selection)) {
    mesh_.spacing_mm = info.spacing_mm;
    is_mirrored_ = meshing::is_mirrored(mesh_.spacing_mm);
    for (Slice* slice : {&below_, &above_}) {
      slice->value.assign(width_ * height_, halo);
      for (auto& crossings : slice->crossings) crossings.assign(width_ * height_, no_vertex);
    }
  }

  void add_halo_slice() {
    next_slice();
    add_cells();
  }
  template <class Sample>
  void add_slice(const Sample* samples) {
    next_slice();
    for (std::size_t y = border_; y + border_ < height_; ++y)
      for (std::size_t x = border_; x + border_ < width_; ++x)
        above_.value[y * width_ + x] = value_of(static_cast<double>(*samples++));
    add_cells();
  }

  FaceMesh mesh() { return std::move(mesh_); }

 private:
  // A slice of voxels with its halo, and the vertices on the edges that begin in the slice.
  struct Slice {
    std::vector<double> value;  // height above the level; positive if the voxel is on
    std::array<std::vector<std::uint32_t>, 3> crossings;  // along x, y, and z towards `above_`
  };

  void next_slice() {
    std::swap(below_, above_);
    for (auto& crossings : above_.crossings)
      std::fill(crossings.begin(), crossings.end(), no_vertex);
    std::fill(above_.value.begin(), above_.value.end(), halo);
  }

  // An infinite or NaN sample that is off has the value of the halo.
  double value_of(double sample) const {
    const double value = sample - level_;
    return value > 0    ? std::min(value, std::numeric_limits<double>::max())
           : value <= 0 ? value
                        : halo;
  }

  void add_cells() {
    for (std::size_t y = 0; slices_ > 0 && y + 1 < height_; ++y)
      for (std::size_t x = 0; x + 1 < width_; ++x) add_cell(x, y);
    ++slices_;
  }

  void add_cell(std::size_t x, std::size_t y) {
    unsigned configuration = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Slice& slice = corner < 4 ? below_ : above_;
      const double value = slice.value[(y + (corner >> 1 & 1)) * width_ + x + (corner & 1)];
      configuration |= (value > 0 ? 1U : 0U) << corner;
    }
    const Loops& loops = fans_[configuration];
    for (int i = 0; i < loops.count; ++i) {
      const Loop& loop = loops.loop[i];
      std::uint32_t vertex[Loop::max_points];
      for (int j = 0; j < loop.count; ++j) vertex[j] = vertex_at(loop.point[j], x, y);
      for (int j = 2; j < loop.count; ++j)
        add_triangle(vertex[0], vertex[is_mirrored_ ? j : j - 1], vertex[is_mirrored_ ? j - 1 : j]);
    }
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.polygons.push_back(static_cast<std::uint32_t>(mesh_.face_count()));
    for (const std::uint32_t vertex : {a, b, c}) mesh_.corners.push_back(vertex);
    mesh_.face_begin.push_back(mesh_.corners.size());
  }

  std::uint32_t vertex_at(CellPoint point, std::size_t cell_x, std::size_t cell_y) {
    const Vertex in_cell = position(point);
    const std::size_t axis = in_cell.x == 1 ? 0 : in_cell.y == 1 ? 1 : 2;
    Slice& slice = in_cell.z == 2 ? above_ : below_;
    const std::size_t x = cell_x + (in_cell.x == 2 ? 1 : 0);
    const std::size_t y = cell_y + (in_cell.y == 2 ? 1 : 0);
    const std::size_t place = y * width_ + x;
    std::uint32_t& vertex = slice.crossings[axis][place];
    if (vertex == no_vertex) {
      const double from = slice.value[place];
      const double to =
          axis == 2 ? above_.value[place] : slice.value[place + (axis == 0 ? 1 : width_)];
      const bool at_halo = from == halo || to == halo;
      const double z = slices_ - (in_cell.z == 2 ? 0.0 : 1.0);
      Point voxel = {static_cast<double>(x), static_cast<double>(y), z};
      voxel[axis] += at_halo ? 0.5 : from / (from - to);
      vertex = static_cast<std::uint32_t>(mesh_.vertices_mm.size());
      for (std::size_t i = 0; i < 3; ++i)
        voxel[i] = (voxel[i] - static_cast<double>(border_)) * mesh_.spacing_mm[i];
      mesh_.vertices_mm.push_back(voxel);
    }
    return vertex;
  }

  const std::array<Loops, configurations> fans_ = fans();
  std::size_t border_, width_, height_;
  double level_;
  bool is_mirrored_;
  std::uint32_t slices_ = 0;  // number of slices below `above_`
  Slice below_, above_;
  FaceMesh mesh_;
};

}  // namespace

FaceMesh classic_mesh(VolumeReader& volume, const ExtractionOptions& options) {
  const VolumeInfo& info = volume.info();
  Cubes cubes(info, options);
  if (options.border == Border::closed) cubes.add_halo_slice();
  std::vector<std::uint8_t> slice(info.slice_bytes());
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    with_sample_type(info.type, [&](auto type) {
      cubes.add_slice(reinterpret_cast<const decltype(type)*>(slice.data()));
    });
    if (options.progress) options.progress(z + 1);
  }
  if (options.border == Border::closed) cubes.add_halo_slice();
  return cubes.mesh();
}

}  // namespace discmc::command

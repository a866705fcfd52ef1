#include "corner_set.hpp"

#include <algorithm>
#include <stdexcept>

namespace discmc::web {
namespace {

template <class Call>
void for_each_corner(const meshing::Polygons& polygons, Call call) {
  for (const meshing::Polygon& polygon : polygons)
    for (const meshing::Ring& ring : polygon.rings)
      for (const Vertex& corner : ring) call(corner);
}

}  // namespace

void CornerSet::fill(const meshing::Polygons& polygons) {
  blocks_.clear();
  lay_out(polygons);
  for_each_corner(polygons, [this](const Vertex& corner) {
    const Place place = place_of(corner);
    std::uint32_t& block = numbers_[place.block];
    if (block == none) {
      block = static_cast<std::uint32_t>(blocks_.size());
      blocks_.emplace_back();
    }
    blocks_[block][place.word] |= std::uint64_t{1} << place.bit;
  });
}

void CornerSet::lay_out(const meshing::Polygons& polygons) {
  numbers_.clear();
  if (polygons.empty()) return;
  least_ = polygons[0].rings[0][0];
  Vertex greatest = least_;
  for_each_corner(polygons, [&](const Vertex& corner) {
    least_ = {std::min(least_.x, corner.x), std::min(least_.y, corner.y),
              std::min(least_.z, corner.z)};
    greatest = {std::max(greatest.x, corner.x), std::max(greatest.y, corner.y),
                std::max(greatest.z, corner.z)};
  });
  if (std::max({greatest.x, greatest.y, greatest.z}) > max_coordinate)
    throw std::runtime_error("the surface is larger than the page can draw");
  const auto blocks = [](std::int32_t low, std::int32_t high) {
    return (std::uint64_t{static_cast<std::uint32_t>(high) - static_cast<std::uint32_t>(low)} / 8) +
           1;
  };
  const std::uint64_t columns = blocks(least_.x, greatest.x), rows = blocks(least_.y, greatest.y),
                      layers = blocks(least_.z, greatest.z);
  if (columns > max_blocks / rows || columns * rows > max_blocks / layers)
    throw std::runtime_error("the surface is larger than the page can draw");
  columns_ = columns;
  rows_ = rows;
  numbers_.assign(columns * rows * layers, none);
}

}  // namespace discmc::web

#include "shading.hpp"

#include <algorithm>
#include <cmath>

namespace discmc::command {
namespace {

// Minimum cosine of the angle between the normals of a face and of its vertex. Facets lean up to 55
// degrees away from the surface that they approximate; the walls at the ends of a volume, 90
// degrees.
constexpr double min_cosine = 0.3;

float light_of(std::uint8_t srgb) {
  return decoded_light(static_cast<float>(srgb) / 255);
}

// Returns twice the area of a triangle, positive if clockwise, because y points downwards.
double doubled_area(double ax, double ay, const Projected& b, const Projected& c) {
  return (b.x - ax) * (c.y - ay) - (b.y - ay) * (c.x - ax);
}

Colour light_of(const Srgb& colour) {
  return {light_of(colour[0]), light_of(colour[1]), light_of(colour[2])};
}

}  // namespace

Shader::Shader(const FaceMesh& mesh, const std::vector<Projected>& vertices, const Axes& axes,
               const PictureOptions& options)
    : mesh_(mesh),
      vertices_(vertices),
      axes_(axes),
      shading_(options.shading),
      face_colours_(options.face_colours),
      surface_(light_of(options.colour)),
      face_(mesh.face_count()) {}

Colour Shader::colour(std::size_t face, bool is_inside, double x, double y) {
  if (face != face_) begin_face(face);
  return light(shading_ == Shading::flat ? face_normal_ : normal_at(x, y), is_inside);
}

void Shader::begin_face(std::size_t face) {
  face_ = face;
  face_normal_ = face_normal(mesh_, face);
  if (!face_colours_.empty()) surface_ = light_of(face_colours_[face]);
  if (shading_ == Shading::flat) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& normal = mesh_.normals[mesh_.face(face)[i]];
    normals_[i] = dot(normal, face_normal_) < min_cosine ? face_normal_ : normal;
  }
}

Point Shader::normal_at(double x, double y) const {
  const std::uint32_t* corners = mesh_.face(face_);
  Point sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Projected &b = vertices_[corners[(i + 1) % 3]], &c = vertices_[corners[(i + 2) % 3]];
    const double share = std::abs(doubled_area(x, y, b, c)) * vertices_[corners[i]].weight;
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += share * normals_[i][axis];
  }
  return unit_or_zero(sum);
}

Colour Shader::light(const Point& normal, bool is_inside) const {
  const double side = is_inside ? -1 : 1;
  const Point in_view = {side * dot(normal, axes_.right), side * dot(normal, axes_.upward),
                         side * dot(normal, axes_.towards)};
  const auto fill = static_cast<float>(0.14 + 0.08 * in_view[1]);
  const auto light = static_cast<float>(0.28 * std::max(0.0, in_view[2]) +
                                        0.74 * std::max(0.0, dot(in_view, key_light_)));
  const Colour tone = is_inside ? Colour{0.3f, 0.6f, 1.2f} : Colour{1, 1, 1};
  const Colour sky = {0.7f, 0.95f, 1.4f};  // a cool light distinguishes shade from dark colours
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = surface_[i] * tone[i] * (fill * sky[i] + light);
  return colour;
}

}  // namespace discmc::command

#include "picture.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "shading.hpp"

namespace discmc::command {
namespace {

constexpr int samples_per_side = 2;     // of a pixel
constexpr double margin = 0.05;         // of the picture, on each side
constexpr double field_of_view = 0.45;  // radians
constexpr float outline_light = 0.30f;  // share of light that remains

Point unit(const Point& a) {
  const Point result = unit_or_zero(a);
  if (result == Point{})
    throw std::invalid_argument("0,0,0 is not a direction; give another vector");
  return result;
}

Axes axes_of(const PictureOptions& options) {
  const Point towards = unit(options.from);
  Point right = cross(unit(options.up), towards);
  if (dot(right, right) < 1e-12)  // if `up` is the direction of view, any other axis works
    right = cross(std::abs(towards[1]) < 0.9 ? Point{0, 1, 0} : Point{1, 0, 0}, towards);
  right = unit(right);
  return {right, cross(towards, right), towards};
}

struct Box {
  Point low, high;

  Box() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  void add(const Point& point) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
};

// Projects space into the picture. Any unit of length works.
class Camera {
 public:
  Camera(const Box& space, const Axes& axes, Projection projection)
      : axes_(axes), projection_(projection) {
    double radius = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      centre_[i] = (space.low[i] + space.high[i]) / 2;
      radius = std::hypot(radius, (space.high[i] - space.low[i]) / 2);
    }
    distance_ = radius / std::sin(field_of_view / 2);
  }

  Projected project(const Point& point) const {
    const Point p = difference(point, centre_);
    Projected q = {dot(p, axes_.right), -dot(p, axes_.upward), dot(p, axes_.towards), 1};
    if (projection_ == Projection::orthographic) return q;
    q.nearness = q.weight = 1 / (distance_ - q.nearness);
    q.x *= q.weight;
    q.y *= q.weight;
    return q;
  }

 private:
  Axes axes_;
  Projection projection_;
  Point centre_{};
  double distance_;
};

std::vector<Projected> project(const FaceMesh& mesh, const Axes& axes,
                               const PictureOptions& options) {
  Box space;
  for (const Point& vertex : mesh.vertices_mm) space.add(vertex);
  const Camera camera(space, axes, options.projection);

  std::vector<Projected> vertices;
  vertices.reserve(mesh.vertices_mm.size());
  Box plane;
  for (const Point& vertex : mesh.vertices_mm) {
    vertices.push_back(camera.project(vertex));
    plane.add({vertices.back().x, vertices.back().y, 0});
  }
  Projected middle = {(plane.low[0] + plane.high[0]) / 2, (plane.low[1] + plane.high[1]) / 2, 0, 1};
  if (options.at && !vertices.empty()) middle = camera.project(*options.at);
  if (!(middle.weight > 0))
    throw std::invalid_argument(
        "the point in the middle lies behind the viewer; give a point on the mesh");

  const double width = options.width * samples_per_side;
  const double height = options.height * samples_per_side;
  const double scale =
      options.zoom * (1 - 2 * margin) *
      std::min(width / (plane.high[0] - plane.low[0]), height / (plane.high[1] - plane.low[1]));
  for (Projected& q : vertices) {
    q.x = (q.x - middle.x) * scale + width / 2;
    q.y = (q.y - middle.y) * scale + height / 2;
  }
  return vertices;
}

constexpr std::uint32_t no_face = 0xFFFFFFFFu;

struct Sample {
  float nearness = -std::numeric_limits<float>::infinity();
  std::uint32_t face = no_face;
  bool is_inside = false;
};

// Fills plane polygons of any shape, one sample row after another, and keeps the nearest.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  int width() const { return width_; }
  int height() const { return height_; }
  const Sample& at(int x, int y) const { return samples_[place(x, y)]; }

  void fill(const std::vector<Projected>& outline, std::uint32_t face) {
    // Newell's method gives the normal of the projected polygon, even if corners are collinear.
    double nx = 0, ny = 0, nz = 0;
    const Projected& o = outline[0];
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
      const Projected &a = outline[i], &b = outline[i + 1];
      nx += (a.y - o.y) * (b.nearness - o.nearness) - (a.nearness - o.nearness) * (b.y - o.y);
      ny += (a.nearness - o.nearness) * (b.x - o.x) - (a.x - o.x) * (b.nearness - o.nearness);
      nz += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    }
    if (std::abs(nz) < 1e-9) return;  // seen edge-on
    Sample sample;
    sample.face = face;
    sample.is_inside = nz > 0;  // y points downwards
    find_crossings(outline);
    for (std::size_t i = 0; i + 1 < crossings_.size(); i += 2) {
      const int y = crossings_[i].first;
      const int begin = first_sample(crossings_[i].second, width_);
      const int end = first_sample(crossings_[i + 1].second, width_);
      const double row = o.nearness - ((y + 0.5 - o.y) * ny + (0.5 - o.x) * nx) / nz;
      for (int x = begin; x < end; ++x) {
        sample.nearness = static_cast<float>(row - x * nx / nz);
        Sample& old = samples_[place(x, y)];
        if (sample.nearness > old.nearness) old = sample;
      }
    }
  }

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }

  // Returns the first sample whose centre is not before `edge`, or 0 if `edge` is NaN.
  static int first_sample(double edge, int count) {
    const double place = std::ceil(edge - 0.5);
    return place > 0 ? static_cast<int>(std::min(place, static_cast<double>(count))) : 0;
  }

  // Finds the sorted crossings of the outline with the middle of each sample row. Pairs of
  // crossings bound the inside.
  void find_crossings(const std::vector<Projected>& outline) {
    crossings_.clear();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Projected a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
      if (a.y > b.y) std::swap(a, b);  // so that both polygons of an edge compute the same crossing
      const int end = first_sample(b.y, height_);
      for (int y = first_sample(a.y, height_); y < end; ++y)
        crossings_.emplace_back(y, a.x + (y + 0.5 - a.y) * (b.x - a.x) / (b.y - a.y));
    }
    std::sort(crossings_.begin(), crossings_.end());
  }

  int width_, height_;
  std::vector<Sample> samples_;
  std::vector<std::pair<int, double>> crossings_;
};

// Draws outlines between neighbouring samples of different polygons, so hidden lines never appear.
class Outlines {
 public:
  Outlines(const Canvas& canvas, const FaceMesh& mesh) : canvas_(canvas), mesh_(mesh) {}

  bool is_outline(int x, int y) const {
    const std::uint64_t polygon = polygon_at(x, y);
    return (x + 1 < canvas_.width() && polygon_at(x + 1, y) != polygon) ||
           (y + 1 < canvas_.height() && polygon_at(x, y + 1) != polygon);
  }

 private:
  std::uint64_t polygon_at(int x, int y) const {
    const std::uint32_t face = canvas_.at(x, y).face;
    return face == no_face ? ~std::uint64_t{0} : mesh_.polygons[face];
  }

  const Canvas& canvas_;
  const FaceMesh& mesh_;
};

std::vector<std::uint8_t> srgb_of_4096() {
  std::vector<std::uint8_t> table(4096);
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = byte_of_share(
        encoded_light(static_cast<double>(i) / static_cast<double>(table.size() - 1)));
  return table;
}

Picture shaded_picture(const Canvas& canvas, const FaceMesh& mesh, Shader& shader,
                       const PictureOptions& options) {
  const std::vector<std::uint8_t> to_srgb = srgb_of_4096();
  const Outlines outlines(canvas, mesh);
  constexpr int samples = samples_per_side * samples_per_side;
  Picture picture;
  picture.width = options.width;
  picture.height = options.height;
  for (int row = 0; row < options.height; ++row) {
    const float background =
        0.90f - 0.50f * static_cast<float>(row) / static_cast<float>(canvas.height());
    for (int column = 0; column < options.width; ++column) {
      Colour sum{};
      for (int i = 0; i < samples; ++i) {
        const int x = column * samples_per_side + i % samples_per_side;
        const int y = row * samples_per_side + i / samples_per_side;
        const Sample& sample = canvas.at(x, y);
        Colour colour = {background, background, background};
        if (sample.face != no_face) {
          picture.shows_mesh = true;
          colour = shader.colour(sample.face, sample.is_inside, x + 0.5, y + 0.5);
        }
        const bool is_dark = options.draws_outlines && outlines.is_outline(x, y);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c] * (is_dark ? outline_light : 1);
      }
      for (const float light : sum) {
        const float mean = std::min(light / samples, 1.0f);
        picture.pixels.push_back(to_srgb[static_cast<std::size_t>(std::lround(mean * 4095))]);
      }
    }
  }
  return picture;
}

void check(const FaceMesh& mesh, const PictureOptions& options) {
  constexpr int max_pixels = 8192;
  if (options.width < 1 || options.height < 1 || options.width > max_pixels ||
      options.height > max_pixels)
    throw std::invalid_argument("the size of the picture is out of range");
  if (!(options.zoom >= 1e-3 && options.zoom <= 1e3))
    throw std::invalid_argument("the zoom is out of range");
  if (options.shading == Shading::flat) return;
  if (mesh.normals.size() != mesh.vertices_mm.size())
    throw std::invalid_argument("smooth shading of a mesh without normals");
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) != 3)
      throw std::invalid_argument("smooth shading takes triangles only");
}

}  // namespace

Picture draw(const FaceMesh& mesh, const PictureOptions& options) {
  check(mesh, options);
  const Axes axes = axes_of(options);
  Canvas canvas(options.width * samples_per_side, options.height * samples_per_side);
  const std::vector<Projected> vertices = project(mesh, axes, options);
  std::vector<Projected> outline;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    outline.clear();
    for (std::size_t i = 0; i < mesh.face_size(face); ++i)
      outline.push_back(vertices[mesh.face(face)[i]]);
    if (!outline.empty()) canvas.fill(outline, static_cast<std::uint32_t>(face));
  }
  Shader shader(mesh, vertices, axes, options);
  return shaded_picture(canvas, mesh, shader, options);
}

void write_picture(const Picture& picture, std::ostream& out) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t count = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> bytes(count);
  if (png_image_write_to_memory(&image, bytes.data(), &count, 0, picture.pixels.data(), 0,
                                nullptr) == 0)
    throw std::runtime_error(image.message);
  out.write(bytes.data(), static_cast<std::streamsize>(count));
}

}  // namespace discmc::command

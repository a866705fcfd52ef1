#include "picture.hpp"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "output_file.hpp"

namespace discmc::host {
namespace {

constexpr int samples_per_side = 2;     // of a pixel
constexpr double margin = 0.05;         // of the picture, on each side
constexpr double field_of_view = 0.45;  // radians
constexpr float outline_light = 0.30f;  // what an outline leaves of the light

using Colour = std::array<float, 3>;  // linear light

double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Point unit(const Point& a) {
  const double length = std::hypot(a[0], a[1], a[2]);
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument("a direction of no length: give one that is not 0,0,0");
  return {a[0] / length, a[1] / length, a[2] / length};
}

// Axes of the viewer: right, upwards, and out of the picture towards him.
struct Axes {
  Point right, upward, towards;
};

Axes axes_of(const PictureOptions& options) {
  const Point towards = unit(options.from);
  Point right = cross(unit(options.up), towards);
  if (dot(right, right) < 1e-12)  // looking along `up`: any other choice will do
    right = cross(std::abs(towards[1]) < 0.9 ? Point{0, 1, 0} : Point{1, 0, 0}, towards);
  right = unit(right);
  return {right, cross(towards, right), towards};
}

// A vertex in the picture: x to the right and y downwards in samples, and a nearness that grows
// towards the viewer and is linear over the picture of a plane.
struct Projected {
  double x, y, nearness;
};

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

std::vector<Projected> project(const Mesh& mesh, const Axes& axes, const PictureOptions& options) {
  Box space;
  for (const Point& vertex : mesh.vertices_mm) space.add(vertex);
  Point centre{};
  double radius = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    centre[i] = (space.low[i] + space.high[i]) / 2;
    radius = std::hypot(radius, (space.high[i] - space.low[i]) / 2);
  }
  const double distance = radius / std::sin(field_of_view / 2);

  std::vector<Projected> vertices;
  vertices.reserve(mesh.vertices_mm.size());
  Box plane;
  for (const Point& vertex : mesh.vertices_mm) {
    const Point p = {vertex[0] - centre[0], vertex[1] - centre[1], vertex[2] - centre[2]};
    Projected q = {dot(p, axes.right), -dot(p, axes.upward), dot(p, axes.towards)};
    if (options.projection == Projection::perspective) {
      q.nearness = 1 / (distance - q.nearness);
      q.x *= q.nearness;
      q.y *= q.nearness;
    }
    plane.add({q.x, q.y, 0});
    vertices.push_back(q);
  }

  const double width = options.width * samples_per_side;
  const double height = options.height * samples_per_side;
  const double scale = (1 - 2 * margin) * std::min(width / (plane.high[0] - plane.low[0]),
                                                   height / (plane.high[1] - plane.low[1]));
  for (Projected& q : vertices) {
    q.x = (q.x - (plane.low[0] + plane.high[0]) / 2) * scale + width / 2;
    q.y = (q.y - (plane.low[1] + plane.high[1]) / 2) * scale + height / 2;
  }
  return vertices;
}

float linear(std::uint8_t srgb) {
  const float value = static_cast<float>(srgb) / 255;
  return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

std::uint8_t srgb(float linear) {
  const float light = std::clamp(linear, 0.0f, 1.0f);
  const float value =
      light <= 0.0031308f ? light * 12.92f : 1.055f * std::pow(light, 1 / 2.4f) - 0.055f;
  return static_cast<std::uint8_t>(std::lround(value * 255));
}

// There are only 26 normals, each seen from two sides: all shading is a small table.
class Palette {
 public:
  Palette(const Mesh& mesh, const Axes& axes, const PictureOptions& options) {
    const Point key = unit({-0.6, 0.7, 0.5});  // right, upward, towards: over the left shoulder
    for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
      if (incidence == no_incidence) continue;
      const Point n = outward_normal(incidence, mesh.spacing_mm);
      const Point seen = {dot(n, axes.right), dot(n, axes.upward), dot(n, axes.towards)};
      for (const bool inside : {false, true}) {
        const double side = inside ? -1 : 1;
        const auto fill = static_cast<float>(0.14 + 0.08 * side * seen[1]);
        const auto light = static_cast<float>(0.28 * std::max(0.0, side * seen[2]) +
                                              0.74 * std::max(0.0, side * dot(seen, key)));
        const Colour tone = inside ? Colour{0.3f, 0.6f, 1.2f} : Colour{1, 1, 1};
        const Colour sky = {0.7f, 0.95f, 1.4f};  // a cool fill tells shade from a dark colour
        for (std::size_t i = 0; i < 3; ++i)
          colours_[inside][incidence][i] =
              linear(options.colour[i]) * tone[i] * (fill * sky[i] + light);
      }
    }
  }

  const Colour& colour(Incidence incidence, bool inside) const {
    return colours_[inside][incidence];
  }

 private:
  Colour colours_[2][incidence_codes] = {};
};

constexpr std::uint32_t no_polygon = 0xFFFFFFFFu;

struct Sample {
  float nearness = -std::numeric_limits<float>::infinity();
  std::uint32_t polygon = no_polygon;
  Incidence incidence = no_incidence;
  bool inside = false;
};

// Fills plane polygons of any shape, one sample row after another, and keeps what is nearest.
class Canvas {
 public:
  Canvas(int width, int height)
      : width_(width),
        height_(height),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

  const Sample& at(int x, int y) const { return samples_[place(x, y)]; }

  void fill(const std::vector<Projected>& outline, Sample sample) {
    // Newell's normal of the picture's polygon: exact enough also when corners are collinear.
    double nx = 0, ny = 0, nz = 0;
    const Projected& o = outline[0];
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
      const Projected &a = outline[i], &b = outline[i + 1];
      nx += (a.y - o.y) * (b.nearness - o.nearness) - (a.nearness - o.nearness) * (b.y - o.y);
      ny += (a.nearness - o.nearness) * (b.x - o.x) - (a.x - o.x) * (b.nearness - o.nearness);
      nz += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    }
    if (std::abs(nz) < 1e-9) return;  // seen edge-on
    sample.inside = nz > 0;           // y points downwards
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

  // The first sample whose centre is not before `edge`; the first one if that is not a number.
  static int first_sample(double edge, int count) {
    const double place = std::ceil(edge - 0.5);
    return place > 0 ? static_cast<int>(std::min(place, static_cast<double>(count))) : 0;
  }

  // Where the outline crosses the middle of sample rows, sorted: pairs bound what is inside.
  void find_crossings(const std::vector<Projected>& outline) {
    crossings_.clear();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      Projected a = outline[i], b = outline[i + 1 < outline.size() ? i + 1 : 0];
      if (a.y > b.y) std::swap(a, b);  // both neighbours of an edge must find the same place
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

// An outline runs where a sample and the next one belong to different polygons, so nothing that
// is hidden can shine through.
bool on_outline(const Canvas& canvas, int x, int y, int width, int height) {
  const std::uint32_t polygon = canvas.at(x, y).polygon;
  return (x + 1 < width && canvas.at(x + 1, y).polygon != polygon) ||
         (y + 1 < height && canvas.at(x, y + 1).polygon != polygon);
}

Picture develop(const Canvas& canvas, const Palette& palette, const PictureOptions& options) {
  std::vector<std::uint8_t> to_srgb(4096);
  for (std::size_t i = 0; i < to_srgb.size(); ++i)
    to_srgb[i] = srgb(static_cast<float>(i) / static_cast<float>(to_srgb.size() - 1));
  const int width = options.width * samples_per_side, height = options.height * samples_per_side;
  Picture picture{options.width, options.height, {}};
  for (int row = 0; row < options.height; ++row) {
    const float background = 0.90f - 0.50f * static_cast<float>(row) / static_cast<float>(height);
    for (int column = 0; column < options.width; ++column) {
      Colour sum{};
      for (int i = 0; i < samples_per_side * samples_per_side; ++i) {
        const int x = column * samples_per_side + i % samples_per_side;
        const int y = row * samples_per_side + i / samples_per_side;
        const Sample& sample = canvas.at(x, y);
        Colour colour = {background, background, background};
        if (sample.polygon != no_polygon) colour = palette.colour(sample.incidence, sample.inside);
        const bool dark = options.outlines && on_outline(canvas, x, y, width, height);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colour[c] * (dark ? outline_light : 1);
      }
      for (const float light : sum) {
        const float mean = std::min(light / (samples_per_side * samples_per_side), 1.0f);
        picture.pixels.push_back(to_srgb[static_cast<std::size_t>(mean * 4095 + 0.5f)]);
      }
    }
  }
  return picture;
}

}  // namespace

Picture draw(const Mesh& mesh, const PictureOptions& options) {
  constexpr int largest = 8192;
  if (options.width < 1 || options.height < 1 || options.width > largest ||
      options.height > largest)
    throw std::invalid_argument("picture size out of range");
  const Axes axes = axes_of(options);
  Canvas canvas(options.width * samples_per_side, options.height * samples_per_side);
  const std::vector<Projected> vertices = project(mesh, axes, options);
  std::vector<Projected> outline;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    outline.clear();
    for (std::size_t i = 0; i < mesh.face_size(face); ++i)
      outline.push_back(vertices[mesh.face(face)[i]]);
    if (outline.empty()) continue;
    Sample sample;
    sample.polygon = mesh.polygons[face];
    sample.incidence = mesh.incidences[face];
    canvas.fill(outline, sample);
  }
  return develop(canvas, Palette(mesh, axes, options), options);
}

void write_picture(const Mesh& mesh, const PictureOptions& options,
                   const std::filesystem::path& path) {
  const Picture picture = draw(mesh, options);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  // Not png_image_write_to_file(): when that fails it removes whatever has the name.
  png_alloc_size_t count = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<char> bytes(count);
  if (png_image_write_to_memory(&image, bytes.data(), &count, 0, picture.pixels.data(), 0,
                                nullptr) == 0)
    throw std::runtime_error(path.string() + ": " + image.message);
  OutputFile file(path);
  file.stream().write(bytes.data(), static_cast<std::streamsize>(count));
  file.commit();
}

}  // namespace discmc::host

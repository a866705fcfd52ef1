#include "pictures/picture.hpp"

#include <png.h>

#include <sstream>
#include <stdexcept>

#include "hand_made.hpp"
#include "meshes/surface_normals.hpp"
#include "sample_reader.hpp"
#include "test.hpp"

namespace {

using namespace discmc::command;
using namespace hand_made;

using Pixel = std::array<int, 3>;

Pixel pixel(const Picture& picture, int x, int y) {
  const auto place = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.pixels[place], picture.pixels[place + 1], picture.pixels[place + 2]};
}

bool is_background(const Pixel& pixel) {
  return pixel[0] == pixel[1] && pixel[1] == pixel[2];
}
int brightness(const Pixel& pixel) {
  return pixel[0] + pixel[1] + pixel[2];
}

PictureOptions from_above(int size) {
  PictureOptions options;
  options.width = options.height = size;
  options.from = {0, 0, 2};
  options.up = {0, 1, 0};
  options.projection = Projection::orthographic;
  return options;
}

bool is_outside(const Pixel& pixel) {
  return pixel[0] > pixel[2];  // the inside is bluish
}

// Valid for both kinds of shading.
FaceMesh with_normals(FaceMesh mesh) {
  mesh.normals = surface_normals(mesh);
  return mesh;
}

const Point signs_of_axes[] = {{1, 1, 1},   {-1, 1, 1},  {1, -1, 1},  {1, 1, -1},
                               {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}};

FaceMesh ball_mesh(const Point& spacing_mm = {1, 1, 1}) {
  const auto volume = discmc::reference::ball({32, 32, 32}, {31, 31, 31}, 196);
  return with_normals(sample_reader::merged_mesh(volume, Faces::triangles, spacing_mm));
}

Picture from_side(const FaceMesh& mesh, const Point& from, Shading shading, int size = 96) {
  PictureOptions options;
  options.width = options.height = size;
  options.from = from;
  options.projection = Projection::orthographic;
  options.shading = shading;
  return draw(mesh, options);
}

int max_difference(const Picture& a, const Picture& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    largest = std::max(largest, std::abs(a.pixels[i] - b.pixels.at(i)));
  return largest;
}

// The ball with the normals of the sphere.
FaceMesh with_radii(FaceMesh mesh, const Point& signs) {
  const Point centre = {15.5 * signs[0], 15.5 * signs[1], 15.5 * signs[2]};
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    mesh.normals[i] = unit_or_zero(difference(mesh.vertices_mm[i], centre));
  return mesh;
}

// From the lower right of a ball, which the light does not reach, to its brightest point.
void check_brighter_towards_light(const Picture& picture, int tolerance) {
  int before = 0;
  for (double way = 38; way > -18; way -= 4) {
    const int x = static_cast<int>(48 + 0.65 * way), y = static_cast<int>(48 + 0.76 * way);
    const int here = brightness(pixel(picture, x, y));
    CHECK(here > before - tolerance);
    before = std::max(before, here);
  }
  CHECK(before > brightness(pixel(picture, 72, 76)) + 200);
}

// A wall of two triangles from the viewer's feet into the distance, and the normals of its near and
// far side.
FaceMesh long_wall(const Point& near, const Point& far) {
  FaceMesh mesh =
      triangles_of({{-5, 0, 0}, {5, 0, 0}, {5, 40, 0}, {-5, 40, 0}}, {0, 1, 2, 0, 2, 3});
  mesh.polygons = {0, 0};
  mesh.normals = {near, near, far, far};
  return mesh;
}

}  // namespace

TEST_CASE("an octahedron seen from above is drawn as a square on its tip that fills the picture") {
  const Picture picture = draw(build_mesh(octahedron()), from_above(100));
  REQUIRE(picture.pixels.size() == 3 * 100 * 100);
  for (const int near : {8, 91}) {
    CHECK_FALSE(is_background(pixel(picture, near, 50)));
    CHECK_FALSE(is_background(pixel(picture, 50, near)));
    CHECK(is_background(pixel(picture, near, 20)));
    CHECK(is_background(pixel(picture, 20, near)));
  }
  for (const int outside : {2, 97}) {
    CHECK(is_background(pixel(picture, outside, 50)));
    CHECK(is_background(pixel(picture, 50, outside)));
  }
  // The key light comes from the upper left.
  CHECK(brightness(pixel(picture, 30, 40)) > brightness(pixel(picture, 70, 40)));
  CHECK(brightness(pixel(picture, 30, 40)) > brightness(pixel(picture, 30, 60)));
}

TEST_CASE("drawing a plane polygon of any shape fills exactly the pixels inside") {
  // The roof of the leaning wall is an L, with its notch at the lower right.
  Surface surface = leaning_wall();
  surface.polygons = only(surface.polygons, {4});
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    PictureOptions options = from_above(64);
    options.projection = projection;
    const Picture whole = draw(build_mesh(surface, {true, Faces::polygons}), options);
    CHECK_FALSE(is_background(pixel(whole, 20, 20)));
    CHECK_FALSE(is_background(pixel(whole, 20, 44)));
    CHECK_FALSE(is_background(pixel(whole, 44, 20)));
    CHECK(is_background(pixel(whole, 44, 44)));
    const Picture parts = draw(build_mesh(surface, {true, Faces::triangles}), options);
    CHECK(whole.pixels == parts.pixels);
  }
}

TEST_CASE("near faces hide far ones, in any order of the faces") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    PictureOptions options = from_above(80);
    options.from = {-1, -1.5, 1.2};
    options.up = {0, 0, 1};
    options.projection = projection;
    Surface surface = box_with_hole();
    const Picture picture = draw(build_mesh(surface), options);
    surface.polygons = only(surface.polygons, {9, 8, 7, 6, 5, 4, 3, 2, 1, 0});
    CHECK(draw(build_mesh(surface), options).pixels == picture.pixels);
    // The inside of a closed surface is never visible. Without the walls that face away, the
    // picture stays the same.
    Surface seen = surface;
    seen.polygons = {};
    for (const Polygon& polygon : surface.polygons) {
      const Vertex n = discmc::incidence_normal(polygon.incidence);
      if (-n.x - n.y + n.z > 0) seen.polygons.push_back(polygon);
    }
    REQUIRE(seen.polygons.size() == 5);
    CHECK(draw(build_mesh(seen), options).pixels == picture.pixels);
  }
}

TEST_CASE("the inside of an open mesh is drawn in another tone") {
  Surface surface = box_with_hole();
  surface.polygons = only(surface.polygons, {8});  // the bottom, seen from above
  const Pixel inside = pixel(draw(build_mesh(surface), from_above(64)), 8, 32);
  CHECK(inside[2] > inside[0]);
  surface = box_with_hole();
  const Pixel outside = pixel(draw(build_mesh(surface), from_above(64)), 8, 32);
  CHECK(outside[0] > outside[2]);
}

TEST_CASE("a mirrored axis mirrors the picture and keeps inside and outside") {
  const Picture picture = draw(build_mesh(box_with_hole({1, 1, -1})), from_above(64));
  CHECK(pixel(picture, 8, 32)[0] > pixel(picture, 8, 32)[2]);
  // Light and hole do not move, because the box is symmetric.
  CHECK(picture.pixels == draw(build_mesh(box_with_hole()), from_above(64)).pixels);
}

TEST_CASE(
    "outlines are drawn along polygons, not along their triangles, in flat and smooth shading") {
  const FaceMesh mesh = with_normals(build_mesh(box_with_hole(), {true, Faces::triangles}));
  for (const Shading shading : {Shading::flat, Shading::smooth}) {
    PictureOptions options = from_above(64);
    options.shading = shading;
    const Picture plain = draw(mesh, options);
    options.draws_outlines = true;
    const Picture lined = draw(mesh, options);
    int darker = 0;
    for (int x = 0; x < 64; ++x) {
      const int before = brightness(pixel(plain, x, 10));
      const int after = brightness(pixel(lined, x, 10));
      CHECK(after <= before);
      if (after < before) ++darker;
    }
    CHECK(darker >= 2);  // the two sides of the top, and no diagonal between them
    CHECK(darker <= 4);
  }
}

TEST_CASE("a ball is covered from all sides, and its inside is not visible") {
  const Point sides[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0},    {0, -1, 0},
                         {0, 0, 1}, {0, 0, -1}, {1, -2, 0.7}, {-1, -1, -1}};
  for (const Point& signs : signs_of_axes) {
    const FaceMesh mesh = ball_mesh(signs);
    for (const Point& side : sides)
      for (const Shading shading : {Shading::flat, Shading::smooth}) {
        const Picture picture = from_side(mesh, side, shading);
        int uncovered = 0, inside = 0, beyond = 0;
        for (int y = 0; y < 96; ++y)
          for (int x = 0; x < 96; ++x) {
            const Pixel here = pixel(picture, x, y);
            const double distance = std::hypot(x - 47.5, y - 47.5);
            if (distance < 41) uncovered += is_background(here);
            if (distance > 46) beyond += !is_background(here);
            inside += !is_background(here) && !is_outside(here);
          }
        CHECK(uncovered == 0);
        CHECK(inside == 0);
        CHECK(beyond == 0);
      }
  }
}

TEST_CASE("a smooth ball grows brighter towards the light, for axes in either direction") {
  for (const Point& signs : signs_of_axes) {
    const FaceMesh mesh = ball_mesh(signs);
    const FaceMesh exact = with_radii(mesh, signs);
    for (const Point& side : {Point{1, 0, 0}, {0, 0, -1}, {-1, -1.5, 0.8}}) {
      check_brighter_towards_light(from_side(exact, side, Shading::smooth), 3);
      check_brighter_towards_light(from_side(mesh, side, Shading::smooth), 40);
    }
  }
}

TEST_CASE("smooth shading of a ball depends on the vertex normals, not on the faces") {
  const FaceMesh mesh = with_radii(ball_mesh(), {1, 1, 1});
  const Picture smooth = from_side(mesh, {0, 0, 1}, Shading::smooth, 200);
  const Picture flat = from_side(mesh, {0, 0, 1}, Shading::flat, 200);
  int smooth_steps = 0, flat_steps = 0;  // the maximum between neighbouring pixels
  for (int y = 30; y < 170; ++y)
    for (int x = 30; x < 170; ++x) {
      const auto step = [x, y](const Picture& picture) {
        return std::abs(brightness(pixel(picture, x, y)) - brightness(pixel(picture, x + 1, y)));
      };
      if (std::hypot(x - 100, y - 100) > 80) continue;
      smooth_steps = std::max(smooth_steps, step(smooth));
      flat_steps = std::max(flat_steps, step(flat));
    }
  CHECK(smooth_steps < 20);
  CHECK(flat_steps > 100);
}

TEST_CASE("smooth shading keeps plane walls uniform and rounds their edges") {
  const auto volume = discmc::reference::box({26, 26, 26}, {3, 3, 3}, {22, 22, 22});
  const FaceMesh mesh = with_normals(sample_reader::merged_mesh(volume, Faces::triangles));
  const Picture flat = from_side(mesh, {-1, -1.5, 0.8}, Shading::flat);
  const Picture smooth = from_side(mesh, {-1, -1.5, 0.8}, Shading::smooth);
  int same = 0, covered = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) {
      const Pixel here = pixel(smooth, x, y);
      if (is_background(here)) continue;
      ++covered;
      same += std::abs(brightness(here) - brightness(pixel(flat, x, y))) < 30;
    }
  CHECK(same > covered * 9 / 10);
  CHECK(same < covered);
}

TEST_CASE("smooth shading uses the face normal if the vertex normal deviates too far") {
  FaceMesh mesh = build_mesh(box_with_hole(), {true, Faces::triangles});
  mesh.normals.assign(mesh.vertices_mm.size(), {0, 0, 1});  // as at the border of a volume
  const Point side = {-1, -1.5, 0.8};
  const Picture flat = from_side(mesh, side, Shading::flat);
  CHECK(max_difference(from_side(mesh, side, Shading::smooth), flat) <= 1);
  mesh.normals.assign(mesh.vertices_mm.size(), {});  // no such edge
  CHECK(max_difference(from_side(mesh, side, Shading::smooth), flat) <= 1);
  mesh.normals.assign(mesh.vertices_mm.size(), unit_or_zero({-1, -1, 1}));
  CHECK(max_difference(from_side(mesh, side, Shading::smooth), flat) > 20);
}

TEST_CASE("smooth shading interpolates normals in space, not in the picture") {
  const Point near = unit_or_zero({0, -1, 0.8}), far = unit_or_zero({0, 1, 0.8}), up = {0, 0, 1};
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    PictureOptions options;
    options.width = options.height = 65;
    options.from = {0, -1, 0.3};
    options.projection = projection;
    options.shading = Shading::smooth;
    options.zoom = 4;
    options.at = Point{0, 20, 0};  // halfway along the wall
    const Pixel middle = pixel(draw(long_wall(near, far), options), 32, 32);
    const Pixel expected = pixel(draw(long_wall(up, up), options), 32, 32);
    REQUIRE(!is_background(middle));
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(middle[i] - expected[i]) <= 2);
    options.at = Point{0, 10, 0};  // a visible change
    CHECK(pixel(draw(long_wall(near, far), options), 32, 32) != expected);
  }
}

TEST_CASE("zoom enlarges the picture around its middle or around a given point") {
  PictureOptions options = from_above(100);
  options.zoom = 0.5;
  const FaceMesh mesh = build_mesh(octahedron());
  const Picture far = draw(mesh, options);
  CHECK_FALSE(is_background(pixel(far, 30, 50)));
  CHECK(is_background(pixel(far, 24, 50)));
  options.zoom = 10;
  const Picture near = draw(mesh, options);
  for (const int x : {0, 99})
    for (const int y : {0, 99}) CHECK_FALSE(is_background(pixel(near, x, y)));
  options.at = Point{1, 0, 0};  // its right tip
  const Picture tip = draw(mesh, options);
  CHECK_FALSE(is_background(pixel(tip, 47, 50)));
  CHECK(is_background(pixel(tip, 53, 50)));
  CHECK(is_background(pixel(tip, 53, 0)));
  CHECK(is_background(pixel(tip, 20, 10)));
}

TEST_CASE("drawing refuses invalid options, and draws an empty mesh as an empty picture") {
  PictureOptions options = from_above(16);
  const FaceMesh nothing = build_mesh({{1, 1, 1}, {}});
  const Picture picture = draw(nothing, options);
  for (int i = 0; i < 16; ++i) CHECK(is_background(pixel(picture, i, i)));
  const auto check_wrong = [&](const auto& change) {
    PictureOptions wrong = from_above(16);
    change(wrong);
    CHECK_THROWS_AS(draw(nothing, wrong), std::invalid_argument);
  };
  for (const int width : {0, 8193})
    check_wrong([&](PictureOptions& wrong) { wrong.width = width; });
  for (const double zoom : {0.0, -1.0, 1001.0, std::nan("")})
    check_wrong([&](PictureOptions& wrong) { wrong.zoom = zoom; });
  check_wrong([](PictureOptions& wrong) { wrong.from = {0, 0, 0}; });
  options.shading = Shading::smooth;
  CHECK_THROWS_AS(draw(build_mesh(octahedron()), options), std::invalid_argument);
  CHECK_THROWS_AS(draw(with_normals(build_mesh(leaning_wall())), options), std::invalid_argument);
  CHECK(draw(nothing, options).pixels == picture.pixels);
  options.projection = Projection::perspective;
  options.shading = Shading::flat;
  options.at = Point{0, 0, 100};
  CHECK_THROWS_AS(draw(build_mesh(octahedron()), options), std::invalid_argument);
  CHECK(draw(nothing, options).pixels == picture.pixels);
  options = from_above(16);
  options.up = options.from;  // no reason to fail
  CHECK_FALSE(is_background(pixel(draw(build_mesh(octahedron()), options), 8, 8)));
}

TEST_CASE("a written PNG file reads back as the same picture") {
  PictureOptions options = from_above(40);
  options.height = 24;
  const FaceMesh mesh = build_mesh(octahedron());
  std::ostringstream out;
  write_picture(draw(mesh, options), out);
  const std::string file = out.str();
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_memory(&image, file.data(), file.size()) != 0);
  image.format = PNG_FORMAT_RGB;
  CHECK(image.width == 40);
  CHECK(image.height == 24);
  std::vector<std::uint8_t> pixels(3 * 40 * 24);
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  CHECK(pixels == draw(mesh, options).pixels);
}

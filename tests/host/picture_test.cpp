#include "picture.hpp"

#include <doctest/doctest.h>
#include <png.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "hand_made.hpp"

namespace {

using namespace discmc::host;
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

// Removes its file also when a check fails.
struct TemporaryFile {
  std::filesystem::path path;
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
  }
};

}  // namespace

TEST_CASE("an octahedron from above is a square on its tip that fills the picture") {
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

TEST_CASE("a plane polygon of any shape is filled, and nothing else") {
  // The roof of the leaning wall is an L: its notch is at the lower right.
  Surface surface = leaning_wall();
  surface.polygons = {surface.polygons[4]};
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

TEST_CASE("what is nearer hides what is farther, whatever the order of the faces") {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    PictureOptions options = from_above(80);
    options.from = {-1, -1.5, 1.2};
    options.up = {0, 0, 1};
    options.projection = projection;
    Surface surface = box_with_hole();
    const Picture picture = draw(build_mesh(surface), options);
    std::reverse(surface.polygons.begin(), surface.polygons.end());
    CHECK(draw(build_mesh(surface), options).pixels == picture.pixels);
    // Of a closed surface the inside is never seen: without the walls that look away, the
    // picture stays the same.
    Surface seen = surface;
    seen.polygons.clear();
    for (const Polygon& polygon : surface.polygons) {
      const Vertex n = discmc::normal(polygon.incidence);
      if (-n.x - n.y + n.z > 0) seen.polygons.push_back(polygon);
    }
    REQUIRE(seen.polygons.size() == 5);
    CHECK(draw(build_mesh(seen), options).pixels == picture.pixels);
  }
}

TEST_CASE("the inside of an open mesh has a tone of its own") {
  Surface surface = box_with_hole();
  surface.polygons = {surface.polygons[8]};  // the bottom, seen from above
  const Pixel inside = pixel(draw(build_mesh(surface), from_above(64)), 8, 32);
  CHECK(inside[2] > inside[0]);
  surface = box_with_hole();
  const Pixel outside = pixel(draw(build_mesh(surface), from_above(64)), 8, 32);
  CHECK(outside[0] > outside[2]);
}

TEST_CASE("a mirrored axis mirrors the picture but not inside and outside") {
  const Picture picture = draw(build_mesh(box_with_hole({1, 1, -1})), from_above(64));
  CHECK(pixel(picture, 8, 32)[0] > pixel(picture, 8, 32)[2]);
  // Light and hole are where they were: the box is symmetric.
  CHECK(picture.pixels == draw(build_mesh(box_with_hole()), from_above(64)).pixels);
}

TEST_CASE("outlines follow the polygons and not their triangles") {
  PictureOptions options = from_above(64);
  const Mesh mesh = build_mesh(box_with_hole(), {true, Faces::triangles});
  const Picture plain = draw(mesh, options);
  options.outlines = true;
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

TEST_CASE("wrong options are refused, and an empty mesh is an empty picture") {
  PictureOptions options = from_above(16);
  const Mesh nothing = build_mesh({{1, 1, 1}, {}});
  const Picture picture = draw(nothing, options);
  for (int i = 0; i < 16; ++i) CHECK(is_background(pixel(picture, i, i)));
  options.width = 0;
  CHECK_THROWS_AS(draw(nothing, options), std::invalid_argument);
  options.width = 8193;
  CHECK_THROWS_AS(draw(nothing, options), std::invalid_argument);
  options = from_above(16);
  options.from = {0, 0, 0};
  CHECK_THROWS_AS(draw(nothing, options), std::invalid_argument);
  options = from_above(16);
  options.up = options.from;  // no reason to fail
  CHECK_FALSE(is_background(pixel(draw(build_mesh(octahedron()), options), 8, 8)));
}

TEST_CASE("a picture file holds the picture") {
  const TemporaryFile file{std::filesystem::temp_directory_path() / "discmc_picture_test.png"};
  PictureOptions options = from_above(40);
  options.height = 24;
  const Mesh mesh = build_mesh(octahedron());
  write_picture(mesh, options, file.path);
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, file.path.c_str()) != 0);
  image.format = PNG_FORMAT_RGB;
  CHECK(image.width == 40);
  CHECK(image.height == 24);
  std::vector<std::uint8_t> pixels(3 * 40 * 24);
  REQUIRE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr) != 0);
  CHECK(pixels == draw(mesh, options).pixels);

  const std::filesystem::path nowhere = file.path / "no" / "such" / "folder.png";
  CHECK_THROWS_AS(write_picture(mesh, options, nowhere), std::runtime_error);
}

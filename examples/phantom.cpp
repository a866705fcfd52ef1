// Writes a volume to try things on: a head made of ellipsoids, with a skull that has holes.
//
//   phantom head.raw
//   discmc extract head.raw --dims 256,256,108 --type i16 --spacing 0.957,-0.957,1.5 --iso 300 ...
//
// 108 slices of 256 x 256 samples, signed 16 bits, little-endian, no header. The values are
// Hounsfield units as in a CT scan: -1000 is air, 40 soft tissue, 1000 bone. The rows run from the
// back of the head to the face, hence the minus.
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <vector>

namespace {

constexpr int width = 256, height = 256, depth = 108;
constexpr double spacing_xy = 0.957, spacing_z = 1.5;

constexpr std::int16_t air = -1000, tissue = 40, bone = 1000;

// Millimetres from the centre of the volume: x to the left ear, y to the face, z up.
struct Point {
  double x, y, z;
};

struct Ellipsoid {
  Point centre, radius;

  bool holds(Point p) const {
    const double x = (p.x - centre.x) / radius.x;
    const double y = (p.y - centre.y) / radius.y;
    const double z = (p.z - centre.z) / radius.z;
    return x * x + y * y + z * z <= 1;
  }
};

constexpr Ellipsoid skin{{0, 0, 0}, {82, 104, 78}};
constexpr Ellipsoid skull{{0, -2, 0}, {74, 94, 71}};
constexpr Ellipsoid brain{{0, -4, 2}, {68, 86, 64}};

// Where the skull is open: eyes, nose, ears and the way of the spinal cord.
constexpr Ellipsoid openings[] = {
    {{-32, 84, -10}, {19, 26, 16}}, {{32, 84, -10}, {19, 26, 16}}, {{0, 88, -38}, {11, 26, 17}},
    {{-72, -8, -24}, {16, 5, 5}},   {{72, -8, -24}, {16, 5, 5}},   {{0, -26, -68}, {16, 18, 20}},
};

std::int16_t value_at(Point p) {
  if (!skin.holds(p)) return air;
  if (!skull.holds(p) || brain.holds(p)) return tissue;
  for (const Ellipsoid& opening : openings)
    if (opening.holds(p)) return tissue;
  return bone;
}

// The bytes of a slice, low byte first whatever the machine.
std::vector<char> slice_at(int k) {
  std::vector<char> bytes;
  bytes.reserve(std::size_t{2} * width * height);
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      const unsigned value = static_cast<std::uint16_t>(
          value_at({(i - width / 2) * spacing_xy, (j - height / 2) * spacing_xy,
                    (k - depth / 2) * spacing_z}));
      bytes.push_back(static_cast<char>(value & 0xFF));
      bytes.push_back(static_cast<char>(value >> 8));
    }
  }
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: phantom FILE\n", stderr);
    return 2;
  }
  std::ofstream file(arguments[1], std::ios::binary);
  for (int k = 0; k < depth; ++k) {
    const std::vector<char> bytes = slice_at(k);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  }
  file.close();
  if (!file) {
    std::fprintf(stderr, "cannot write %s\n", arguments[1]);
    return 1;
  }
  std::printf("%s: %d x %d x %d samples of 16 bits\n", arguments[1], width, height, depth);
}

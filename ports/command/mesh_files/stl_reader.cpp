#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "mesh_input.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::host {
namespace {

constexpr std::size_t stl_head = 84, stl_triangle = 50;

void add_triangle(MeshInput& input) {
  const auto end = static_cast<std::uint32_t>(input.vertex_count());
  input.add_face({end - 3, end - 2, end - 1});
}

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
  return value;
}

void read_binary_stl(MeshInput& input, std::uint32_t count) {
  const char* at = input.bytes().data() + stl_head;
  for (std::uint32_t i = 0; i < count; ++i, at += stl_triangle) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // after the normal
      Point vertex{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t bits = little_endian(at + 12 * corner + 4 * axis);
        float coordinate;
        std::memcpy(&coordinate, &bits, sizeof coordinate);
        vertex[axis] = static_cast<double>(coordinate);
      }
      input.add_vertex(vertex);
    }
    add_triangle(input);
  }
}

void read_text_stl(MeshInput& input) {
  std::string_view rest = input.bytes();
  bool is_whole = false;
  int corners = 0;
  while (const auto line = take_line(rest)) {
    const auto word = words(*line);
    if (word.empty()) continue;
    is_whole = word[0] == "endsolid";
    if (word[0] == "vertex") {
      Point vertex{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto number = word.size() == 4 ? number_in<double>(word[axis + 1]) : std::nullopt;
        if (!number) input.refuse("a vertex that is not three numbers: " + shown(*line));
        vertex[axis] = *number;
      }
      input.add_vertex(vertex);
      ++corners;
    } else if (word[0] == "endloop") {
      if (corners != 3)
        input.refuse("a facet of " + std::to_string(corners) + " corners, where STL has triangles");
      add_triangle(input);
      corners = 0;
    }
  }
  if (!is_whole) input.refuse("the STL file does not end with \"endsolid\"");
}

}  // namespace

void read_stl(MeshInput& input) {
  const std::string& bytes = input.bytes();
  const std::uint32_t count =
      bytes.size() >= stl_head ? little_endian(bytes.data() + stl_head - 4) : 0;
  // A binary file may begin with "solid" as text does, but text never fits its count.
  if (bytes.size() >= stl_head && bytes.size() == stl_head + std::uint64_t{stl_triangle} * count)
    return read_binary_stl(input, count);
  if (bytes.rfind("solid", 0) == 0) return read_text_stl(input);
  if (bytes.size() < stl_head) input.refuse("too short for an STL file");
  input.refuse("an STL file of " + std::to_string(count) + " triangles has " +
               std::to_string(stl_head + std::uint64_t{stl_triangle} * count) +
               " bytes, and this one " + std::to_string(bytes.size()));
}

}  // namespace discmc::host

#include "mesh_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

constexpr const char* export_anew = "export it anew";

std::string extension_of(const std::filesystem::path& file) {
  return lower(file.extension().string());
}

// What the readers share: the file's bytes, its name for refusals, and the mesh so far.
class MeshFile {
 public:
  explicit MeshFile(const std::filesystem::path& file) : file_(file) {
    std::ifstream in;
    if (std::filesystem::is_regular_file(file)) in.open(file, std::ios::binary);
    if (!in.is_open()) refuse("cannot be read", "check the name and its permissions");
    bytes_.resize(std::filesystem::file_size(file));
    in.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    bytes_.resize(static_cast<std::size_t>(in.gcount()));
  }

  const std::string& bytes() const { return bytes_; }

  [[noreturn]] void refuse(const std::string& what, const char* remedy = export_anew) const {
    throw std::runtime_error(file_.string() + ": " + what + "; " + remedy);
  }

  void add_vertex(const Point& vertex) {
    constexpr double most = 1e30;  // whose products are numbers still
    for (const double coordinate : vertex)
      if (!(std::abs(coordinate) <= most))
        refuse("vertex " + std::to_string(mesh_.vertices_mm.size() + 1) +
               " has a coordinate that is no number or beyond 1e30");
    if (mesh_.vertices_mm.size() >= 0xFFFFFFFFu) refuse("more than 2^32 vertices", "cut it up");
    mesh_.vertices_mm.push_back(vertex);
  }

  // What has less than three corners is no face.
  void add_face(const std::vector<std::uint32_t>& corners) {
    if (corners.size() < 3) return;
    mesh_.polygons.push_back(static_cast<std::uint32_t>(mesh_.face_count()));
    mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
    mesh_.face_begin.push_back(mesh_.corners.size());
  }

  Mesh& mesh() { return mesh_; }

  Mesh finish() {
    for (std::size_t face = 0; face < mesh_.face_count(); ++face)
      for (std::size_t i = 0; i < mesh_.face_size(face); ++i)
        if (mesh_.face(face)[i] >= mesh_.vertices_mm.size())
          refuse("face " + std::to_string(face + 1) +
                 " names a vertex that is not there: there "
                 "are " +
                 std::to_string(mesh_.vertices_mm.size()));
    if (mesh_.normals.size() != mesh_.vertices_mm.size()) mesh_.normals.clear();
    for (Point& normal : mesh_.normals) normal = unit_or_zero(normal);
    return std::move(mesh_);
  }

 private:
  std::filesystem::path file_;
  std::string bytes_;
  Mesh mesh_;
};

// The number that the whole text is.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// ---- PLY ----

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<PlyType> ply_type(std::string_view name) {
  static const std::unordered_map<std::string_view, PlyType> types = {
      {"char", PlyType::i8},    {"int8", PlyType::i8},     {"uchar", PlyType::u8},
      {"uint8", PlyType::u8},   {"short", PlyType::i16},   {"int16", PlyType::i16},
      {"ushort", PlyType::u16}, {"uint16", PlyType::u16},  {"int", PlyType::i32},
      {"int32", PlyType::i32},  {"uint", PlyType::u32},    {"uint32", PlyType::u32},
      {"float", PlyType::f32},  {"float32", PlyType::f32}, {"double", PlyType::f64},
      {"float64", PlyType::f64}};
  const auto found = types.find(name);
  return found == types.end() ? std::nullopt : std::optional(found->second);
}

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

class PlyReader {
 public:
  explicit PlyReader(MeshFile& file) : file_(file), rest_(file.bytes()) {}

  void read() {
    read_header();
    bool has_faces = false;
    for (const PlyElement& element : elements_) {
      if (element.properties.empty()) continue;
      const bool is_face = element.name == "face";
      has_faces = has_faces || is_face;
      for (std::uint64_t i = 0; i < element.count; ++i) {
        read_item(element);
        if (element.name == "vertex") add_vertex(element);
        if (is_face) file_.add_face(indices_);
      }
    }
    if (!has_faces) file_.refuse("a PLY file without faces");
  }

 private:
  void read_header() {
    if (take_line(rest_) != std::optional<std::string_view>("ply"))
      file_.refuse("no PLY file: its first line is not \"ply\"");
    while (true) {
      const auto line = take_line(rest_);
      if (!line) file_.refuse("the header of the PLY file does not end");
      const auto word = words(*line);
      if (word.empty() || word[0] == "comment" || word[0] == "obj_info") continue;
      if (word[0] == "end_header") return;
      if (!take_header_line(word)) file_.refuse("the PLY header has the line " + shown(*line));
    }
  }

  bool take_header_line(const std::vector<std::string_view>& word) {
    if (word[0] == "format" && word.size() == 3) {
      is_text_ = word[1] == "ascii";
      is_big_endian_ = word[1] == "binary_big_endian";
      return is_text_ || is_big_endian_ || word[1] == "binary_little_endian";
    }
    if (word[0] == "element" && word.size() == 3) {
      const auto count = number_in<std::uint64_t>(word[2]);
      if (count) elements_.push_back({std::string(word[1]), *count, {}});
      return count.has_value();
    }
    const bool is_list = word.size() == 5 && word[1] == "list";
    if (word[0] != "property" || !(is_list || word.size() == 3) || elements_.empty()) return false;
    const auto type = ply_type(word[word.size() - 2]);
    const auto count_type = is_list ? ply_type(word[2]) : std::nullopt;
    if (!type || (is_list && !count_type)) return false;
    elements_.back().properties.push_back({std::string(word.back()), *type, count_type});
    return true;
  }

  void read_item(const PlyElement& element) {
    values_.clear();
    indices_.clear();
    for (const PlyProperty& property : element.properties) {
      if (!property.count_type) {
        values_.push_back(value(property.type));
        continue;
      }
      values_.push_back(0);
      const bool is_face = property.name == "vertex_indices" || property.name == "vertex_index";
      const double count = value(*property.count_type);
      for (double i = 0; i < count; ++i) {
        const double number = value(property.type);
        if (!is_face) continue;
        // What is no index becomes one that no vertex has.
        const bool is_index = number >= 0 && number < 0xFFFFFFFFu;
        indices_.push_back(is_index ? static_cast<std::uint32_t>(number) : 0xFFFFFFFFu);
      }
    }
  }

  void add_vertex(const PlyElement& element) {
    const auto position = vector_of(element, {"x", "y", "z"});
    if (!position) file_.refuse("vertices of a PLY file without x, y and z");
    file_.add_vertex(*position);
    if (const auto normal = vector_of(element, {"nx", "ny", "nz"}))
      file_.mesh().normals.push_back(*normal);
  }

  std::optional<Point> vector_of(const PlyElement& element,
                                 const std::array<const char*, 3>& names) const {
    Point result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::size_t i = 0;
      while (i < values_.size() && element.properties[i].name != names[axis]) ++i;
      if (i == values_.size()) return std::nullopt;
      result[axis] = values_[i];
    }
    return result;
  }

  double value(PlyType type) {
    if (is_text_) return text_value();
    switch (type) {
      case PlyType::i8:
        return binary_value<std::int8_t>();
      case PlyType::u8:
        return binary_value<std::uint8_t>();
      case PlyType::i16:
        return binary_value<std::int16_t>();
      case PlyType::u16:
        return binary_value<std::uint16_t>();
      case PlyType::i32:
        return binary_value<std::int32_t>();
      case PlyType::u32:
        return binary_value<std::uint32_t>();
      case PlyType::f32:
        return static_cast<double>(binary_value<float>());
      case PlyType::f64:
        break;
    }
    return binary_value<double>();
  }

  double text_value() {
    const std::size_t begin = std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size());
    const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    if (word.empty()) fail_early();
    const auto number = number_in<double>(word);
    if (!number) file_.refuse(shown(word) + " is no number");
    return *number;
  }

  template <typename Value>
  Value binary_value() {
    char bytes[sizeof(Value)];
    if (rest_.size() < sizeof bytes) fail_early();
    rest_.copy(bytes, sizeof bytes);
    rest_.remove_prefix(sizeof bytes);
    if (is_big_endian_ != (__BYTE_ORDER__ == __ORDER_BIG_ENDIAN__))
      std::reverse(bytes, bytes + sizeof bytes);
    Value value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }

  [[noreturn]] void fail_early() const {
    file_.refuse("the PLY file ends before the " + std::to_string(elements_.size()) +
                 " kinds of elements that its header counts");
  }

  MeshFile& file_;
  std::string_view rest_;
  bool is_text_ = false;
  bool is_big_endian_ = false;
  std::vector<PlyElement> elements_;
  std::vector<double> values_;          // of one item, one a property
  std::vector<std::uint32_t> indices_;  // of one face
};

// ---- OBJ ----

class ObjReader {
 public:
  explicit ObjReader(MeshFile& file) : file_(file) {}

  void read() {
    std::string_view rest = file_.bytes();
    while (const auto line = take_line(rest)) {
      ++line_;
      const auto word = words(*line);
      if (word.empty()) continue;
      if (word[0] == "v") positions_.push_back(vector_of(word));
      if (word[0] == "vn") normals_.push_back(vector_of(word));
      if (word[0] == "f") read_face(word);
    }
    // Faces may come before their vertices.
    for (const auto& [position, normal] : vertices_) {
      if (position >= positions_.size())
        file_.refuse("a face names vertex " + std::to_string(std::uint64_t{position} + 1) +
                     ", and there are " + std::to_string(positions_.size()));
      file_.add_vertex(positions_[position]);
      if (!has_normals_) continue;
      file_.mesh().normals.push_back(normal < normals_.size() ? normals_[normal] : Point{});
    }
  }

 private:
  // Where faces give a vertex several normals, it becomes several vertices.
  using Corner = std::pair<std::uint32_t, std::uint32_t>;
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  Point vector_of(const std::vector<std::string_view>& word) const {
    Point result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto number = axis + 1 < word.size() ? number_in<double>(word[axis + 1]) : std::nullopt;
      if (!number) fail(std::string(word[0]), "has not three numbers");
      result[axis] = *number;
    }
    return result;
  }

  // "position", "position/texture", "position//normal" or "position/texture/normal".
  void read_face(const std::vector<std::string_view>& word) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 1; i < word.size(); ++i) {
      const std::size_t slash = word[i].find('/');
      const std::size_t last = word[i].rfind('/');
      const std::uint32_t position = index(word[i].substr(0, slash), positions_.size());
      const bool has_normal = last != slash;
      const std::uint32_t normal =
          has_normal ? index(word[i].substr(last + 1), normals_.size()) : none;
      has_normals_ = has_normals_ || has_normal;
      corners.push_back(vertex_of({position, normal}));
    }
    file_.add_face(corners);
  }

  // Numbers count from 1, negative ones back from the last so far.
  std::uint32_t index(std::string_view text, std::size_t so_far) const {
    const auto number = number_in<std::int64_t>(text);
    const std::int64_t count = static_cast<std::int64_t>(so_far);
    const std::int64_t place = !number ? -1 : *number < 0 ? *number + count : *number - 1;
    if (!number || place < 0 || place >= std::int64_t{none})
      fail(shown(text), "is no number of a vertex");
    return static_cast<std::uint32_t>(place);
  }

  std::uint32_t vertex_of(const Corner& corner) {
    const std::uint64_t key = std::uint64_t{corner.first} << 32 | corner.second;
    const auto next = static_cast<std::uint32_t>(vertices_.size());
    const auto [entry, is_new] = numbers_.try_emplace(key, next);
    if (is_new) vertices_.push_back(corner);
    return entry->second;
  }

  [[noreturn]] void fail(const std::string& what, const char* fault) const {
    file_.refuse("line " + std::to_string(line_) + ": " + what + " " + fault);
  }

  MeshFile& file_;
  std::uint64_t line_ = 0;
  std::vector<Point> positions_, normals_;
  bool has_normals_ = false;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<Corner> vertices_;
};

// ---- STL ----

constexpr std::size_t stl_head = 84, stl_triangle = 50;

void add_triangle(MeshFile& file) {
  const auto end = static_cast<std::uint32_t>(file.mesh().vertices_mm.size());
  file.add_face({end - 3, end - 2, end - 1});
}

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << 8 * i;
  return value;
}

void read_binary_stl(MeshFile& file, std::uint32_t count) {
  const char* at = file.bytes().data() + stl_head;
  for (std::uint32_t i = 0; i < count; ++i, at += stl_triangle) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {  // after the normal
      Point vertex{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t bits = little_endian(at + 12 * corner + 4 * axis);
        float coordinate;
        std::memcpy(&coordinate, &bits, sizeof coordinate);
        vertex[axis] = static_cast<double>(coordinate);
      }
      file.add_vertex(vertex);
    }
    add_triangle(file);
  }
}

void read_text_stl(MeshFile& file) {
  std::string_view rest = file.bytes();
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
        if (!number) file.refuse("a vertex that is not three numbers: " + shown(*line));
        vertex[axis] = *number;
      }
      file.add_vertex(vertex);
      ++corners;
    } else if (word[0] == "endloop") {
      if (corners != 3)
        file.refuse("a facet of " + std::to_string(corners) + " corners, where STL has triangles");
      add_triangle(file);
      corners = 0;
    }
  }
  if (!is_whole) file.refuse("the STL file does not end with \"endsolid\"");
}

void read_stl(MeshFile& file) {
  const std::string& bytes = file.bytes();
  const std::uint32_t count =
      bytes.size() >= stl_head ? little_endian(bytes.data() + stl_head - 4) : 0;
  // Text too may begin with the eighty bytes of a binary file, but never fits their count.
  if (bytes.size() >= stl_head && bytes.size() == stl_head + std::uint64_t{stl_triangle} * count)
    return read_binary_stl(file, count);
  if (bytes.rfind("solid", 0) == 0) return read_text_stl(file);
  if (bytes.size() < stl_head) file.refuse("too short for an STL file");
  file.refuse("an STL file of " + std::to_string(count) + " triangles has " +
              std::to_string(stl_head + std::uint64_t{stl_triangle} * count) +
              " bytes, and this one " + std::to_string(bytes.size()));
}

}  // namespace

bool is_mesh_name(const std::filesystem::path& file) {
  const std::string extension = extension_of(file);
  return extension == ".ply" || extension == ".obj" || extension == ".stl";
}

Mesh read_mesh(const std::filesystem::path& path) {
  MeshFile file(path);
  const std::string extension = extension_of(path);
  if (extension == ".ply")
    PlyReader(file).read();
  else if (extension == ".obj")
    ObjReader(file).read();
  else
    read_stl(file);
  return file.finish();
}

}  // namespace discmc::host

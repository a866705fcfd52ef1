#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "mesh_input.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::host {
namespace {

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
  explicit PlyReader(MeshInput& input) : input_(input), rest_(input.bytes()) {}

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
        if (is_face) input_.add_face(indices_);
      }
    }
    if (!has_faces) input_.refuse("a PLY file without faces");
  }

 private:
  void read_header() {
    if (take_line(rest_) != std::optional<std::string_view>("ply"))
      input_.refuse("no PLY file: its first line is not \"ply\"");
    while (true) {
      const auto line = take_line(rest_);
      if (!line) input_.refuse("the header of the PLY file does not end");
      const auto word = words(*line);
      if (word.empty() || word[0] == "comment" || word[0] == "obj_info") continue;
      if (word[0] == "end_header") return;
      if (!take_header_line(word)) input_.refuse("the PLY header has the line " + shown(*line));
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
    if (!position) input_.refuse("vertices of a PLY file without x, y and z");
    input_.add_vertex(*position);
    if (const auto normal = vector_of(element, {"nx", "ny", "nz"})) input_.add_normal(*normal);
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
    if (!number) input_.refuse(shown(word) + " is no number");
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
    input_.refuse("the PLY file ends before the " + std::to_string(elements_.size()) +
                  " kinds of elements that its header counts");
  }

  MeshInput& input_;
  std::string_view rest_;
  bool is_text_ = false;
  bool is_big_endian_ = false;
  std::vector<PlyElement> elements_;
  std::vector<double> values_;          // of one item, one a property
  std::vector<std::uint32_t> indices_;  // of one face
};

}  // namespace

void read_ply(MeshInput& input) {
  PlyReader(input).read();
}

}  // namespace discmc::host

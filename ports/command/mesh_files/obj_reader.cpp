#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mesh_input.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::host {
namespace {

class ObjReader {
 public:
  explicit ObjReader(MeshInput& input) : input_(input) {}

  void read() {
    std::string_view rest = input_.bytes();
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
        input_.refuse("a face names vertex " + std::to_string(std::uint64_t{position} + 1) +
                      ", and there are " + std::to_string(positions_.size()));
      input_.add_vertex(positions_[position]);
      if (normal < normals_.size()) input_.add_normal(normals_[normal]);
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
      corners.push_back(vertex_of({position, normal}));
    }
    input_.add_face(corners);
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
    input_.refuse("line " + std::to_string(line_) + ": " + what + " " + fault);
  }

  MeshInput& input_;
  std::uint64_t line_ = 0;
  std::vector<Point> positions_, normals_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
  std::vector<Corner> vertices_;
};

}  // namespace

void read_obj(MeshInput& input) {
  ObjReader(input).read();
}

}  // namespace discmc::host

// What the readers of mesh files share: the bytes, refusals, and the mesh so far. Internal to the
// readers of meshes.
#ifndef DISCMC_COMMAND_MESH_FILES_MESH_INPUT_HPP
#define DISCMC_COMMAND_MESH_FILES_MESH_INPUT_HPP

#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "meshes/mesh.hpp"

namespace discmc::host {

class MeshInput {
 public:
  MeshInput(std::filesystem::path file, std::string bytes)
      : file_(std::move(file)), bytes_(std::move(bytes)) {}

  const std::string& bytes() const { return bytes_; }
  std::size_t vertex_count() const { return mesh_.vertices_mm.size(); }

  /// Throws a std::runtime_error that reads "file: what; remedy".
  [[noreturn]] void refuse(const std::string& what,
                           const std::string& remedy = "export it anew") const;

  /// Throws as refuse() does when a coordinate is no number or beyond 1e30.
  void add_vertex(const Point& vertex);
  /// Of the vertex added last. Any length; what is no direction counts as none.
  void add_normal(const Point& normal);
  /// What has less than three corners is no face and is dropped. The vertices may come later.
  void add_face(const std::vector<std::uint32_t>& corners);

  /// Throws as refuse() does when a face names a vertex that is not there.
  Mesh finish();

 private:
  std::filesystem::path file_;
  std::string bytes_;
  Mesh mesh_;
};

void read_ply(MeshInput& input);
void read_obj(MeshInput& input);
void read_stl(MeshInput& input);

/// The number that the whole text is.
template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace discmc::host

#endif

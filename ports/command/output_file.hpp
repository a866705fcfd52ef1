// The file that a command writes, its format told by its name.
#ifndef DISCMC_COMMAND_OUTPUT_FILE_HPP
#define DISCMC_COMMAND_OUTPUT_FILE_HPP

#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <ostream>

#include "meshes/mesh.hpp"
#include "surface/surface.hpp"

namespace discmc::host {

enum class Format { stream, obj, ply, stl, jsonl };

/// By the extension; "-" is the stream on standard output. Throws std::invalid_argument with the
/// extensions that are known.
Format format_of(const std::filesystem::path& path);

/// A file that appears under its name only when commit() is reached: whatever fails before, and a
/// signal that ends the program, leaves no half-written file behind. "-" is standard output; pipes
/// and devices are written in place. Limit: one at a time.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile();

  std::ostream& stream();
  /// Throws std::runtime_error when not everything could be written.
  void commit();

 private:
  bool is_standard_output() const { return path_ == "-"; }
  bool is_in_place() const { return temporary_.empty(); }
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream file_;
  bool is_committed_ = false;
};

/// Writes a surface as a mesh or as lines of polygons. conforming: see MeshOptions.
/// add_normals: called with the mesh before it is written; only PLY and OBJ hold what it gives.
/// Limit: not Format::stream.
void write_surface(const Surface& surface, Format format, bool conforming,
                   const std::function<void(Mesh&)>& add_normals, std::ostream& out);

}  // namespace discmc::host

#endif

// The files that discmc extract writes its meshes to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "files/output_file.hpp"
#include "mesh_files/file_mesh.hpp"
#include "meshing.hpp"
#include "samples/volume_placement.hpp"
#include "summary.hpp"
#include "surface/surface.hpp"

namespace discmc::command {

/// A surface of a volume, and the file of its mesh.
struct SurfaceOutput {
  Surface& surface;
  const NamedSelection& selection;
  std::string file;
  std::string title;                     ///< names the input and the surface in messages
  const Crossings* crossings = nullptr;  ///< as MeshingOptions::crossings
};

/// Writes one file per mesh if --output contains {name}, otherwise one file with all meshes.
class MeshFiles {
 public:
  /// arguments: Owner: the caller. Throws if no file can be written; therefore construct this
  /// before reading the volume.
  explicit MeshFiles(const ExtractArguments& arguments);

  /// Sets the position and orientation of the meshes.
  void set_placement(const std::optional<VolumePlacement>& placement) { placement_ = placement; }

  /// Whether all meshes go into one file.
  bool are_one() const { return are_one_; }

  /// Returns the file of each surface. Names differ if each mesh has its own file; so do names of
  /// material files. If several surfaces have an equal name, all but the first also get their
  /// selection as part of the name.
  std::vector<std::string> names_for(const std::vector<NamedSelection>& selections);

  /// Makes the mesh of a surface for add(), unless add() makes it while it writes. Several threads
  /// may call it.
  std::optional<FileMesh> made_ahead(const SurfaceOutput& output) const;

  /// Writes the mesh of a surface, or keeps it for the common file. Empties the surface. made: by
  /// made_ahead(), if it was called.
  MeshSummary add(const SurfaceOutput& output, std::optional<FileMesh> made = {});

  /// Writes the common file, if there is one, and prints its size.
  void finish();

 private:
  using Made = std::optional<FileMesh>;

  bool may_write_parts(const SurfaceOutput& output) const;
  std::optional<MeshSummary> write_parts(const SurfaceOutput& output, OutputFile& file) const;
  MeshSummary write(const SurfaceOutput& output, Made made, OutputFile& file) const;
  MeshSummary write_alone(const SurfaceOutput& output, Made made);
  MeshSummary keep(const SurfaceOutput& output, Made made);
  std::vector<FileMesh> meshes_of(const SurfaceOutput& output, Made made) const;
  FileMesh mesh_of(const SurfaceOutput& output, Made made) const;
  MeshSummary summary_of(const std::vector<FileMesh>& meshes) const;
  const char* name_of_faces() const {
    return arguments_.mesh.faces == Faces::triangles ? "triangles" : "polygons";
  }

  const ExtractArguments& arguments_;
  std::optional<VolumePlacement> placement_;
  bool are_one_ = false;
  std::optional<OutputFile> file_;  // if all meshes share it
  std::vector<FileMesh> meshes_;    // for `file_`, if it holds several meshes
};

}  // namespace discmc::command

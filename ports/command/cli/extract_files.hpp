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
  std::optional<FileMesh> made{};        ///< by MeshFiles::make_ahead()
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
  /// may call this for different surfaces.
  void make_ahead(SurfaceOutput& output) const;

  /// Writes the mesh of a surface, or keeps it for the common file. Empties the surface.
  MeshSummary add(SurfaceOutput output);

  /// Writes the common file, if there is one, and prints its size.
  void finish();

 private:
  FileMesh made(const SurfaceOutput& output, unsigned jobs) const;
  bool may_write_parts(const SurfaceOutput& output) const;
  std::optional<MeshSummary> write_parts(const SurfaceOutput& output, OutputFile& file) const;
  MeshSummary write(SurfaceOutput& output, OutputFile& file) const;
  MeshSummary write_alone(SurfaceOutput& output);
  MeshSummary keep(SurfaceOutput& output);
  std::vector<FileMesh> meshes_of(SurfaceOutput& output) const;
  FileMesh mesh_of(SurfaceOutput& output) const;
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

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

/// A surface of a volume, and the file that its mesh goes to.
struct SurfaceOutput {
  Surface& surface;
  const NamedSelection& selection;
  std::string file;
  std::string title;                     ///< of the input and the surface, for messages
  const Crossings* crossings = nullptr;  ///< as MeshingOptions
};

/// One file per mesh if --output has a place for their names, else one file that holds all.
class MeshFiles {
 public:
  /// arguments: Owner: the caller. Throws where no file can be written: so call it before the
  /// volume is read.
  explicit MeshFiles(const ExtractArguments& arguments);

  /// Where the meshes lie.
  void set_placement(const std::optional<VolumePlacement>& placement) { placement_ = placement; }

  /// Whether all meshes go into one file.
  bool are_one() const { return are_one_; }

  /// The files of surfaces. All names differ where each file has its own, and so do those of
  /// material files. All files of an equal name but the first also get the selection in their
  /// names.
  std::vector<std::string> names_for(const std::vector<NamedSelection>& selections);

  /// Makes the mesh of a surface for add(), unless that makes it while it writes. May be called by
  /// several threads.
  std::optional<FileMesh> made_ahead(const SurfaceOutput& output) const;

  /// Writes the mesh of a surface, or keeps it for the file of all; the surface is then empty.
  /// made: by made_ahead(), if it was called.
  MeshSummary add(const SurfaceOutput& output, std::optional<FileMesh> made = {});

  /// Writes the file of all, if that is asked for, and prints its size.
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
  std::optional<OutputFile> file_;  // where there is only one
  std::vector<FileMesh> meshes_;    // of it, if it holds several
};

}  // namespace discmc::command

// What discmc extract does, by what it writes.
#ifndef DISCMC_COMMAND_CLI_EXTRACT_HPP
#define DISCMC_COMMAND_CLI_EXTRACT_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "files/file_pattern.hpp"
#include "statistics/measured_volume.hpp"
#include "summary.hpp"
#include "surface_receiver.hpp"
#include "volumes/label_table.hpp"

namespace discmc::command {

/// Each writes its files, then the table, and returns the exit code.
int extract_stream(const ExtractArguments& arguments);
int extract_meshes(const ExtractArguments& arguments);
int extract_label_meshes(const ExtractArguments& arguments);

/// One a surface, in the order of the selections.
using SurfaceReceivers = std::vector<std::unique_ptr<SurfaceReceiver>>;

/// A stream that was written.
struct ExtractedStream {
  std::vector<Extraction> extractions;  ///< one a surface, in the order of the selections
  SurfaceReceivers receivers;           ///< with the counts, unless quiet
  std::uint64_t slice_bytes = 0;        ///< of a stream of slices
  std::size_t slice_memory = 0;         ///< that its encoder took; Units: bytes
};

/// Writes the stream alone. Throws when a surface is empty that may not be.
ExtractedStream write_stream(const ExtractArguments& arguments, std::ostream& out);

/// kept: of every surface, if anything is.
SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections,
                               std::optional<Kept> kept);
std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers);

/// The table of labels that was given, or an empty one.
LabelTable label_table_of(const ExtractArguments& arguments);

/// Gives a label the name and the colour that it has in the table, if it is there. Control
/// characters of the name, which a terminal would obey, become underscores.
void describe(NamedSelection& selection, const LabelTable& table);

/// The files of surfaces. Where the pattern has their names no two are the same: of equal names all
/// but the first get their label or threshold as well.
std::vector<std::string> files_for(const FilePattern& pattern,
                                   const std::vector<NamedSelection>& selections);

/// A surface of a volume, and the file that its mesh goes to.
struct SurfaceOutput {
  Surface& surface;
  const NamedSelection& selection;
  std::string file;
  const Crossings* crossings = nullptr;  ///< as MeshOptions
};

/// Writes a mesh of the surface, with normals as asked, and returns what it was. placement: of the
/// mesh.
MeshSummary write_mesh_of(const ExtractArguments& arguments, const SurfaceOutput& output,
                          const std::optional<VolumePlacement>& placement);

/// Whether all meshes go into one file, as its name has no place for theirs.
bool shares_file(const ExtractArguments& arguments);

/// The same mesh for such a file, with its name.
Mesh part_of(const ExtractArguments& arguments, const SurfaceOutput& output,
             const std::optional<VolumePlacement>& placement);
void write_parts(const ExtractArguments& arguments, const std::vector<Mesh>& parts);

MeshSummary summary_of(const Mesh& mesh, const ExtractArguments& arguments);

/// How much is done at once: as asked for, or as there are cores.
unsigned jobs_of(const ExtractArguments& arguments);

/// As check_surface(), of each. volume: that they are of.
void check_surfaces(const ExtractArguments& arguments, const std::vector<Extraction>& extractions,
                    const MeasuredVolume& volume);

/// Says how many samples are not a number, if any.
void note_not_numbers(const ExtractArguments& arguments, std::uint64_t not_numbers);

}  // namespace discmc::command

#endif

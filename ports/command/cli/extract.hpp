// What discmc extract does, by what it writes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <vector>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "statistics/measured_volume.hpp"
#include "summary.hpp"
#include "surface_receiver.hpp"

namespace discmc::command {

/// Each writes its files, then the table, and returns the exit code.
int extract_stream(ExtractArguments arguments);
int extract_meshes(ExtractArguments arguments);
int extract_label_meshes(const ExtractArguments& arguments);

/// The meshes of the labels that are asked for, each with its name and colour; with normals of the
/// surface, if those are asked for.
std::vector<FileMesh> label_meshes(const ExtractArguments& arguments);

/// One a surface, in the order of the selections.
using SurfaceReceivers = std::vector<std::unique_ptr<SurfaceReceiver>>;

/// A stream that was written.
struct ExtractedStream {
  std::vector<Extraction> extractions;  ///< one per surface, in the order of the selections
  SurfaceReceivers receivers;           ///< with the counts, unless quiet
  std::uint64_t slice_bytes = 0;        ///< of a stream of slices
  std::size_t slice_memory = 0;         ///< that its encoder took; Units: bytes
};

/// Writes the stream alone. arguments: get the labels that are found. Throws when a surface is
/// empty that may not be.
ExtractedStream write_stream(ExtractArguments& arguments, std::ostream& out);

/// kept: of every surface, if anything is.
SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections,
                               std::optional<Kept> kept);
std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers);

/// How much is done at once: as asked for, or as there are cores.
unsigned jobs_of(const ExtractArguments& arguments);

/// As check_surface(), of each. volume: that they are of.
void check_surfaces(const ExtractArguments& arguments, const std::vector<Extraction>& extractions,
                    const MeasuredVolume& volume);

/// Prints how many samples are not a number, if any.
void note_not_numbers(const ExtractArguments& arguments, std::uint64_t not_numbers);

}  // namespace discmc::command

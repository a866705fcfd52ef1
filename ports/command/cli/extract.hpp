// The parts of discmc extract, by the kind of output.
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

/// Each function writes its files, then the table, and returns the exit code.
int extract_stream(ExtractArguments arguments);
int extract_meshes(ExtractArguments arguments);
int extract_label_meshes(const ExtractArguments& arguments);

/// Returns the meshes of the requested labels, each with its name and colour, and with surface
/// normals if requested.
std::vector<FileMesh> label_meshes(const ExtractArguments& arguments);

/// One receiver per surface, in the order of the selections.
using SurfaceReceivers = std::vector<std::unique_ptr<SurfaceReceiver>>;

/// A stream that was written.
struct ExtractedStream {
  std::vector<Extraction> extractions;  ///< one per surface, in the order of the selections
  SurfaceReceivers receivers;           ///< keep the counts, unless quiet
  std::uint64_t slice_bytes = 0;        ///< size of a stream of slices
  std::size_t slice_memory = 0;         ///< memory of the slice encoder; Units: bytes
};

/// Writes only the stream. arguments: receives the labels that are found. Throws if a surface is
/// empty without --allow-empty.
ExtractedStream write_stream(ExtractArguments& arguments, std::ostream& out);

/// kept: what each receiver keeps, if anything. jobs: threads that sort polygons.
SurfaceReceivers receivers_for(const std::vector<NamedSelection>& selections,
                               std::optional<Kept> kept, unsigned jobs = 1);
std::vector<SurfaceRequest> requests_of(const std::vector<NamedSelection>& selections,
                                        const SurfaceReceivers& receivers);

/// Returns the number of parallel jobs: the requested number, or the number of cores.
unsigned jobs_of(const ExtractArguments& arguments);

/// Calls check_surface() for each surface. volume: the input of all extractions.
void check_surfaces(const ExtractArguments& arguments, const std::vector<Extraction>& extractions,
                    const MeasuredVolume& volume);

/// Prints how many samples are NaN, if any.
void note_not_numbers(const ExtractArguments& arguments, std::uint64_t not_numbers);

}  // namespace discmc::command

// The arguments of the commands, as they are after the command line was read.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <discmc/limits.hpp>

#include "decimation/decimation.hpp"
#include "discmc/mesh.hpp"
#include "extraction/selection.hpp"
#include "mesh_files/file_mesh.hpp"
#include "meshes/mesh.hpp"
#include "meshing.hpp"
#include "pictures/srgb.hpp"
#include "statistics/threshold_rule.hpp"
#include "streams/stream_reader.hpp"
#include "surface/components.hpp"
#include "tuning/cycle_costs.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// What is on in a surface, and what the user calls it.
struct NamedSelection {
  Selection selection;
  std::string given;                    ///< on the command line: "300", "otsu", "5,right lung"
  std::string name = given;             ///< the same, or what the label is called
  std::optional<Srgb> colour{};         ///< of a label, if it has one
  std::optional<ThresholdRule> rule{};  ///< by which the selection is still to be found
  bool is_label = false;                ///< which is looked up as the volume is opened

  bool has_upper_end() const { return is_label || selection.has_upper_end(); }
};

/// How a volume is read and its surface taken: of every command that takes one.
struct VolumeArguments {
  std::vector<NamedSelection> selections;  ///< one per surface
  Border border = Border::closed;
  std::uint32_t median = 0;  ///< voxels across the filter of bits; 0: none
  std::string mask;          ///< the file of a volume, or none
  double close_mm = 0;       ///< radius by which the selected voxels are closed; 0: they are not
  /// Deviation by which the selected voxels are smoothed; 0: by the spacing. Units: millimetres
  std::optional<double> smooth_mm;
  bool allows_empty = false;  ///< surfaces
  std::uint64_t memory = 0;
  std::vector<std::uint32_t> capacities;  ///< slots and holes, or none
  VolumeOptions options;
  std::string label_table;  ///< file of the names of labels, or none

  /// Whether the surfaces are those of labels.
  bool selects_labels() const { return !selections.empty() && selections[0].is_label; }
};

/// The coordinates of a mesh: of the patient, or index times spacing.
enum class MeshSpace { lps, ras, voxel };

/// One of `count` slabs of a volume, counted from 1 at its first slice.
struct SlabChoice {
  std::uint32_t number, count;
};

/// Where the vertices of a mesh lie: halfway between voxels, where the samples cross the threshold,
/// or on the smoothest surface between the voxels.
enum class SurfaceKind { merged, interpolated, relaxed };

/// The arguments of `extract`.
struct ExtractArguments {
  std::string volume;
  VolumeArguments reading;
  std::string labels;  ///< "all" or a list, a surface each, in place of selections; or none
  std::string output = "-";
  std::string format;  ///< of standard output; then in the name of the output
  Normals normals = Normals::none;
  Wire wire = Wire::regions;
  std::uint32_t key_slices = 0;  ///< from one to the next; 0: the first alone
  std::uint8_t levels = 0;       ///< of the fractions in slices; 0: none
  std::uint16_t scan = 0;        ///< the number in a stream
  std::optional<SlabChoice> slab;
  std::optional<unsigned> jobs;  ///< parts at once; else all cores for a mesh, one for a stream
  MeshingOptions mesh{true, Faces::triangles};
  ComponentChoice components;
  bool lists_bodies = false;       ///< measures have a row for each body
  Decimation decimation;           ///< of each mesh
  std::optional<MeshSpace> space;  ///< else LPS if the file names its space, or that of the file
  MeshSize size;
  SurfaceKind surface = SurfaceKind::merged;
  bool is_quiet = false;

  bool interpolates() const { return surface == SurfaceKind::interpolated; }
};

/// Whether the volume may be extracted in parts.
inline bool is_divisible(const ExtractArguments& arguments) {
  return !arguments.interpolates() && arguments.labels.empty() && arguments.reading.memory == 0 &&
         arguments.reading.capacities.empty();
}

/// The arguments of `info`.
struct InfoArguments {
  std::string input;
  std::optional<bool> is_volume;  ///< or a stream; else by its first bytes
  StreamChoice choice;
  VolumeOptions options;
};

/// The arguments of `decode`.
struct StreamArguments {
  std::string stream;
  StreamChoice choice;
  std::string output;
  std::string format;  ///< as of ExtractArguments
  Normals normals = Normals::none;
  std::string volume;  ///< whose gradient it is
  VolumeOptions options;
  MeshingOptions mesh{true, Faces::triangles};
  ComponentChoice components;
  std::optional<MeshSpace> space;  ///< else LPS if the file names its space, or that of the file
  MeshSize size;
  SurfaceKind surface = SurfaceKind::merged;
};

/// The arguments of `join`.
struct JoinArguments {
  std::vector<std::string> streams;
  std::string output;
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< what outgrows it goes to a temporary file
  bool is_quiet = false;
};

/// What an input with a surface is.
enum class InputKind { mesh, stream, volume };

/// The arguments of `render`.
struct RenderArguments {
  std::string input;
  InputKind kind = InputKind::stream;
  StreamChoice choice;
  VolumeArguments reading;
  std::string labels;  ///< as of ExtractArguments
  ComponentChoice components;
  SurfaceKind surface = SurfaceKind::merged;
  double tolerance = MeshingOptions().tolerance;
  bool classic = false;
  std::string output;
  std::vector<double> view = {-0.9, -1.6, 0.8};
  std::vector<int> size = {1024, 1024};
  double zoom = 1;
  std::vector<double> at;
  bool smooth = false;
  bool draws_outlines = false;
};

/// The arguments of `view`.
struct ViewArguments {
  std::string input;
  std::optional<InputKind> kind;  ///< else a volume or a stream, by its first bytes
  VolumeArguments reading;        ///< without a selection or labels the samples are shown
  std::string labels;             ///< as of ExtractArguments
  SurfaceKind surface = SurfaceKind::merged;  ///< of a stream
  double tolerance = MeshingOptions().tolerance;
  std::string output;  ///< none where it is served
  bool opens = true;
  bool serves = false;
  std::uint16_t port = 0;  ///< 0: any that is free
};

/// The arguments of `tune`.
struct TuneArguments {
  std::string volume;
  VolumeArguments reading;
  double baud = 921600;
  double clock_hz = 48e6;
  Core core = Core::cortex_m4;
  std::vector<Wire> wires;  ///< empty: all
};

/// A surface of `compare`.
struct ComparedInput {
  std::string name;
  InputKind kind = InputKind::mesh;
};

/// The arguments of `compare`.
struct CompareArguments {
  std::array<ComparedInput, 2> inputs;
  StreamChoice choice;
  VolumeArguments reading;
};

}  // namespace discmc::command

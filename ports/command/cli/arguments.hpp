// The parsed arguments of the commands.
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

/// The selection of a surface, and the user's name for it.
struct NamedSelection {
  Selection selection;
  std::string given;                    ///< on the command line: "300", "otsu", "5,right lung"
  std::string name = given;             ///< the label's own name, if it has one
  std::optional<Srgb> colour{};         ///< of a label, if it has one
  std::optional<ThresholdRule> rule{};  ///< finds the selection later
  bool is_label = false;                ///< looked up when the volume is opened

  bool has_upper_end() const { return is_label || selection.has_upper_end(); }
};

/// The arguments with which commands read a volume and extract its surface.
struct VolumeArguments {
  std::vector<NamedSelection> selections;  ///< one per surface
  Border border = Border::closed;
  std::uint32_t median = 0;  ///< width of the filter of bits, in voxels; 0: none
  std::string mask;          ///< the file of the mask, or empty
  double close_mm = 0;       ///< radius of the closing; 0: none
  /// Deviation of the smoothing; 0: chosen by the spacing. Units: millimetres
  std::optional<double> smooth_mm;
  bool allows_empty = false;  ///< accepts empty surfaces
  std::uint64_t memory = 0;
  std::vector<std::uint32_t> capacities;  ///< slots and holes, or empty
  VolumeOptions options;
  std::string label_table;  ///< file with the names of labels, or empty

  /// Whether the surfaces are surfaces of labels.
  bool selects_labels() const { return !selections.empty() && selections[0].is_label; }
};

/// The coordinates of a mesh: in the patient's space, or index times spacing.
enum class MeshSpace { lps, ras, voxel };

/// One of `count` slabs of a volume, counted from 1 at its first slice.
struct SlabChoice {
  std::uint32_t number, count;
};

/// The positions of a mesh's vertices: halfway between voxels, where the samples cross the
/// threshold, or on the smoothest surface between the voxels.
enum class SurfaceKind { merged, interpolated, relaxed };

/// The arguments of `extract`.
struct ExtractArguments {
  std::string volume;
  VolumeArguments reading;
  std::string labels;  ///< "all" or a list, one surface each; replaces `selections`
  std::string output = "-";
  std::string format;  ///< of standard output; later part of `output`
  Normals normals = Normals::none;
  Wire wire = Wire::regions;
  std::uint32_t key_slices = 0;  ///< interval of key slices; 0: only the first
  std::uint8_t levels = 0;       ///< levels of the fractions in slices; 0: none
  std::uint16_t scan = 0;        ///< number of the scan in a stream
  std::optional<SlabChoice> slab;
  std::optional<unsigned> jobs;  ///< default: all cores for a mesh, one for a stream
  MeshingOptions mesh{true, Faces::triangles};
  ComponentChoice components;
  bool lists_bodies = false;       ///< prints the measures of each body
  Decimation decimation;           ///< of each mesh
  std::optional<MeshSpace> space;  ///< default: LPS if the file has a space, else its own
  MeshSize size;
  SurfaceKind surface = SurfaceKind::merged;
  bool is_quiet = false;

  bool interpolates() const { return surface == SurfaceKind::interpolated; }
};

/// Whether the volume may be extracted in parts.
inline bool is_divisible(const ExtractArguments& arguments) {
  return arguments.labels.empty() && arguments.reading.memory == 0 &&
         arguments.reading.capacities.empty();
}

/// The arguments of `info`.
struct InfoArguments {
  std::string input;
  std::optional<bool> is_volume;  ///< default: by the first bytes
  StreamChoice choice;
  VolumeOptions options;
};

/// The arguments of `decode`.
struct StreamArguments {
  std::string stream;
  StreamChoice choice;
  std::string output;
  std::string format;  ///< as ExtractArguments::format
  Normals normals = Normals::none;
  std::string volume;  ///< file from which gradient normals are computed
  VolumeOptions options;
  MeshingOptions mesh{true, Faces::triangles};
  ComponentChoice components;
  std::optional<MeshSpace> space;  ///< default: LPS if the file has a space, else its own
  MeshSize size;
  SurfaceKind surface = SurfaceKind::merged;
};

/// The arguments of `join`.
struct JoinArguments {
  std::vector<std::string> streams;
  std::string output;
  std::uint64_t memory = std::uint64_t{1} << 30;  ///< the rest goes to a temporary file
  bool is_quiet = false;
};

/// The kind of an input that has a surface.
enum class InputKind { mesh, stream, volume };

/// The arguments of `render`.
struct RenderArguments {
  std::string input;
  InputKind kind = InputKind::stream;
  StreamChoice choice;
  VolumeArguments reading;
  std::string labels;  ///< as ExtractArguments::labels
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
  std::optional<InputKind> kind;  ///< default: volume or stream, by the first bytes
  VolumeArguments reading;        ///< without a selection or labels, the page shows the samples
  std::string labels;             ///< as ExtractArguments::labels
  SurfaceKind surface = SurfaceKind::merged;  ///< surface of a stream
  double tolerance = MeshingOptions().tolerance;
  std::string output;  ///< empty if the page is served
  bool opens = true;
  bool serves = false;
  std::uint16_t port = 0;  ///< 0: any free port
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

// Meshes of volumes, for programs on a PC.
//
//   const discmc::Mesh mesh = discmc::mesh_of(samples, {nx, ny, nz}, 500);
//
// A voxel is inside if its sample is >= the level. Sample (x, y, z) of the array is
// samples[x + nx * (y + ny * z)] unless strides are given. The mesh is closed, without T-junctions,
// and its triangles are counter-clockwise seen from outside. By default it is that of Discretized
// Marching Cubes: vertices lie halfway between voxels, and coplanar facets are merged before they
// are triangulated. MeshOptions::interpolates moves the vertices to where the samples cross the
// level, and MeshOptions::relaxes to a smooth surface if there are no samples.
//
// mesh_of() needs the array once and never copies it; MeshBuilder accepts slices one by one, and
// MeshReceiver the bytes of a device. Link discmc::mesh. In C: discmc/mesh.h.
//
// Errors: std::invalid_argument names the value and the remedy; std::length_error: more than 2^32
// corners, or more than 32,760 slices of a MeshBuilder; Cancelled: MeshOptions::progress
// returned false; what a callback throws.
#ifndef DISCMC_MESH_HPP
#define DISCMC_MESH_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <discmc/limits.hpp>
#include <discmc/stream_report.hpp>

namespace discmc {

/// Numbers of voxels along x, y and z. Two of them at most 32,766, the third at most 2^30 - 1.
class Extents {
 public:
  template <class X, class Y, class Z>
  Extents(X x, Y y, Z z) : voxels_{checked(x), checked(y), checked(z)} {
    require_two_short();
  }

  std::int64_t operator[](std::size_t axis) const { return voxels_[axis]; }
  std::int64_t count() const { return voxels_[0] * voxels_[1] * voxels_[2]; }

 private:
  template <class Whole>
  static std::int64_t checked(Whole voxels) {
    static_assert(std::is_integral_v<Whole>, "extents are whole numbers");
    return limited(static_cast<std::int64_t>(voxels));
  }
  static std::int64_t limited(std::int64_t voxels);
  void require_two_short() const;

  std::array<std::int64_t, 3> voxels_;
};

/// Distances from a sample to the next along x, y and z, also negative. Units: samples.
using Strides = std::array<std::ptrdiff_t, 3>;

namespace meshing {
enum class SampleType : std::uint8_t;
template <class Sample>
constexpr SampleType type_of();
}  // namespace meshing

/// A view of samples in memory: whole numbers of 8 to 64 bits, float or double, at their natural
/// alignment. Owner: the caller, as long as the view is used.
class Samples {
 public:
  template <class Sample>
  Samples(const Sample* samples, const Extents& extents)
      : Samples(samples, meshing::type_of<Sample>(), extents) {}
  /// samples: that of voxel (0, 0, 0).
  template <class Sample>
  Samples(const Sample* samples, const Extents& extents, const Strides& strides)
      : Samples(samples, meshing::type_of<Sample>(), extents, strides) {}
  /// Throws std::invalid_argument if the vector has another size.
  template <class Sample>
  Samples(const std::vector<Sample>& samples, const Extents& extents)
      : Samples(samples.data(), extents) {
    require_count(samples.size(), extents);
  }
  Samples(const void* samples, meshing::SampleType type, const Extents& extents);
  Samples(const void* samples, meshing::SampleType type, const Extents& extents,
          const Strides& strides);

  const void* data() const { return data_; }
  meshing::SampleType type() const { return type_; }
  const Extents& extents() const { return extents_; }
  const Strides& strides() const { return strides_; }

 private:
  static void require_count(std::size_t count, const Extents& extents);

  const void* data_;
  meshing::SampleType type_;
  Extents extents_;
  Strides strides_;
};

/// The values inside a surface: from low to high, both included. A sample that is not a number is
/// outside.
struct Level {
  Level(double lowest) : low(lowest) {}
  Level(double lowest, double highest) : low(lowest), high(highest) {}

  double low;
  double high = std::numeric_limits<double>::infinity();
};

/// What a vertex normal is made of.
enum class Normals {
  none,
  surface,   ///< the polygons around the vertex
  gradient,  ///< the samples; a second pass over the array. Limit: a level without a high end
};

/// The progress of a call.
struct MeshProgress {
  const char* step;    ///< "smoothing", "extracting", "triangulating", "decimating", "normals"
  std::uint64_t done;  ///< slices
  std::uint64_t all;   ///< 0: the step does not count
};

struct MeshOptions {
  /// Distances between voxels along x, y and z, in any unit, which is that of the mesh. Negative if
  /// the axis runs backwards. Limit: 1e-6 to 1e6.
  std::array<double, 3> spacing{1, 1, 1};
  /// The placement of the volume, instead of the spacing. Row r of the centre of voxel (i, j, k) is
  /// column 3 plus i, j, k times columns 0 to 2.
  std::optional<std::array<std::array<double, 4>, 3>> placement{};
  /// closed: everything outside the array is outside the surface. open: the surface ends there.
  Border border = Border::closed;
  /// Moves vertices to where the samples cross the level, linearly interpolated. Whole numbers
  /// cross at level - 0.5: a sample equal to the level is inside, and the one below it outside.
  /// Sides and triangles are split where the crossings are farther from the mesh than the
  /// tolerance.
  bool interpolates = false;
  double tolerance = 0.05;  ///< also of relaxes; Units: voxels
  /// Moves vertices between the voxels to the smoothest surface that keeps every voxel on its side:
  /// for masks, and for streams, which hold no samples. Fractions in a stream limit how far they
  /// move. No triangles intersect. Limit: not with interpolates or smoothing, not for labels.
  bool relaxes = false;
  /// Smooths a mask or a label by a Gaussian of this deviation; implies interpolates. Each body
  /// keeps the volume of its voxels, and every voxel its side, unless the border is open. 1.5
  /// voxels remove the steps, or the largest spacing if the spacings differ. 0: none. Units: as
  /// spacing. Limit: one level; at most 1e6.
  double smoothing = 0;
  /// Decimates to this many triangles, or as far as max_error allows, whichever comes first; 0:
  /// not. Bodies keep their volumes. More triangles are left if fewer would cross, or lose a body
  /// or an opening. max_error: from the vertices of the whole mesh to the decimated one, and back
  /// from its vertices and the middles of its edges and triangles. Units: as spacing.
  std::uint64_t triangles = 0;
  double max_error = 0;
  Normals normals = Normals::none;
  /// Whether Mesh::polygons is filled. Limit: not interpolated, relaxed or decimated.
  bool polygons = false;
  /// The mesh does not depend on it. 0: as many as there are processors.
  unsigned threads = 1;
  /// Called in the calling thread, less often if there are more; false cancels the call.
  std::function<bool(const MeshProgress&)> progress{};
};

/// Merged polygons as rings of vertex numbers.
struct MeshPolygons {
  /// Polygon p has the rings from ring_begin[p] to before ring_begin[p + 1]: the outer ring, then
  /// its holes. Ring r has the corners from corner_begin[r] to before corner_begin[r + 1], the
  /// outer ring counter-clockwise seen from outside, holes clockwise.
  std::vector<std::size_t> ring_begin{0};
  std::vector<std::size_t> corner_begin{0};
  std::vector<std::uint32_t> corners;          ///< vertex numbers
  std::vector<std::array<double, 3>> normals;  ///< one per polygon: unit vectors, outwards

  std::size_t size() const { return normals.size(); }
};

struct Mesh {
  std::vector<std::array<double, 3>> vertices;          ///< Units: those of the spacing
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< vertex numbers
  /// One unit vector per vertex, outwards, zero where there is none; empty unless asked for.
  std::vector<std::array<double, 3>> normals;
  MeshPolygons polygons;  ///< empty unless asked for
};

/// The surface of a level.
[[nodiscard]] Mesh mesh_of(const Samples& samples, const Level& level,
                           const MeshOptions& options = {});
template <class Sample>
[[nodiscard]] Mesh mesh_of(const Sample* samples, const Extents& extents, const Level& level,
                           const MeshOptions& options = {}) {
  return mesh_of(Samples(samples, extents), level, options);
}
template <class Sample>
[[nodiscard]] Mesh mesh_of(const std::vector<Sample>& samples, const Extents& extents,
                           const Level& level, const MeshOptions& options = {}) {
  return mesh_of(Samples(samples, extents), level, options);
}

/// The surfaces of several levels in one pass, in their order.
[[nodiscard]] std::vector<Mesh> meshes_of(const Samples& samples, const std::vector<Level>& levels,
                                          const MeshOptions& options = {});

/// The surface of the voxels of one value.
struct LabelMesh {
  std::int64_t label;    ///< of uint64_t beyond 2^63 - 1: the bits as a negative number
  std::uint64_t voxels;  ///< that have the label
  Mesh mesh;
};

/// The surfaces of all labels but 0 in one pass, the least first; or only of those given.
/// Neighbours share their walls exactly. Limit: samples of whole numbers; at most 65,536 labels, or
/// 1,024 if most voxels have no neighbour of their label. Normals come from the surface alone;
/// interpolates only by smoothing. Smoothing holds the array once more, and the meshes of all
/// labels; the mesh of a label does not depend on which others are given.
[[nodiscard]] std::vector<LabelMesh> label_meshes(const Samples& samples,
                                                  const MeshOptions& options = {},
                                                  const std::vector<std::int64_t>& labels = {});

/// Measures of a mesh. Units: as the vertices, squared and cubed.
struct MeshMeasures {
  double area = 0;  ///< with the walls of cavities
  std::array<double, 3> least{}, greatest{};
  bool is_closed = false;
  // If the mesh is closed:
  double volume = 0;               ///< without cavities
  std::array<double, 3> centre{};  ///< of mass
  std::uint64_t bodies = 0;        ///< pieces that are connected by edges
  std::uint64_t cavities = 0;
};
[[nodiscard]] MeshMeasures measures_of(const Mesh& mesh);

/// Builds a mesh from slices that come one by one, up to 32,760; holds two slices of bits and the
/// surface, no volume. Limit of the options: no smoothing, no gradient normals, one thread.
class MeshBuilder {
 public:
  MeshBuilder(std::int64_t width, std::int64_t height, const Level& level,
              const MeshOptions& options = {});
  ~MeshBuilder();
  MeshBuilder(MeshBuilder&&) noexcept;
  MeshBuilder& operator=(MeshBuilder&&) noexcept;

  /// samples: width * height, rows of x; all slices of one type. Owner: the caller; free again when
  /// the call returns.
  template <class Sample>
  void add_slice(const Sample* samples) {
    add_slice(samples, meshing::type_of<Sample>());
  }
  void add_slice(const void* samples, meshing::SampleType type);

  /// The mesh of all slices. Limit: the last call; later ones throw std::logic_error.
  [[nodiscard]] Mesh finish();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Receives the streams of a device, scan after scan, of either kind. Any bytes are safe. A
/// receiver that was moved from throws std::logic_error.
class MeshReceiver {
 public:
  /// channel: of the surface, 0 to 63; by default the first that arrives. Throws
  /// std::invalid_argument for another.
  explicit MeshReceiver(std::optional<std::uint8_t> channel = std::nullopt);
  ~MeshReceiver();
  MeshReceiver(MeshReceiver&&) noexcept;
  MeshReceiver& operator=(MeshReceiver&&) noexcept;

  /// Accepts bytes of the link, up to the end of a scan. Returns the number accepted; then
  /// has_ended() is true, and the next push() of a byte or more begins the next scan. Throws
  /// std::runtime_error for a stream of an unknown version.
  std::size_t push(const std::uint8_t* bytes, std::size_t count);
  /// No bytes follow: ends a scan whose trailer is lost.
  void finish();

  /// Whether the scan has ended, by its trailer or by finish().
  bool has_ended() const;
  /// What arrived of the scan, and what is missing.
  StreamReport report() const;
  /// The header of the scan. Limit: report().has_header.
  const StreamHeader& header() const;
  /// The mesh of the polygons that arrived so far; closed once the scan is complete. Units:
  /// millimetres; half-steps of 0.5 without a spacing in the stream. options: the spacing is that
  /// of the stream, as is the border, and the placement if it is not given. Limit: no smoothing, no
  /// gradient normals; interpolates if header().levels is not 0. Vertices are then within half a
  /// level of where the samples cross, along the edge.
  [[nodiscard]] Mesh mesh(MeshOptions options = {}) const;
  /// The number of polygons that arrived so far.
  std::size_t polygon_count() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// MeshOptions::progress returned false.
class Cancelled : public std::runtime_error {
 public:
  Cancelled() : std::runtime_error("cancelled") {}
};

namespace meshing {

template <class Sample>
constexpr SampleType type_of() {
  static_assert((std::is_integral_v<Sample> && !std::is_same_v<Sample, bool>) ||
                    std::is_same_v<Sample, float> || std::is_same_v<Sample, double>,
                "samples are whole numbers of 8 to 64 bits, float or double");
  constexpr unsigned log_bytes = sizeof(Sample) == 1   ? 0
                                 : sizeof(Sample) == 2 ? 1
                                 : sizeof(Sample) == 4 ? 2
                                                       : 3;
  if constexpr (std::is_floating_point_v<Sample>)
    return static_cast<SampleType>(8 + (log_bytes - 2));
  else
    return static_cast<SampleType>(2 * log_bytes + (std::is_signed_v<Sample> ? 1 : 0));
}

}  // namespace meshing
}  // namespace discmc

#endif

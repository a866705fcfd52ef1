// The functions that page/module.js calls. One volume or stream at a time, and its surface.
//
// Exceptions reach the page as errors, and other calls may follow. Returned memory belongs to the
// module, until the next call of the same function.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "device_scan.hpp"
#include "drawn_surface.hpp"
#include "extraction/classic.hpp"
#include "gradient.hpp"
#include "measured.hpp"
#include "memory_volume.hpp"
#include "missing.hpp"
#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"
#include "stream_mesh.hpp"
#include "stream_surface.hpp"
#include "sweep.hpp"
#include "voxel_bits.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name), used))

namespace discmc::web {
namespace {

struct Bytes {
  const void* data;
  std::size_t count;
};

template <class Item>
const Bytes* bytes_of(const std::vector<Item>& items) {
  static Bytes bytes;
  bytes = {items.data(), items.size() * sizeof(Item)};
  return &bytes;
}

// All numbers in one list, which the page names.
template <class... Numbers>
const double* numbers(Numbers... each) {
  static double list[32];
  double* next = list;
  ((*next++ = static_cast<double>(each)), ...);
  return list;
}

struct State {
  std::unique_ptr<MemoryVolume> volume;
  std::unique_ptr<StreamSurface> stream;
  StreamMesh moved;
  std::vector<MissingLine> missing_lines;
  std::vector<SliceRange> missing_slices;
  double iso = 0;
  VoxelBits bits;
  Sweep sweep;
  Sweep::Result swept;
  DrawnSurface drawn;
  std::vector<OctahedralNormal> normals;
  std::vector<std::int32_t> polygons;
  meshing::FaceMesh classic;
  std::vector<float> classic_vertices;
  DeviceScan scan;
  std::vector<std::int32_t> surfaces;
  std::vector<std::uint8_t> picture;
};

State& state() {
  static State* const all = new State;
  return *all;
}

StreamHeader header() {
  const command::VolumeInfo& info = state().volume->info();
  StreamHeader header;
  header.width = info.dims[0];
  header.height = info.dims[1];
  header.depth = info.dims[2];
  const auto spacing = meshing::spacing_nm(info.spacing_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) header.spacing_nm[axis] = spacing[axis];
  header.thresholds[0] = meshing::stored_threshold(info, state().iso);
  return header;
}

const meshing::Polygons& polygons() {
  return state().stream ? state().stream->polygons() : state().swept.polygons;
}

}  // namespace

EXPORT(allocate) void* allocate(std::size_t bytes) {
  return std::malloc(bytes);
}
EXPORT(release) void release(void* data) {
  std::free(data);
}

/// Returns the memory for the samples.
EXPORT(new_volume)
std::uint8_t* new_volume(std::uint32_t type, std::uint32_t width, std::uint32_t height,
                         std::uint32_t depth, double x_mm, double y_mm, double z_mm, double slope,
                         double intercept, std::uint32_t is_in_hounsfield) {
  command::VolumeInfo info;
  info.type = static_cast<meshing::SampleType>(type);
  info.dims = {width, height, depth};
  info.spacing_mm = {x_mm, y_mm, z_mm};
  info.slope = slope;
  info.intercept = intercept;
  info.is_in_hounsfield = is_in_hounsfield != 0;
  state().volume = std::make_unique<MemoryVolume>(info);
  return state().volume->samples();
}

EXPORT(measure) const Measured* measure() {
  static Measured result;
  result = measured(*state().volume);
  return &result;
}

/// Sweeps the volume. Returns the numbers of cells, facets, triangles of classic Marching Cubes,
/// polygons, and rings.
EXPORT(extract) const double* extract(double iso, std::uint32_t is_filtered) {
  State& all = state();
  const command::VolumeInfo& info = all.volume->info();
  all.iso = iso;
  all.bits.select(*all.volume, iso);
  if (is_filtered != 0) all.bits.filter();
  all.swept = all.sweep.run(all.bits, info.dims[0], info.dims[1]);
  const Statistics& statistics = all.swept.statistics;
  return numbers(statistics.cells, statistics.facets, statistics.classic_triangles,
                 statistics.regions, statistics.rings);
}

/// Triangulates the polygons. Returns the number of omitted ones.
EXPORT(draw) std::uint32_t draw() {
  state().drawn.make(polygons());
  return state().drawn.left_out();
}
EXPORT(vertices) const Bytes* vertices() {
  return bytes_of(state().drawn.vertices());
}
EXPORT(triangles) const Bytes* triangles() {
  return bytes_of(state().drawn.triangles());
}
EXPORT(triangle_ends) const Bytes* triangle_ends() {
  return bytes_of(state().drawn.triangle_ends());
}
EXPORT(edges) const Bytes* edges() {
  return bytes_of(state().drawn.edges());
}
EXPORT(normals) const Bytes* normals() {
  state().normals = gradient_normals(state().drawn.vertices(), *state().volume, state().iso);
  return bytes_of(state().normals);
}

/// The polygons as numbers: incidence, number of rings, and for each ring the number of its corners
/// and their coordinates.
EXPORT(polygons) const Bytes* polygons_as_numbers() {
  std::vector<std::int32_t>& list = state().polygons;
  list.clear();
  for (const meshing::Polygon& polygon : polygons()) {
    list.push_back(polygon.incidence);
    list.push_back(static_cast<std::int32_t>(polygon.rings.size()));
    for (const meshing::Ring& ring : polygon.rings) {
      list.push_back(static_cast<std::int32_t>(ring.size()));
      for (const Vertex& corner : ring)
        for (const std::int32_t coordinate : {corner.x, corner.y, corner.z})
          list.push_back(coordinate);
    }
  }
  return bytes_of(list);
}

/// Triangles of classic Marching Cubes for the same threshold, without the filter.
EXPORT(classic) void classic() {
  State& all = state();
  MemoryReader reader(*all.volume);
  command::ExtractionOptions options;
  options.selection = {all.iso};
  all.classic = command::classic_mesh(reader, options);
  all.classic_vertices.clear();
  for (const meshing::Point& vertex : all.classic.vertices_mm)
    for (const double coordinate : vertex)
      all.classic_vertices.push_back(static_cast<float>(coordinate));
  all.classic.vertices_mm = {};
}
EXPORT(classic_vertices) const Bytes* classic_vertices() {
  return bytes_of(state().classic_vertices);
}
EXPORT(classic_triangles) const Bytes* classic_triangles() {
  return bytes_of(state().classic.corners);
}

EXPORT(min_memory) double min_memory() {
  return static_cast<double>(web::min_memory(header()));
}
/// The extracted scan on a device. memory: 0 for a stream of slices. Returns: bytes, regions sent
/// whole, loose fragments, bytes of memory used.
EXPORT(scan) const double* scan(double memory) {
  DeviceScan& scan = state().scan;
  scan = memory > 0 ? scan_regions(state().bits, header(), static_cast<std::uint64_t>(memory))
                    : scan_slices(state().bits, header());
  return numbers(scan.stream.size(), scan.regions, scan.fragments, scan.memory_used);
}
EXPORT(stream) const Bytes* stream() {
  return bytes_of(state().scan.stream);
}

/// The voxels of a plane across an axis (0, 1, 2), a byte each. Values from dark to bright become 0
/// to 127; on voxels have 128 more. Rows run along the first of the other two axes.
EXPORT(picture)
const Bytes* picture(std::uint32_t axis, std::uint32_t place, double dark, double bright) {
  const MemoryVolume& volume = *state().volume;
  const command::VolumeInfo& info = volume.info();
  const std::uint32_t along = axis == 0 ? 1 : 0, across = axis == 2 ? 1 : 2;
  std::vector<std::uint8_t>& picture = state().picture;
  picture.clear();
  constexpr double steps = 127;
  const double scale = bright > dark ? steps / (bright - dark) : 0;
  std::uint32_t at[3] = {place, place, place};
  meshing::with_sample_type(info.type, [&](auto type) {
    using Sample = decltype(type);
    for (at[across] = 0; at[across] < info.dims[across]; ++at[across])
      for (at[along] = 0; at[along] < info.dims[along]; ++at[along]) {
        const auto* slice = reinterpret_cast<const Sample*>(volume.slice(at[2]));
        const auto sample = static_cast<double>(slice[std::size_t{at[1]} * info.dims[0] + at[0]]);
        const double step = (info.slope * sample + info.intercept - dark) * scale;
        const double shown = step > steps ? steps : step > 0 ? step : 0;
        picture.push_back(static_cast<std::uint8_t>(
            static_cast<unsigned>(shown) | (state().bits.at(at[0], at[1], at[2]) ? 128U : 0U)));
      }
  });
  return bytes_of(picture);
}

/// The surface to read on a link with several; negative: the first.
EXPORT(new_stream) void new_stream(std::int32_t scan, std::int32_t channel) {
  meshing::StreamChoice choice;
  if (scan >= 0) choice.scan = static_cast<std::uint16_t>(scan);
  if (channel >= 0) choice.channel = static_cast<std::uint8_t>(channel);
  state().stream = std::make_unique<StreamSurface>(choice);
}
EXPORT(push_stream) void push_stream(const std::uint8_t* bytes, std::size_t count) {
  state().stream->push(bytes, count);
}
EXPORT(end_stream) void end_stream() {
  state().stream->finish();
}
/// Makes the mesh of the stream, relaxed or else interpolated. Returns the number of omitted
/// polygons.
EXPORT(move) std::uint32_t move(std::uint32_t relaxes) {
  state().moved.make(*state().stream, relaxes != 0);
  return static_cast<std::uint32_t>(state().moved.left_out());
}
EXPORT(moved_places) const Bytes* moved_places() {
  return bytes_of(state().moved.places());
}
EXPORT(moved_normals) const Bytes* moved_normals() {
  return bytes_of(state().moved.normals());
}
EXPORT(moved_triangles) const Bytes* moved_triangles() {
  return bytes_of(state().moved.triangles());
}
/// Finds the missing parts of the stream.
EXPORT(find_missing) void find_missing(std::uint32_t is_end) {
  const Missing missing = state().stream->missing(is_end != 0);
  state().missing_lines = missing.lines();
  state().missing_slices = missing.slices();
}
EXPORT(missing_lines) const Bytes* missing_lines() {
  return bytes_of(state().missing_lines);
}
EXPORT(missing_slices) const Bytes* missing_slices() {
  return bytes_of(state().missing_slices);
}
/// Returns the current state of the stream: see page/module.js.
EXPORT(stream_state) const double* stream_state() {
  const StreamSurface& stream = *state().stream;
  const StreamHeader& header = stream.reader().header();
  const StreamReport report = stream.report();
  const auto spacing = meshing::spacing_mm(header);
  const auto surface = static_cast<std::uint32_t>(stream.reader().channel() - header.channel);
  const std::int32_t threshold = header.thresholds[surface < header.surface_count ? surface : 0];
  return numbers(report.has_header, header.width, header.height,
                 report.has_trailer ? report.slices : header.depth, spacing[0], spacing[1],
                 spacing[2], threshold, stream.polygons().size(), report.is_complete(),
                 report.has_trailer, report.lost_packets, report.damaged_packets,
                 report.holds_slices ? report.lost_rows : report.lost_pieces, report.holds_slices,
                 report.totals.classic_triangles, report.bytes, header.border == Border::closed,
                 header.levels);
}
/// The axes of the voxels in space, one after another; 0 if there are none. Then whether space is
/// RAS.
EXPORT(stream_axes) const double* stream_axes() {
  const auto& placement = state().stream->placement();
  const auto& axes = placement.value_or(Placement{}).axes_nm;
  return numbers(axes[0][0], axes[0][1], axes[0][2], axes[1][0], axes[1][1], axes[1][2], axes[2][0],
                 axes[2][1], axes[2][2], placement && placement->space == Space::ras);
}
/// The surfaces of the link: scan, channel and threshold of each.
EXPORT(stream_surfaces) const Bytes* stream_surfaces() {
  std::vector<std::int32_t>& list = state().surfaces;
  list.clear();
  for (const StreamHeader& header : state().stream->reader().headers())
    for (std::uint32_t surface = 0; surface < header.surface_count; ++surface) {
      list.push_back(header.scan);
      list.push_back(static_cast<std::int32_t>(header.channel + surface));
      list.push_back(header.thresholds[surface]);
    }
  return bytes_of(list);
}

}  // namespace discmc::web

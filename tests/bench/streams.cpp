// The distances between the surfaces of streams and of samples, and the bytes of the streams.
//
//   bench_streams cthead.nrrd:500 engine.nii.gz:80

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/mesh.hpp>

#include "../command/received_fractions.hpp"
#include "comparison/volumes.hpp"
#include "extraction/classic.hpp"
#include "extraction/crossings.hpp"
#include "extraction/extraction.hpp"
#include "meshes/mesh.hpp"
#include "meshes/surface_distance.hpp"
#include "require.hpp"
#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"
#include "smoothing/relaxed_crossings.hpp"
#include "volumes/volume.hpp"

#ifdef DISCMC_WITH_CHARLS
#include <charls/charls.h>
#endif
#ifdef DISCMC_WITH_VTK
#include "flying_edges.hpp"
#endif

using namespace discmc;
using namespace discmc::command;

namespace {

constexpr const char* usage =
    R"(usage: bench_streams [FILE:THRESHOLD...]

Prints a table in Markdown for volumes of u8, u16 or i16 samples, and for generated ones, beside the
mesh that FlyingEdges3D makes of the samples, if the program has VTK:
  bytes                of the streams, and of the samples by JPEG-LS, if the program has CharLS
  least memory         of the encoders
  triangles            of the meshes, with tolerance 0
  of an edge           mean distance along the edges between voxels to where the samples cross
  mean, largest        distance from classic Marching Cubes (as discmc compare), in millimetres
  normals              mean angle to those of the interpolated mesh, by the areas around vertices, in degrees

Exit status: 0, or 1 if a file could not be read.
)";

using Bytes = std::vector<std::uint8_t>;

struct Stream {
  Bytes bytes;
  std::uint64_t memory;  // minimum memory of the encoder
};

using Opening = std::function<std::unique_ptr<VolumeReader>()>;

class Scan {
 public:
  Scan(Opening open, double iso) : open_(std::move(open)), iso_(iso) {}

  std::unique_ptr<VolumeReader> open() const { return open_(); }
  double iso() const { return iso_; }
  Limits limits() const {
    const VolumeInfo info = open()->info();
    return {info.dims[0], info.dims[1]};
  }
  StreamLabel label() const {
    const VolumeInfo info = open()->info();
    const auto spacing = spacing_nm(info.spacing_mm);
    return {info.dims[2], {spacing[0], spacing[1], spacing[2]}};
  }
  FaceMesh classic() const { return classic_mesh(*open(), {{iso_}, Border::closed}); }

  Stream polygons() const {
    Stream stream{{}, Extractor16::minimum_bytes(limits())};
    Encoder encoder;
    require(encoder.start(label(), output_to(stream.bytes)));
    extract(*open(), {{iso_}, Border::closed}, make_sink(encoder));
    return stream;
  }

  Stream slices(std::uint8_t levels, std::uint32_t key_slice_interval) const {
    Stream stream{};
    const auto volume = open();
    SliceEncoderConfig config;
    config.limits = limits();
    config.thresholds[0] = stored_threshold(volume->info(), iso_);
    config.key_slice_interval = key_slice_interval;
    config.label = label();
    config.levels = levels;
    with_scanner_type(volume->info().type, [&](auto type) {
      using Sample = decltype(type);
      if (levels == 0)
        encode<SliceEncoder, Sample>(*volume, config, stream);
      else
        encode<FractionSliceEncoder<Sample>, Sample>(*volume, config, stream);
    });
    return stream;
  }

 private:
  template <class SampleEncoder, class Sample>
  static void encode(VolumeReader& volume, const SliceEncoderConfig& config, Stream& stream) {
    stream.memory = SampleEncoder::minimum_bytes(config);
    std::vector<std::uint8_t> memory(stream.memory);
    auto encoder = std::make_unique<SampleEncoder>();
    require(encoder->start(config, {memory.data(), memory.size()}, output_to(stream.bytes)));
    std::vector<Sample> slice(volume.info().slice_bytes() / sizeof(Sample));
    for (std::uint32_t z = 0; z < volume.info().dims[2]; ++z) {
      volume.read_slice(slice.data());
      require(encoder->push(slice.data(), static_cast<std::uint32_t>(slice.size())).status);
    }
    require(encoder->finish());
  }

  Opening open_;
  double iso_;
};

// Reads a generated volume.
class GeneratedReader final : public VolumeReader {
 public:
  explicit GeneratedReader(const bench::Volume& volume) {
    info_.dims = {volume.width, volume.height, volume.depth};
    info_.spacing_mm = {1, 1, 1};
    std::visit(
        [this](const auto& samples) {
          info_.type = meshing::type_of<std::decay_t<decltype(samples[0])>>();
          next_ = reinterpret_cast<const std::uint8_t*>(samples.data());
        },
        volume.samples);
  }
  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override {
    std::memcpy(samples, next_, info_.slice_bytes());
    next_ += info_.slice_bytes();
  }

 private:
  VolumeInfo info_;
  const std::uint8_t* next_ = nullptr;
};

FaceMesh mesh_of(const ReceivedFractions& received, const Crossings* crossings) {
  return build_mesh(received.surface(), {true, Faces::triangles, crossings, 0});
}

std::vector<Point> normals_of(const FaceMesh& mesh) {
  std::vector<Point> normals(mesh.vertices_mm.size());
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const Point area = area_vector(mesh, face);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis) normals[mesh.face(face)[i]][axis] += area[axis];
  }
  for (Point& normal : normals) normal = unit_or_zero(normal);
  return normals;
}

// The mean angle at the crossings of both meshes. Units: degrees.
double mean_angle(const FaceMesh& mesh, const FaceMesh& exact) {
  const std::vector<Point> normals = normals_of(mesh), exact_normals = normals_of(exact);
  std::unordered_map<Vertex, std::size_t, VertexHash> indexes;
  for (std::size_t i = 0; i < exact.lattice.size(); ++i) indexes.emplace(exact.lattice[i], i);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const Vertex& at = mesh.lattice[i];
    const auto found = indexes.find(at);
    if ((at.x & at.y & at.z & 1) != 0 || found == indexes.end()) continue;
    sum += std::acos(std::clamp(dot(normals[i], exact_normals[found->second]), -1.0, 1.0));
    ++count;
  }
  constexpr double degrees = 57.29577951308232;
  return sum / static_cast<double>(count) * degrees;
}

// Units: edges.
double mean_distance_along(const Crossings& crossings, const Crossings& exact) {
  double sum = 0;
  std::size_t count = 0;
  crossings.for_each([&](Crossings::Id id, const Vertex& middle) {
    const auto found = exact.find(middle);
    if (!found) return;
    sum +=
        std::abs(static_cast<double>(crossings.at(id)) - static_cast<double>(exact.at(*found))) / 2;
    ++count;
  });
  return sum / static_cast<double>(count);
}

CrossingFinder crossings_of(const Scan& scan) {
  const auto volume = scan.open();
  CrossingFinder finder(volume->info(), {scan.iso()});
  std::vector<std::uint8_t> slice(volume->info().slice_bytes());
  for (std::uint32_t z = 0; z < volume->info().dims[2]; ++z) {
    volume->read_slice(slice.data());
    finder.add_slice(slice.data());
  }
  return finder;
}

// Lossless, each slice alone, if built with CharLS.
void print_samples(const Scan& scan) {
#ifdef DISCMC_WITH_CHARLS
  const auto volume = scan.open();
  const VolumeInfo& info = volume->info();
  const auto bits = static_cast<std::int32_t>(8 * sample_bytes(info.type));
  std::vector<std::uint8_t> slice(info.slice_bytes()), packed(2 * info.slice_bytes() + 4096);
  std::uint64_t bytes = 0;
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume->read_slice(slice.data());
    charls::jpegls_encoder encoder;
    encoder.frame_info({info.dims[0], info.dims[1], bits, 1});
    encoder.destination(packed);
    bytes += encoder.encode(slice);
  }
  std::printf("samples, JPEG-LS lossless | %llu | - | - | 0 | 0 | 0 | 0 |\n",
              static_cast<unsigned long long>(bytes));
#else
  static_cast<void>(scan);
  std::puts("samples | not measured: the program has no CharLS | - | - | 0 | 0 | 0 | 0 |");
#endif
}

// The mesh of the samples, if built with VTK.
std::optional<FaceMesh> flying_edges(const Scan& scan) {
#ifdef DISCMC_WITH_VTK
  return bench::flying_edges(*scan.open(), scan.iso() - 0.5);
#else
  static_cast<void>(scan);
  return std::nullopt;
#endif
}

// The rows of one volume.
class Rows {
 public:
  Rows(const std::string& name, const Scan& scan) : scan_(scan), name_(name) {}

  void print() {
    begin_row();
    print_samples(scan_);
    const Stream polygons = scan_.polygons();
    const ReceivedFractions received(polygons.bytes);
    const CrossingFinder finder = crossings_of(scan_);
    exact_ = &finder.crossings();
    exact_mesh_ = mesh_of(received, exact_);
    classic_ = scan_.classic();
    print_flying_edges();
    print_row("polygons", polygons, received.crossings(), mesh_of(received, nullptr));
    for (const int levels : {0, 2, 4}) print_slices(static_cast<std::uint8_t>(levels));
  }

 private:
  void print_flying_edges() {
    const std::optional<FaceMesh> mesh = flying_edges(scan_);
    if (!mesh) return;
    begin_row();
    std::printf("samples, FlyingEdges3D | - | - | %zu | - |", mesh->face_count());
    print_errors(*mesh);
  }

  void print_slices(std::uint8_t levels) {
    const Stream stream = scan_.slices(levels, 0);
    const ReceivedFractions received(stream.bytes);
    const std::string name = levels == 0 ? "slices" : std::to_string(levels) + " levels";
    for (const bool relaxes : {false, true}) {
      if (levels == 0 && !relaxes) continue;
      Crossings crossings = received.crossings();
      if (relaxes) relax(crossings, received.surface(), {Border::closed, 0, {}});
      print_row(name + (relaxes ? ", relaxed" : ""), stream, crossings,
                mesh_of(received, &crossings));
    }
    begin_row();
    std::printf("%s, every 16th a key slice | %zu | | | | | | |\n", name.c_str(),
                scan_.slices(levels, 16).bytes.size());
  }

  void print_row(const std::string& stream_name, const Stream& stream, const Crossings& crossings,
                 const FaceMesh& mesh) {
    begin_row();
    std::printf("%s | %zu | %llu | %zu | %.2f |", stream_name.c_str(), stream.bytes.size(),
                static_cast<unsigned long long>(stream.memory), mesh.face_count(),
                mean_distance_along(crossings, *exact_));
    print_errors(mesh);
  }

  void print_errors(const FaceMesh& mesh) {
    const Distances from = distances(mesh, classic_);
    std::printf(" %.3f | %.2f | %.1f |\n", from.mean, from.largest, mean_angle(mesh, exact_mesh_));
    std::fflush(stdout);
  }

  void begin_row() { std::printf("| %s | ", std::exchange(name_, "").c_str()); }

  const Scan& scan_;
  std::string name_;  // of the first row
  const Crossings* exact_ = nullptr;
  FaceMesh exact_mesh_, classic_;
};

void print_file(const std::string& argument) {
  const std::size_t colon = argument.rfind(':');
  const std::string file = argument.substr(0, colon), iso = argument.substr(colon + 1);
  const Scan scan([&] { return open_volume(file, {}); }, std::stod(iso));
  Rows(file.substr(file.find_last_of('/') + 1) + " at " + iso, scan).print();
}

void print_generated(const bench::Volume& volume) {
  const Scan scan([&] { return std::make_unique<GeneratedReader>(volume); }, volume.threshold);
  Rows(volume.name, scan).print();
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 2 && std::strcmp(arguments[1], "--help") == 0) {
    std::fputs(usage, stdout);
    return 0;
  }
  std::puts(
      "| volume | stream | bytes | least memory | triangles | of an edge | mean distance, mm | "
      "largest | normals, degrees |\n|---|---|--:|--:|--:|--:|--:|--:|--:|");
  try {
    for (int i = 1; i < count; ++i) print_file(arguments[i]);
    print_generated(bench::ball(128));
    print_generated(bench::noisy_ball(128));
    print_generated(bench::gyroid(128));
    print_generated(bench::smooth_noise(64));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_streams: %s\n", error.what());
    return 1;
  }
  return 0;
}

// How far the surface of a stream is from that of the samples, and in how many bytes.
//
//   bench_stream_distances cthead.nrrd:500 engine.nii.gz:80

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/fraction_slice_encoder.hpp>

#include "extraction/classic.hpp"
#include "extraction/crossings.hpp"
#include "extraction/extraction.hpp"
#include "meshes/mesh.hpp"
#include "meshes/surface_distance.hpp"
#include "require.hpp"
#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"
#include "smoothing/relaxed_crossings.hpp"
#include "streams/sent_fractions.hpp"
#include "streams/stream_reader.hpp"
#include "surface/joined_surface.hpp"
#include "volumes/volume.hpp"

#ifdef DISCMC_WITH_CHARLS
#include <charls/charls.h>
#endif

using namespace discmc;
using namespace discmc::command;

namespace {

constexpr const char* usage =
    R"(usage: bench_stream_distances FILE:THRESHOLD...

Prints for each volume of u8, u16 or i16 samples, in Markdown: the bytes of its streams, the memory of their
encoders, and how far their meshes are from classic Marching Cubes (as discmc compare), with tolerance 0. Normals are those
of vertices by the areas around them, beside those of the interpolated mesh.

Exit status: 0, or 1 if a file could not be read, or 2 without a file.
)";

using Bytes = std::vector<std::uint8_t>;

struct Stream {
  Bytes bytes;
  std::uint64_t memory;  // of the encoder, at least
};

ByteOutput output_to(Bytes& bytes) {
  return {&bytes, [](void* context, const std::uint8_t* written, std::size_t count) {
            auto& all = *static_cast<Bytes*>(context);
            all.insert(all.end(), written, written + count);
            return count;
          }};
}

class Scan {
 public:
  Scan(std::string file, double iso) : file_(std::move(file)), iso_(iso) {}

  std::unique_ptr<VolumeReader> open() const { return open_volume(file_, {}); }
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

  Stream slices(std::uint8_t levels) const {
    Stream stream{};
    const auto volume = open();
    SliceEncoderConfig config;
    config.limits = limits();
    config.thresholds[0] = stored_threshold(volume->info(), iso_);
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

  std::string file_;
  double iso_;
};

class Received {
 public:
  explicit Received(const Bytes& bytes) : reader_(make_sink(*this)) {
    reader_.push(bytes.data(), bytes.size());
    reader_.finish();
    joined_.finish();
    joined_.surface().spacing_mm = spacing_mm(reader_.header());
  }
  Received(const Received&) = delete;
  Received& operator=(const Received&) = delete;

  SinkResult accept(const Event& event) {
    fractions_.accept(event);
    return joined_.accept(event);
  }

  FaceMesh mesh(bool moves, bool relaxes) const {
    Crossings crossings(reader_.dims(), joined_.surface().polygons);
    if (moves) fractions_.place(crossings);
    if (relaxes) relax(crossings, joined_.surface(), {Border::closed, 0, {}});
    return build_mesh(joined_.surface(),
                      {true, Faces::triangles, moves || relaxes ? &crossings : nullptr, 0});
  }
  /// The mesh of the samples.
  FaceMesh mesh(const CrossingFinder& finder) const {
    return build_mesh(joined_.surface(), {true, Faces::triangles, &finder.crossings(), 0});
  }

 private:
  JoinedSurface joined_;
  SentFractions fractions_;
  StreamReader reader_;
};

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

// The mean angle at the crossings that both meshes have. Units: degrees.
double mean_angle(const FaceMesh& mesh, const FaceMesh& exact) {
  const std::vector<Point> normals = normals_of(mesh), exact_normals = normals_of(exact);
  std::unordered_map<Vertex, std::size_t, VertexHash> places;
  for (std::size_t i = 0; i < exact.lattice.size(); ++i) places.emplace(exact.lattice[i], i);
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.lattice.size(); ++i) {
    const Vertex& at = mesh.lattice[i];
    const auto found = places.find(at);
    if ((at.x & at.y & at.z & 1) != 0 || found == places.end()) continue;
    sum += std::acos(std::clamp(dot(normals[i], exact_normals[found->second]), -1.0, 1.0));
    ++count;
  }
  constexpr double degrees = 57.29577951308232;
  return sum / static_cast<double>(count) * degrees;
}

void print_row(const std::string& name, const Stream& stream, const FaceMesh& mesh,
               const FaceMesh& exact, const FaceMesh& classic) {
  const Distances from = distances(mesh, classic);
  std::printf("| %s | %zu | %llu | %zu | %.3f | %.2f | %.1f |\n", name.c_str(), stream.bytes.size(),
              static_cast<unsigned long long>(stream.memory), mesh.face_count(), from.mean,
              from.largest, mean_angle(mesh, exact));
  std::fflush(stdout);
}

CrossingFinder crossings_of(const Scan& scan, double iso) {
  const auto volume = scan.open();
  CrossingFinder finder(volume->info(), {iso});
  std::vector<std::uint8_t> slice(volume->info().slice_bytes());
  for (std::uint32_t z = 0; z < volume->info().dims[2]; ++z) {
    volume->read_slice(slice.data());
    finder.add_slice(slice.data());
  }
  return finder;
}

// Lossless, each slice by itself, if the program has CharLS.
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
  std::printf("| samples, JPEG-LS | %llu | | | 0 | 0 | 0 |\n",
              static_cast<unsigned long long>(bytes));
#else
  static_cast<void>(scan);
#endif
}

void print_table(const std::string& file, double iso) {
  std::printf(
      "| %s at %g | bytes | RAM | triangles | mean distance, mm | largest | normals |\n"
      "|---|--:|--:|--:|--:|--:|--:|\n",
      file.substr(file.find_last_of('/') + 1).c_str(), iso);
  const Scan scan(file, iso);
  print_samples(scan);
  const FaceMesh classic = scan.classic();
  const Stream polygons = scan.polygons();
  const FaceMesh exact = Received(polygons.bytes).mesh(crossings_of(scan, iso));
  const Received of_polygons(polygons.bytes);
  print_row("polygons", polygons, of_polygons.mesh(false, false), exact, classic);
  for (const std::uint8_t levels : {std::uint8_t{0}, std::uint8_t{2}, std::uint8_t{4}}) {
    const Stream stream = scan.slices(levels);
    const Received received(stream.bytes);
    const std::string name = levels == 0 ? "slices" : std::to_string(levels) + " levels";
    if (levels > 0) print_row(name, stream, received.mesh(true, false), exact, classic);
    print_row(name + ", relaxed", stream, received.mesh(true, true), exact, classic);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs(usage, stderr);
    return 2;
  }
  try {
    for (int i = 1; i < count; ++i) {
      const std::string argument = arguments[i];
      const std::size_t colon = argument.rfind(':');
      print_table(argument.substr(0, colon), std::stod(argument.substr(colon + 1)));
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_stream_distances: %s\n", error.what());
    return 1;
  }
  return 0;
}

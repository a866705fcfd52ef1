// MeshReceiver: the bytes of a device, scan after scan.
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/placement.hpp>

#include "oracle/slice_stream.hpp"
#include "sampled_shapes.hpp"
#include "test.hpp"

using namespace discmc;
using namespace mesh_tests;
using discmc::test::Bytes;

namespace {

// A volume with many regions, so that a part of the stream has some of them.
reference::BitVolume volume() {
  return reference::random({14, 13, 12}, 150, 7);
}

Bytes region_stream(std::uint16_t scan = 0) {
  StreamHeader header = test::header_of(volume());
  header.scan = scan;
  return test::encode(test::events_of(volume()), header);
}

std::vector<Bytes> streams() {
  // Streams with ample memory, and with so little that fragments are loose.
  return {region_stream(),
          test::encode(test::events_of(volume(), minimum_capacities()), test::header_of(volume())),
          test::encode_slices(volume())};
}

void check_complete(const MeshReceiver& receiver) {
  MeshOptions options;
  options.polygons = true;
  const Mesh expected = mesh_of(array_of(volume()).view(), 1, options);
  const Mesh mesh = receiver.mesh(options);
  CHECK(receiver.report().is_complete());
  CHECK(rings_of(mesh) == rings_of(expected));
  CHECK(mesh.triangles.size() == expected.triangles.size());
  CHECK(measures_of(mesh).is_closed);
}

// Pushes all bytes in portions. Returns the number of completed scans.
std::size_t push(MeshReceiver& receiver, const Bytes& bytes, std::size_t chunk) {
  std::size_t scans = 0;
  for (std::size_t at = 0; at < bytes.size();) {
    at += receiver.push(bytes.data() + at, std::min(chunk, bytes.size() - at));
    if (receiver.has_ended()) ++scans;
  }
  return scans;
}

}  // namespace

TEST_CASE("streams of either kind, in portions of any size, yield the mesh of the volume") {
  for (const Bytes& bytes : streams())
    for (const std::size_t chunk : {std::size_t{1}, std::size_t{100}, bytes.size()}) {
      MeshReceiver receiver;
      CHECK_FALSE(receiver.has_ended());
      CHECK(push(receiver, bytes, chunk) == 1);
      CHECK(receiver.header().width == 14);
      check_complete(receiver);
    }
}

TEST_CASE("a partial mesh grows during the scan and is closed at the end of the scan") {
  for (const Bytes& bytes : streams()) {
    MeshReceiver receiver;
    std::size_t triangles = 0, grew = 0;
    for (std::size_t at = 0; at < bytes.size();) {
      at += receiver.push(bytes.data() + at, std::min(bytes.size() / 8, bytes.size() - at));
      const Mesh mesh = receiver.mesh();
      CHECK(mesh.triangles.size() >= triangles);
      CHECK((mesh.triangles.empty() == (receiver.polygon_count() == 0)));
      if (mesh.triangles.size() > triangles) ++grew;
      triangles = mesh.triangles.size();
    }
    CHECK(grew >= 2);
    CHECK(measures_of(receiver.mesh()).is_closed);
  }
}

TEST_CASE("each scan on a link ends at its trailer, and the next scan begins a new mesh") {
  Bytes link;
  for (const std::uint16_t scan : {std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}}) {
    const Bytes bytes = region_stream(scan);
    link.insert(link.end(), bytes.begin(), bytes.end());
  }
  MeshReceiver receiver;
  std::uint16_t scan = 0;
  for (std::size_t at = 0; at < link.size();) {
    at += receiver.push(link.data() + at, link.size() - at);
    REQUIRE(receiver.has_ended());
    CHECK(receiver.header().scan == ++scan);
    check_complete(receiver);
  }
  CHECK(scan == 3);
}

TEST_CASE("a lost packet is reported, and the mesh contains the polygons that arrived") {
  for (Bytes bytes : streams()) {
    const auto middle = std::find(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2),
                                  bytes.end(), std::uint8_t{0});
    bytes.erase(middle + 1, std::find(middle + 1, bytes.end(), std::uint8_t{0}) + 1);
    MeshReceiver receiver;
    CHECK(push(receiver, bytes, 64) == 1);
    const StreamReport report = receiver.report();
    CHECK_FALSE(report.is_complete());
    CHECK(report.lost_packets == 1);
    const Mesh mesh = receiver.mesh();
    CHECK(mesh.triangles.size() > 0);
    if (report.holds_slices) continue;
    // A region is lost if any of its fragments is lost.
    const std::uint64_t lost = test::decode(bytes).report.lost_pieces;
    CHECK(lost > 0);
    CHECK((report.fragments > 0 ? report.lost_pieces > lost : report.lost_pieces == lost));
  }
}

TEST_CASE("finish() ends a scan without a trailer, and the next push() begins another scan") {
  Bytes bytes = region_stream();
  const auto last = std::find(bytes.rbegin() + 1, bytes.rend(), std::uint8_t{0});
  MeshReceiver receiver;
  const Bytes cut(bytes.begin(), last.base());
  CHECK(push(receiver, cut, cut.size()) == 0);
  receiver.finish();
  CHECK(receiver.has_ended());
  CHECK_FALSE(receiver.report().has_trailer);
  CHECK(push(receiver, bytes, bytes.size()) == 1);
  CHECK(receiver.report().is_complete());
}

TEST_CASE("bytes without a valid stream yield no mesh, and a later stream is received") {
  MeshReceiver receiver;
  test::Chance chance(5);
  Bytes noise(5000);
  for (std::uint8_t& byte : noise) byte = chance.byte();
  noise.push_back(0);
  (void)push(receiver, noise, 77);
  CHECK(receiver.mesh().triangles.empty());
  CHECK(receiver.report().damaged_packets > 0);
  CHECK(push(receiver, region_stream(), 77) == 1);
  check_complete(receiver);
}

TEST_CASE("a receiver of a channel ignores other channels") {
  StreamHeader header = test::header_of(volume());
  header.channel = 3;
  const Bytes other = test::encode(test::events_of(volume()), header);
  MeshReceiver receiver(std::uint8_t{0});
  CHECK(push(receiver, other, other.size()) == 0);
  CHECK(receiver.polygon_count() == 0);
  CHECK(push(receiver, region_stream(), 100) == 1);
  CHECK(receiver.report().foreign_packets > 0);
  check_complete(receiver);
}

TEST_CASE("a receiver of a channel that no stream can have is refused") {
  CHECK_NOTHROW(MeshReceiver(std::uint8_t{63}));
  CHECK_THROWS_WITH_AS(MeshReceiver(std::uint8_t{100}), "the channel is 100; give 0 to 63",
                       std::invalid_argument);
}

TEST_CASE("the spacing and placement in a stream apply to the mesh unless the caller sets others") {
  StreamHeader header = test::header_of(volume());
  header.spacing_nm[0] = 2000000;
  const Bytes bytes = test::encode(test::events_of(volume()), header);
  const double volume_of_voxels = measures_of(mesh_of(array_of(volume()).view(), 1)).volume;
  MeshReceiver receiver;
  CHECK(push(receiver, bytes, bytes.size()) == 1);
  MeshOptions options;
  options.spacing = {7, 7, 7};
  CHECK(measures_of(receiver.mesh(options)).volume == doctest::Approx(2 * volume_of_voxels));
  options.placement = {{{{0, 1, 0, 5}, {1, 0, 0, 6}, {0, 0, 3, 7}}}};
  const Mesh placed = receiver.mesh(options);
  CHECK(measures_of(placed).volume == doctest::Approx(3 * volume_of_voxels));
  CHECK(signed_volume(placed) > 0);

  Placement placement;
  for (int axis = 0; axis < 3; ++axis) placement.axes_nm[axis][axis] = 4000000;
  placement.origin_nm[2] = 100000000;
  std::uint8_t record[Placement::record_bytes];
  test::Line line;
  Encoder encoder;
  REQUIRE(test::begin_stream(encoder, header, line.output()) == Status::ok);
  REQUIRE(encoder.write_record(record_of(placement, record)) == Status::ok);
  test::encode_all(encoder, test::events_of(volume()));
  while (encoder.flush() == Status::suspended) continue;
  MeshReceiver of_placed;
  CHECK(push(of_placed, line.bytes, line.bytes.size()) == 1);
  CHECK(measures_of(of_placed.mesh()).volume == doctest::Approx(64 * volume_of_voxels));
  CHECK(measures_of(of_placed.mesh()).least[2] >= 100 - 2);
}

TEST_CASE(
    "a received mesh can have polygons and normals, but options that read samples are refused") {
  MeshReceiver receiver;
  const Bytes bytes = region_stream();
  CHECK(push(receiver, bytes, bytes.size()) == 1);
  MeshOptions options;
  options.polygons = true;
  options.normals = Normals::surface;
  const Mesh mesh = receiver.mesh(options);
  CHECK(mesh.polygons.size() == receiver.polygon_count());
  CHECK(mesh.normals.size() == mesh.vertices.size());
  options = {};
  options.interpolates = true;
  CHECK_THROWS_WITH_AS((void)receiver.mesh(options), doctest::Contains("FractionSliceEncoder"),
                       std::invalid_argument);
}

TEST_CASE("a received mesh is interpolated if the stream contains fractions") {
  const auto array = ball<std::uint8_t>();
  SliceEncoderConfig config;
  config.limits = {20, 22};
  config.thresholds[0] = static_cast<std::int32_t>(ball_level);
  config.levels = 4;
  test::Line line;
  std::vector<std::uint8_t> memory(FractionSliceEncoder<std::uint8_t>::minimum_bytes(config));
  FractionSliceEncoder<std::uint8_t> encoder;
  REQUIRE(encoder.start(config, memory_of(memory), line.output()) == Status::ok);
  REQUIRE(
      encoder.push(array.samples.data(), static_cast<std::uint32_t>(array.samples.size())).status ==
      Status::ok);
  REQUIRE(encoder.finish() == Status::ok);
  MeshReceiver receiver;
  CHECK(push(receiver, line.bytes, 100) == 1);
  MeshOptions options;
  options.interpolates = true;
  options.tolerance = 0;
  const Mesh mesh = receiver.mesh(options);
  CHECK(measures_of(mesh).is_closed);
  double farthest = 0;
  for (const auto& vertex : mesh.vertices) {
    const auto radius = difference(vertex, ball_centre);
    farthest = std::max(farthest, std::abs(std::sqrt(dot(radius, radius)) - ball_radius));
  }
  CHECK(farthest < 0.3);  // 0.5 of midpoints
}

TEST_CASE(
    "relaxation of a received mesh yields the mesh of the volume, for either kind of stream") {
  const reference::BitVolume torus = reference::torus({30, 28, 12}, 18, 7);
  MeshOptions options;
  options.relaxes = true;
  options.tolerance = 0;
  const Mesh expected = mesh_of(array_of(torus).view(), 1, options);
  CHECK(measures_of(expected).is_closed);
  CHECK(sorted(expected.vertices) != sorted(mesh_of(array_of(torus).view(), 1).vertices));
  for (const Bytes& bytes :
       {test::encode(test::events_of(torus), test::header_of(torus)), test::encode_slices(torus)}) {
    MeshReceiver receiver;
    CHECK(push(receiver, bytes, bytes.size()) == 1);
    const Mesh mesh = receiver.mesh(options);
    CHECK(sorted(mesh.vertices) == sorted(expected.vertices));
    CHECK(measures_of(mesh).is_closed);
  }
}

TEST_CASE("a stream of an unknown version is refused") {
  const Bytes bytes = test::with_version(99, region_stream());
  MeshReceiver receiver;
  CHECK_THROWS_AS((void)push(receiver, bytes, 100), std::runtime_error);
}

TEST_CASE("a push() of zero bytes keeps the mesh of the finished scan") {
  const Bytes bytes = region_stream();
  MeshReceiver receiver;
  push(receiver, bytes, bytes.size());
  CHECK(receiver.push(nullptr, 0) == 0);
  CHECK(receiver.has_ended());
  check_complete(receiver);
}

TEST_CASE("a moved-from receiver throws, and the moved-to receiver continues") {
  const Bytes bytes = region_stream();
  MeshReceiver receiver;
  CHECK(receiver.push(bytes.data(), bytes.size() / 2) == bytes.size() / 2);
  MeshReceiver other = std::move(receiver);
  CHECK_THROWS_AS((void)receiver.push(bytes.data(), bytes.size()), std::logic_error);
  CHECK_THROWS_AS(receiver.finish(), std::logic_error);
  CHECK_THROWS_AS((void)receiver.has_ended(), std::logic_error);
  CHECK_THROWS_AS((void)receiver.report(), std::logic_error);
  CHECK_THROWS_AS((void)receiver.header(), std::logic_error);
  CHECK_THROWS_AS((void)receiver.polygon_count(), std::logic_error);
  CHECK_THROWS_WITH_AS((void)receiver.mesh(), "the receiver was moved from; construct another",
                       std::logic_error);
  CHECK(!other.has_ended());
  receiver = MeshReceiver();
  CHECK(receiver.polygon_count() == 0);
}

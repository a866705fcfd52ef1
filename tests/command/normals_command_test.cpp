// Normals of vertices from the command: sources, files, and conflicting options.
#include <discmc/normal_extractor.hpp>

#include "command.hpp"
#include "oracle/angle.hpp"
#include "oracle/ramp_ball.hpp"
#include "oracle/scan.hpp"
#include "oracle/stream.hpp"

namespace {

using namespace command_tests;
using discmc::meshing::Point;
using discmc::reference::degrees_between;

constexpr std::uint32_t extent = 16;
const std::string layout = " --dims 16,16,16 --type u16 --big-endian";
const std::vector<std::string> sources = {"surface", "gradient"};
const std::vector<std::string> formats = {"ply", "obj", "glb", "vtp"};

// A ball of radius 5, with a slope of 100 per voxel around 1000.
discmc::reference::SampleVolume<int> ball() {
  return discmc::reference::ramp_ball(extent, 5, {100, 1000, 2000});
}

// Big-endian, two bytes per sample.
const std::string ball_samples = [] {
  std::string samples;
  for (const int sample : ball().samples) {
    samples += static_cast<char>(sample >> 8);
    samples += static_cast<char>(sample & 0xFF);
  }
  return samples;
}();

std::string header(const std::string& space_directions) {
  return "NRRD0004\ntype: uint16\ndimension: 3\nsizes: 16 16 16\nencoding: raw\nendian: big\n"
         "space dimension: 3\nspace directions: " +
         space_directions + "\n\n";
}

// The stream of v.nrrd from a device with access to the samples: with normals.
std::string stream_with_normals() {
  using WithNormals = discmc::detail::trace::GradientIntake<std::uint16_t>;
  discmc::StreamHeader header;
  header.width = header.height = header.depth = extent;
  header.spacing_nm[0] = 500000;
  header.spacing_nm[1] = -1000000;
  header.spacing_nm[2] = 2000000;
  header.thresholds[0] = 1000;
  const discmc::Limits limits{extent, extent};
  const std::uint64_t minimum =
      discmc::detail::sizing::minimum_bytes<std::uint32_t, WithNormals>(limits);
  discmc::reference::Block block(minimum + (std::uint64_t{1} << 20));
  discmc::test::Line line;
  discmc::test::NormalEncoder encoder;
  discmc::reference::require_ok(encoder.start(header.label(), line.output()));
  discmc::NormalExtractor32<std::uint16_t> extractor;
  extractor.set_spacing(header.spacing_nm);
  discmc::reference::require_ok(
      extractor.start(limits, header.thresholds[0], block.memory(), discmc::make_sink(encoder)));
  std::vector<std::uint16_t> samples;
  for (const int sample : ball().samples) samples.push_back(static_cast<std::uint16_t>(sample));
  discmc::reference::push_all(extractor, samples);
  discmc::reference::finish_all(extractor);
  return std::string(line.bytes.begin(), line.bytes.end());
}

// v.raw and v.nrrd contain the same ball, v.dmc its stream.
struct Ball : Workshop {
  Ball() {
    write("v.raw", ball_samples);
    write("v.nrrd", header("(0.5,0,0) (0,-1,0) (0,0,2)") + ball_samples);
    done("extract v.nrrd --iso 1000 -o v.dmc");
  }
};

}  // namespace

TEST_CASE_FIXTURE(Ball, "decode and extract write the same normals") {
  for (const std::string& format : formats)
    for (const std::string& source : sources)
      for (const std::string mesh : {"", " --no-conforming"}) {
        const std::string normals = " --normals " + source + mesh;
        done("extract v.nrrd --iso 1000 -q -o e." + format + normals);
        done("decode v.dmc -o d." + format + normals +
             (source == "gradient" ? " --volume v.nrrd" : ""));
        CHECK(read("e." + format) == read("d." + format));
        const FileMesh written = mesh_in("d." + format);
        CHECK(written.normals.size() == written.vertices_mm.size());
        CHECK(!written.normals.empty());
      }
}

TEST_CASE_FIXTURE(
    Ball, "every mesh format with normals has the same normals, and none with --normals none") {
  for (const std::string& source : sources) {
    for (const std::string& format : formats)
      done("extract v.nrrd --iso 1000 -q --normals " + source + " -o v." + format);
    const FileMesh ply = mesh_in("v.ply");
    for (const std::string& format : formats) {
      const FileMesh mesh = mesh_in("v." + format);
      CHECK(mesh.corners == ply.corners);
      REQUIRE(mesh.normals.size() == ply.normals.size());
      for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Point apart = discmc::meshing::difference(mesh.normals[i], ply.normals[i]);
        CHECK(discmc::meshing::dot(apart, apart) < 1e-12);
      }
    }
  }
  for (const std::string& format : formats) {
    done("decode v.dmc -o plain." + format);
    done("decode v.dmc --normals none -o none." + format);
    CHECK(read("plain." + format) == read("none." + format));
    CHECK(mesh_in("none." + format).normals.empty());
  }
  for (const std::string format : {"stl", "3mf", "jsonl", "dmc"})
    done("decode v.dmc --normals none -o none." + format);
}

TEST_CASE_FIXTURE(Ball, "a format without normals of vertices is refused before anything is read") {
  for (const std::string& source : sources) {
    const std::string normals = " --normals " + source;
    for (const std::string name : {"no.stl", "no.jsonl"}) {
      for (const std::string command : {"extract no.nrrd --iso 1", "decode no.dmc"})
        fails(command + " -o " + name + normals, 2,
              {"--normals", name, ".ply, .obj, .glb or .vtp"});
    }
    for (const std::string output : {" -o no.dmc", " -o -"})
      fails("decode no.dmc" + output + normals, 2,
            {"--normals", "stream", ".ply, .obj, .glb or .vtp"});
  }
  for (const std::string output : {"", " -o no.dmc", " -o -"})
    fails("extract no.nrrd --iso 1 --normals surface" + output, 2,
          {"--normals", "stream", "--normals gradient", ".ply, .obj, .glb or .vtp"});
  for (const std::string command : {"extract no.nrrd --iso 1", "decode no.dmc"})
    fails(command + " -o no.ply --normals smooth", 2, {"--normals", "smooth"});
}

TEST_CASE_FIXTURE(Ball, "--volume requires --normals gradient, and a layout requires --volume") {
  for (const std::string normals : {"", " --normals surface", " --normals none"})
    fails("decode no.dmc -o no.ply --volume no.nrrd" + normals, 2,
          {"--volume", "--normals gradient"});
  fails("decode no.dmc -o no.ply --normals gradient" + layout, 2, {"--dims", "--volume"});
  for (const std::string option : {"--frame 1", "--channel 1", "--spacing 1,1,1", "--series 2"})
    fails("decode no.dmc -o no.ply " + option, 2, {"--volume"});
  fails("decode no.dmc -o no.ply --normals gradient --volume no.raw --dims 1,1,1", 2,
        {"--dims", "--type"});
}

TEST_CASE_FIXTURE(
    Ball,
    "decode --normals gradient requires the stream's own volume if the stream has no normals") {
  const std::string decode = "decode v.dmc -o no.ply --normals gradient";
  fails(decode, 1, {"v.dmc", "--volume FILE", "--normals surface"});
  fails(decode + " --volume no.nrrd", 1, {"no.nrrd"});
  write("cut.nrrd", header("(0.5,0,0) (0,-1,0) (0,0,2)") + ball_samples.substr(0, 8000));
  fails(decode + " --volume cut.nrrd", 1, {"cut.nrrd", "slice 15"});
  fails(decode + " --volume v.raw --dims 16,8,32 --type u16", 1,
        {"v.raw", "16x8x32", "16x16x16", "the volume that the stream was made of"});
  write("turned.nrrd", header("(0.5,0,0) (0,1,0) (0,0,2)") + ball_samples);
  fails(decode + " --volume turned.nrrd", 1, {"turned.nrrd", "0.5,1,2 mm", "0.5,-1,2 mm"});
}

TEST_CASE_FIXTURE(Ball, "normals in a stream equal those of its volume, in two bytes each") {
  write("normals.dmc", stream_with_normals());
  for (const std::string mesh : {"", " --no-conforming"}) {
    const std::string gradient = " -o v.ply --normals gradient" + mesh;
    done("decode v.dmc --volume v.nrrd" + gradient);
    const std::string of_volume = read("v.ply");
    done("decode normals.dmc --volume v.nrrd" + gradient);
    CHECK(read("v.ply") == of_volume);
    done("decode normals.dmc" + gradient);
    const FileMesh decoded = mesh_in("v.ply"), exact = mesh_of_ply(of_volume);
    REQUIRE(decoded.vertices_mm == exact.vertices_mm);
    double worst = 0;
    for (std::size_t i = 0; i < decoded.normals.size(); ++i)
      worst = std::max(worst, degrees_between(decoded.normals[i], exact.normals[i]));
    CHECK(worst > 0.1);
    CHECK(worst < 0.97);
  }
}

TEST_CASE_FIXTURE(
    Ball, "extract writes the same stream with normals as a device, and decode keeps the normals") {
  done("extract v.nrrd --iso 1000 --normals gradient -o normals.dmc");
  CHECK(read("normals.dmc") == stream_with_normals());
  done("decode normals.dmc -o again.dmc");
  CHECK(read("again.dmc") == read("normals.dmc"));
  CHECK(read("normals.dmc").size() > read("v.dmc").size());
}

TEST_CASE_FIXTURE(Ball,
                  "decode gives each vertex of an incomplete stream a normal from the volume") {
  const std::string stream = read("v.dmc");
  auto frames = discmc::test::frames_of(discmc::test::Bytes(stream.begin(), stream.end()));
  REQUIRE(frames.size() > 3);
  frames.resize(frames.size() - 2);
  const discmc::test::Bytes bytes = discmc::test::joined(frames);
  write("cut.dmc", std::string(bytes.begin(), bytes.end()));
  const Result result = run("decode cut.dmc -o v.ply --normals gradient --volume v.nrrd");
  CHECK(result.code == 3);
  const FileMesh mesh = mesh_in("v.ply");
  CHECK(mesh.normals.size() == mesh.vertices_mm.size());
}

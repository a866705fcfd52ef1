// Normals of vertices from the command: their sources, their files, and what does not go together.
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

// A ball of radius 5 with a ramp of 100 a voxel about 1000.
discmc::reference::SampleVolume<int> ball() {
  return discmc::reference::ramp_ball(extent, 5, {100, 1000, 2000});
}

// Big-endian, two bytes a sample.
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

// The stream of v.nrrd as a device makes it that has the samples at hand: with normals.
std::string stream_with_normals() {
  using WithNormals = discmc::GradientIntake<std::uint16_t>;
  discmc::StreamHeader header;
  header.width = header.height = header.depth = extent;
  header.spacing_nm[0] = 500000;
  header.spacing_nm[1] = -1000000;
  header.spacing_nm[2] = 2000000;
  header.thresholds[0] = 1000;
  const discmc::Limits limits{extent, extent};
  const std::uint64_t least =
      discmc::detail::sizing::minimum_bytes<std::uint32_t, WithNormals>(limits);
  discmc::reference::Block block(least + (std::uint64_t{1} << 20));
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

// v.raw and v.nrrd hold the same ball, v.dmc its stream.
void write_ball(const Workshop& workshop) {
  workshop.write("v.raw", ball_samples);
  workshop.write("v.nrrd", header("(0.5,0,0) (0,-1,0) (0,0,2)") + ball_samples);
  workshop.done("extract v.nrrd --iso 1000 -o v.dmc");
}

FileMesh mesh_in(const Workshop& workshop, const std::string& name) {
  return mesh_of(name, workshop.read(name));
}

void check_refusal(const Workshop& workshop, int code, const std::string& arguments,
                   const std::vector<std::string>& parts) {
  const auto before = workshop.names();
  const Result result = workshop.run(arguments);
  INFO(arguments, "\n", result.error);
  CHECK(result.code == code);
  CHECK(result.out.empty());
  for (const std::string& part : parts) CHECK(contains(result.error, part));
  CHECK(workshop.names() == before);
}

}  // namespace

TEST_CASE("decode and extract write the same normals") {
  const Workshop workshop;
  write_ball(workshop);
  for (const std::string& format : formats)
    for (const std::string& source : sources)
      for (const std::string mesh : {"", " --no-conforming"}) {
        const std::string normals = " --normals " + source + mesh;
        workshop.done("extract v.nrrd --iso 1000 -q -o e." + format + normals);
        workshop.done("decode v.dmc -o d." + format + normals +
                      (source == "gradient" ? " --volume v.nrrd" : ""));
        CHECK(workshop.read("e." + format) == workshop.read("d." + format));
        const FileMesh written = mesh_in(workshop, "d." + format);
        CHECK(written.normals.size() == written.vertices_mm.size());
        CHECK(!written.normals.empty());
      }
}

TEST_CASE("every format holds the same normals, and without a source there are none") {
  const Workshop workshop;
  write_ball(workshop);
  for (const std::string& source : sources) {
    for (const std::string& format : formats)
      workshop.done("extract v.nrrd --iso 1000 -q --normals " + source + " -o v." + format);
    const FileMesh ply = mesh_in(workshop, "v.ply");
    for (const std::string& format : formats) {
      const FileMesh mesh = mesh_in(workshop, "v." + format);
      CHECK(mesh.corners == ply.corners);
      REQUIRE(mesh.normals.size() == ply.normals.size());
      for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
        const Point apart = discmc::meshing::difference(mesh.normals[i], ply.normals[i]);
        CHECK(discmc::meshing::dot(apart, apart) < 1e-12);
      }
    }
  }
  for (const std::string& format : formats) {
    workshop.done("decode v.dmc -o plain." + format);
    workshop.done("decode v.dmc --normals none -o none." + format);
    CHECK(workshop.read("plain." + format) == workshop.read("none." + format));
    CHECK(mesh_in(workshop, "none." + format).normals.empty());
  }
  for (const std::string format : {"stl", "3mf", "jsonl", "dmc"})
    workshop.done("decode v.dmc --normals none -o none." + format);
}

TEST_CASE("a format without normals of vertices is refused before anything is read") {
  const Workshop workshop;
  for (const std::string& source : sources) {
    const std::string normals = " --normals " + source;
    for (const std::string name : {"no.stl", "no.jsonl"}) {
      for (const std::string command : {"extract no.nrrd --iso 1", "decode no.dmc"})
        check_refusal(workshop, 2, command + " -o " + name + normals,
                      {"--normals", name, ".ply, .obj, .glb or .vtp"});
    }
    for (const std::string output : {" -o no.dmc", " -o -"})
      check_refusal(workshop, 2, "decode no.dmc" + output + normals,
                    {"--normals", "stream", ".ply, .obj, .glb or .vtp"});
  }
  for (const std::string output : {"", " -o no.dmc", " -o -"})
    check_refusal(workshop, 2, "extract no.nrrd --iso 1 --normals surface" + output,
                  {"--normals", "stream", "--normals gradient", ".ply, .obj, .glb or .vtp"});
  for (const std::string command : {"extract no.nrrd --iso 1", "decode no.dmc"})
    check_refusal(workshop, 2, command + " -o no.ply --normals smooth", {"--normals", "smooth"});
}

TEST_CASE("a volume is for gradient normals, and its layout for a volume") {
  const Workshop workshop;
  for (const std::string normals : {"", " --normals surface", " --normals none"})
    check_refusal(workshop, 2, "decode no.dmc -o no.ply --volume no.nrrd" + normals,
                  {"--volume", "--normals gradient"});
  check_refusal(workshop, 2, "decode no.dmc -o no.ply --normals gradient" + layout,
                {"--dims", "--volume"});
  for (const std::string option : {"--frame 1", "--channel 1", "--spacing 1,1,1", "--series 2"})
    check_refusal(workshop, 2, "decode no.dmc -o no.ply " + option, {"--volume"});
  check_refusal(workshop, 2,
                "decode no.dmc -o no.ply --normals gradient --volume no.raw --dims 1,1,1",
                {"--dims", "--type"});
}

TEST_CASE("a stream without normals asks for its volume, and only for its own") {
  const Workshop workshop;
  write_ball(workshop);
  const std::string decode = "decode v.dmc -o no.ply --normals gradient";
  check_refusal(workshop, 1, decode, {"v.dmc", "--volume FILE", "--normals surface"});
  check_refusal(workshop, 1, decode + " --volume no.nrrd", {"no.nrrd"});
  workshop.write("cut.nrrd", header("(0.5,0,0) (0,-1,0) (0,0,2)") + ball_samples.substr(0, 8000));
  check_refusal(workshop, 1, decode + " --volume cut.nrrd", {"cut.nrrd", "slice 15"});
  check_refusal(workshop, 1, decode + " --volume v.raw --dims 16,8,32 --type u16",
                {"v.raw", "16x8x32", "16x16x16", "the volume that the stream was made of"});
  workshop.write("turned.nrrd", header("(0.5,0,0) (0,1,0) (0,0,2)") + ball_samples);
  check_refusal(workshop, 1, decode + " --volume turned.nrrd",
                {"turned.nrrd", "0.5,1,2 mm", "0.5,-1,2 mm"});
}

TEST_CASE("normals in a stream are those of its volume, in two bytes each") {
  const Workshop workshop;
  write_ball(workshop);
  workshop.write("told.dmc", stream_with_normals());
  for (const std::string mesh : {"", " --no-conforming"}) {
    const std::string gradient = " -o v.ply --normals gradient" + mesh;
    workshop.done("decode v.dmc --volume v.nrrd" + gradient);
    const std::string of_volume = workshop.read("v.ply");
    workshop.done("decode told.dmc --volume v.nrrd" + gradient);
    CHECK(workshop.read("v.ply") == of_volume);
    workshop.done("decode told.dmc" + gradient);
    const FileMesh told = mesh_in(workshop, "v.ply"), exact = mesh_of_ply(of_volume);
    REQUIRE(told.vertices_mm == exact.vertices_mm);
    double worst = 0;
    for (std::size_t i = 0; i < told.normals.size(); ++i)
      worst = std::max(worst, degrees_between(told.normals[i], exact.normals[i]));
    CHECK(worst > 0.1);
    CHECK(worst < 0.97);
  }
}

TEST_CASE("extract writes the normals that a device sends, and decode keeps them in a stream") {
  const Workshop workshop;
  write_ball(workshop);
  workshop.done("extract v.nrrd --iso 1000 --normals gradient -o told.dmc");
  CHECK(workshop.read("told.dmc") == stream_with_normals());
  workshop.done("decode told.dmc -o again.dmc");
  CHECK(workshop.read("again.dmc") == workshop.read("told.dmc"));
  CHECK(workshop.read("told.dmc").size() > workshop.read("v.dmc").size());
}

TEST_CASE("an incomplete stream has normals where it has a surface") {
  const Workshop workshop;
  write_ball(workshop);
  const std::string stream = workshop.read("v.dmc");
  auto frames = discmc::test::frames_of(discmc::test::Bytes(stream.begin(), stream.end()));
  REQUIRE(frames.size() > 3);
  frames.resize(frames.size() - 2);
  const discmc::test::Bytes bytes = discmc::test::joined(frames);
  workshop.write("cut.dmc", std::string(bytes.begin(), bytes.end()));
  const Result result = workshop.run("decode cut.dmc -o v.ply --normals gradient --volume v.nrrd");
  CHECK(result.code == 3);
  const FileMesh mesh = mesh_in(workshop, "v.ply");
  CHECK(mesh.normals.size() == mesh.vertices_mm.size());
}

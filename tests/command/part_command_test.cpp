// Commands for a part of a volume, or for fewer voxels.

#include "command.hpp"
#include "oracle/ramp_ball.hpp"

namespace {

using namespace command_tests;

constexpr std::uint32_t extent = 16;
const std::string layout = " --dims 16,16,16 --type u16 ";
// The first range cuts the ball.
const std::string crop = " --crop 6..,..14,2..13 ";
const std::string part_dims = " --dims 10,15,12 --type u16 ";

// A ball of radius 5, with a slope of 100 per voxel around 1000.
std::vector<std::uint16_t> ball() {
  const auto volume = discmc::reference::ramp_ball(extent, 5, {100, 1000, 2000});
  return {volume.samples.begin(), volume.samples.end()};
}

std::vector<std::uint16_t> part() {
  const auto whole = ball();
  std::vector<std::uint16_t> samples;
  for (std::size_t z = 2; z <= 13; ++z)
    for (std::size_t y = 0; y <= 14; ++y)
      for (std::size_t x = 6; x < extent; ++x)
        samples.push_back(whole[(z * extent + y) * extent + x]);
  return samples;
}

struct Volumes : Workshop {
  Volumes() {
    write("v.raw", volume_files::bytes_of(ball()));
    write("part.raw", volume_files::bytes_of(part()));
  }
};

const std::string turned =
    "NRRD0004\ntype: uint16\ndimension: 3\nsizes: 16 16 16\nencoding: raw\nendian: little\n"
    "space: LPS\nspace directions: (0,2,0) (-3,0,0) (0,0.6,0.8)\nspace origin: (10,-20,30.5)\n\n";

// The positions of a mesh in micrometres, sorted, because vertices may have another order.
std::vector<std::array<long, 3>> places(const FileMesh& mesh) {
  std::vector<std::array<long, 3>> sorted;
  for (const std::uint32_t corner : mesh.corners) {
    const Point& at = mesh.vertices_mm[corner];
    sorted.push_back(
        {std::lround(1e3 * at[0]), std::lround(1e3 * at[1]), std::lround(1e3 * at[2])});
  }
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

void check_same_places(const FileMesh& a, const FileMesh& b) {
  CHECK(a.vertices_mm.size() == b.vertices_mm.size());
  CHECK(a.face_begin == b.face_begin);
  CHECK(places(a) == places(b));
}

}  // namespace

TEST_CASE_FIXTURE(Volumes, "--crop gives the same results as a file with only that part") {
  const std::vector<std::string> surfaces = {
      "extract VOLUME --iso 1000 -q -o OUT.jsonl",
      "extract VOLUME --iso 1000 --space voxel --normals gradient -q -o OUT.ply",
      "extract VOLUME --iso 1000 --space voxel --surface interpolated -q -o OUT.stl",
      "render VOLUME --iso 1000 --size 64,64 -o OUT.png",
      "render VOLUME --iso 1000 --size 64,64 --shade smooth -o OUT.png",
      "render VOLUME --iso 1000 --size 64,64 --classic -o OUT.png"};
  for (const std::string& line : surfaces) {
    INFO(line);
    const auto made = [&](const std::string& volume, const std::string& name) {
      std::string arguments = line;
      arguments.replace(arguments.find("VOLUME"), 6, volume);
      arguments.replace(arguments.find("OUT"), 3, name);
      done(arguments);
      return read(name + line.substr(line.rfind('.')));
    };
    CHECK(made("v.raw" + layout + crop, "cropped") == made("part.raw" + part_dims, "part"));
  }
}

TEST_CASE_FIXTURE(Volumes, "a cropped volume keeps its position in meshes and through streams") {
  write("turned.nrrd", turned + volume_files::bytes_of(ball()));
  write("v.raw", volume_files::bytes_of(ball()));
  for (const std::string& volume :
       {std::string("turned.nrrd "), "v.raw --spacing 1,2,-3" + layout}) {
    INFO(volume);
    const std::string extract = "extract " + volume + "--iso 1000 -q ";
    const std::string around = "--crop 1..15,2..,..14 ";
    done(extract + "-o whole.obj");
    done(extract + around + "-o part.obj");
    check_same_places(mesh_in("part.obj"), mesh_in("whole.obj"));
    for (const std::string wire : {"regions", "slices"}) {
      done(extract + around + "--wire " + wire + " -o part.dmc");
      done("decode part.dmc -o decoded.obj");
      check_same_places(mesh_in("decoded.obj"), mesh_in("whole.obj"));
    }
  }
}

TEST_CASE_FIXTURE(Volumes, "a ball extracted with --shrink keeps its size and position") {
  write("turned.nrrd", turned + volume_files::bytes_of(ball()));
  for (const std::string part : {"", "--crop 1..,1..14,2.. "}) {
    done("extract turned.nrrd --iso 1000 --shrink 2 " + part +
         "--surface interpolated -o shrunk.obj");
    const FileMesh mesh = mesh_in("shrunk.obj");
    const double voxel = 2 * 3 * 0.8, ball = 4.18879 * 125 * voxel;
    CHECK(volume_of(mesh) == doctest::Approx(ball).epsilon(0.15));
    // The middle is voxel (7.5, 7.5, 7.5).
    const Point middle = {10 - 3 * 7.5, -20 + 2 * 7.5 + 0.6 * 7.5, 30.5 + 0.8 * 7.5};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto less = [i](const Point& a, const Point& b) { return a[i] < b[i]; };
      const auto [low, high] =
          std::minmax_element(mesh.vertices_mm.begin(), mesh.vertices_mm.end(), less);
      CHECK(std::fabs(((*low)[i] + (*high)[i]) / 2 - middle[i]) < 0.3);
    }
  }
}

TEST_CASE_FIXTURE(
    Volumes, "decode gives a cropped or shrunk stream the gradient normals that extract gives") {
  const std::vector<std::uint16_t> whole = ball();
  write("v32.raw", volume_files::bytes_of(std::vector<float>(whole.begin(), whole.end())));
  const std::string as_f32 = " --dims 16,16,16 --type f32 ";
  for (const auto& [volume, of] : {std::pair("v.raw", layout), std::pair("v32.raw", as_f32)})
    for (const std::string& part : {crop, std::string(" --shrink 2 "), crop + " --shrink 2 "}) {
      const std::string name = volume + of + " --spacing 0.5,1,2" + part;
      INFO(name);
      done("extract " + name + "--iso 1000 -q -o part.dmc");
      done("extract " + name + "--iso 1000 -q --normals gradient -o extracted.ply");
      const std::string decode = "decode part.dmc --normals gradient -o decoded.ply --volume ";
      for (const std::string spacing : {"", " --spacing 0.5,1,2"}) {
        done(decode + volume + of + spacing + part);
        CHECK(read("decoded.ply").size() == read("extracted.ply").size());
      }
      fails(decode + volume + of, 1, {"16x16x16", "with the same --crop and --shrink"});
    }
  // The same size, moved by a voxel of 1 mm.
  done("extract v.raw --iso 1000 -q -o part.dmc" + layout + crop);
  fails("decode part.dmc --normals gradient -o v.ply --volume v.raw" + layout +
            "--crop 6..,1..,2..13",
        1, {"v.raw", "1 mm from the part of the stream", "--crop and --shrink"});
  fails("decode part.dmc -o v.ply --crop ..,..,..", 2, {"--volume"});
}

TEST_CASE_FIXTURE(Volumes, "compare applies --crop and --shrink to the volume of a stream") {
  const std::string volume = "v.raw --iso 1000" + layout;
  done("extract " + volume + crop + "-o part.dmc");
  const auto largest = [&](const std::string& part) {
    const std::string output = done("compare part.dmc " + volume + part);
    std::istringstream numbers(output.substr(output.find("B to A, mm") + 10));
    double mean = 0, most = 0, all = 0;
    numbers >> mean >> most >> all;
    return all;
  };
  CHECK(largest(crop) < 1);
  CHECK(largest("") > 2);
}

TEST_CASE_FIXTURE(Volumes, "with --crop, bytes behind the part are not read from a pipe") {
  done("extract v.raw --iso 1000 -o file.jsonl" + layout + crop);
  const Result piped = shell("head -c 7168 v.raw | \"$discmc\" extract - --iso 1000 -o " +
                             ("piped.jsonl" + layout + crop));
  CHECK(piped.code == 0);
  CHECK(read("piped.jsonl") == read("file.jsonl"));
}

TEST_CASE_FIXTURE(Volumes, "--shrink of labels gives only labels of the volume") {
  // Two halves, 2 and 6, whose mean is 4.
  std::string labels;
  for (int i = 0; i < 9 * 8 * 8; ++i) labels += static_cast<char>(i % 9 < 5 ? 2 : 6);
  write("l.raw", labels);
  const std::string extract = "extract l.raw --dims 9,8,8 --type u8 --shrink 2 -q -o l.obj ";
  done(extract + "--iso 4");
  const FileMesh mean = mesh_in("l.obj");
  done(extract + "--label 6");
  const FileMesh label = mesh_in("l.obj");
  CHECK(volume_of(mean) > volume_of(label) + 40);
  done("extract l.raw --dims 9,8,8 --type u8 --shrink 2 -q --labels all -o 'all {name}.obj'");
  CHECK(mesh_in("all 6.obj").vertices_mm == label.vertices_mm);
  CHECK(file_names() == std::vector<std::string>{"all 2.obj", "all 6.obj", "all_2.mtl", "all_6.mtl",
                                                 "l.obj", "l.raw", "part.raw", "v.raw"});
}

TEST_CASE_FIXTURE(Volumes, "invalid values of --crop and --shrink are refused before any work") {
  const std::string extract = "extract v.raw --iso 1000 -o v.stl" + layout;
  for (const std::string text : {"1..2", "1..2,3..4", "1..2,3..4,5..6,7..8", "1,2,3", "2..1,..,..",
                                 "-1..2,..,..", "a..,..,..", "..,..,..5x", "..,..,99999999999.."})
    fails(extract + "--crop=" + text, 2, {"--crop", "'" + text + "'", "A..B,C..D,E..F"});
  for (const std::string number : {"1", "17", "-2", "2.5"})
    fails(extract + "--shrink=" + number, 2, {"--shrink", number});
  fails(extract + "--crop ..,..,16..", 1, {"v.raw", "16.. along z", "16 x 16 x 16", "0..15"});
}

// The discmc command from end to end: inputs, outputs, messages and exit codes.
#include "command.hpp"

#include "oracle/surface.hpp"

namespace {

using namespace command_tests;
using discmc::meshing::check_mesh;
using discmc::meshing::MeshReport;
using namespace discmc::reference;

const std::vector<std::string> all_formats = {"dmc", "stl", "ply", "obj",
                                              "glb", "3mf", "vtp", "jsonl"};
const std::vector<std::string> meshes = {"stl", "ply", "obj", "glb", "3mf", "vtp"};

BitVolume small_ball() {
  return ball({13, 12, 11}, {12, 11, 10}, 24);
}

BitVolume one_voxel() {
  return box({1, 1, 1}, {0, 0, 0}, {0, 0, 0});
}

// Units: cubic voxels.
double enclosed(const BitVolume& volume) {
  return static_cast<double>(surface_of_cells(volume, true).six_volumes) / 48;
}

const std::string little_endian_u16 = [] {
  std::string samples;
  for (const std::uint8_t on : small_ball().on) samples += on != 0 ? "\1\2" : "\1\1";
  return samples;
}();

const std::string layout = "--dims 13,12,11 --type u16 --iso 513 ";

void check_parts(const std::string& text, const std::vector<std::string>& parts) {
  INFO(text);
  for (const std::string& part : parts) CHECK(contains(text, part));
}

struct Ball : Workshop {
  Ball() { write("v.nrrd", small_ball()); }
};

}  // namespace

TEST_CASE_FIXTURE(Ball,
                  "decode writes the same mesh files from a stream as extract from its volume") {
  done("extract v.nrrd --iso 100 -o v.dmc");
  for (const std::string& format : all_formats) {
    done("extract v.nrrd --iso 100 -q -o extracted." + format);
    CHECK(done("decode v.dmc -o decoded." + format).empty());
    CHECK(read("extracted." + format) == read("decoded." + format));
    CHECK(!read("decoded." + format).empty());
  }
}

TEST_CASE_FIXTURE(Workshop,
                  "the report of extract lists the output's file, bytes and faces, and whether the "
                  "mesh is closed") {
  write("v.nrrd", box({4, 4, 4}, {1, 1, 1}, {2, 2, 2}));
  BitVolume step = box({8, 8, 4}, {1, 1, 1}, {5, 5, 1});
  const BitVolume upper = box({8, 8, 4}, {1, 1, 2}, {2, 3, 2});
  for (std::size_t i = 0; i < step.on.size(); ++i) step.on[i] |= upper.on[i];
  write("step.nrrd", step);
  const std::string extract = "extract v.nrrd --iso 100 ";
  check_parts(done(extract + "-o v.stl"),
              {"v.stl: 2,284 bytes\n", "triangles                             44",
               "classic Marching Cubes: 44 triangles", "vertices                              24",
               "closed                               yes"});
  CHECK(read("v.stl").size() == 2284);
  check_parts(done("extract step.nrrd --iso 100 --no-conforming -o v.glb"), {"v.glb: ", "  no\n"});
  check_parts(done(extract + "--faces polygons -o v.ply"), {"polygons  ", "  yes\n"});
  check_parts(done(extract + "-o v.jsonl"), {"polygons  "});
  check_parts(done(extract + "-o v.dmc"), {"v.dmc: ", "bytes of arena used"});
  check_parts(done(extract + "--memory 1M -o v.obj"), {"v.obj: ", "bytes of arena used"});
  CHECK(done(extract + "-q -o v.stl").empty());
}

TEST_CASE_FIXTURE(Workshop,
                  "far from the origin, only STL meshes are reported as coarse and open") {
  const std::string near = "space: LPS\nspace directions: (0.1,0,0) (0,0.1,0) (0,0,0.1)\n";
  write("far.nrrd", small_ball(), near + "space origin: (5000000.3,-6000000.1,7000000.7)\n");
  write("near.nrrd", small_ball(), near + "space origin: (0.3,-0.1,0.7)\n");
  const std::string extract = "extract far.nrrd --iso 100 -o far.";
  const Point offset = {5e6, -6e6, 7e6};
  done("extract near.nrrd --iso 100 -q -o near.obj");
  const auto vertices = mesh_in("near.obj").vertices_mm;
  for (const std::string format : {"obj", "3mf", "ply", "vtp", "glb"}) {
    INFO(format);
    const Result result = run(extract + format);
    CHECK(result.error.empty());
    CHECK(contains(result.out, "closed                               yes"));
    const FileMesh far = mesh_in("far." + format);
    REQUIRE(far.vertices_mm.size() == vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        CHECK(far.vertices_mm[i][axis] - vertices[i][axis] ==
              doctest::Approx(offset[axis]).epsilon(1e-12));
  }
  const Result stl = run(extract + "stl");
  CHECK(stl.code == 0);
  const std::size_t places = mesh_in("far.stl").vertices_mm.size();
  CHECK(places < vertices.size());
  check_parts(
      stl.error,
      {"far.stl: coordinates are rounded to 0.5 mm, as .stl files hold 32-bit floats",
       std::to_string(vertices.size()) + " vertices share " + std::to_string(places) + " places",
       ".ply, .obj, .3mf or .vtp", "--space voxel"});
  CHECK(contains(stl.out, "closed                                no"));
  done("extract far.nrrd --iso 100 -q -o far.dmc");
  CHECK(contains(run("decode far.dmc -o decoded.stl").error,
                 "decoded.stl: coordinates are rounded to 0.5 mm"));
  const Result voxel = run(extract + "stl --space voxel");
  CHECK(voxel.error.empty());
  CHECK(contains(voxel.out, "closed                               yes"));
}

TEST_CASE_FIXTURE(Workshop, "unwritable outputs are refused before the volume is read") {
  write("cut.nrrd", volume_files::nrrd("type: uchar\nencoding: ascii\n", "9 9 9") + "\n1 2");
  write("file", "");
  shell("mkdir folder.stl");
  const std::string cut = "extract cut.nrrd --iso 1 ";
  fails(cut + "-o v.stl", 1, {"cut.nrrd"});
  for (const std::string output :
       {"-o none/v.stl", "-o none/v.dmc", "--iso 2 -o 'none/v{name}.stl'", "--iso 2 -o none/v.glb"})
    fails(cut + output, 1, {"none: the folder does not exist; create it"});
  for (const std::string output : {"-o file/v.stl", "--iso 2 -o 'file/v{name}.stl'"})
    fails(cut + output, 1, {"file: this is not a folder"});
  fails(cut + "-o folder.stl", 1, {"folder.stl: this is a folder"});
  fails("extract cut.nrrd --labels all -o none/v.glb", 1, {"the folder does not exist"});
  fails("render cut.nrrd --iso 1 -o none/v.png", 1, {"the folder does not exist"});
}

TEST_CASE_FIXTURE(
    Ball, "without -o, the stream is written to standard output and the table to standard error") {
  CHECK(contains(done("extract v.nrrd --iso 100 -o v.dmc"), "classic Marching Cubes"));
  for (const char* output : {"", " -o -"}) {
    const Result result = run(std::string("extract v.nrrd --iso 100") + output);
    CHECK(result.code == 0);
    CHECK(result.out == read("v.dmc"));
    CHECK(contains(result.error, "classic Marching Cubes"));
  }
  CHECK(done("decode v.dmc -o -") == read("v.dmc"));
  const Result quiet = run("extract v.nrrd --iso 100 -q -o v.dmc");
  CHECK(quiet.out.empty());
  CHECK(quiet.error.empty());
}

TEST_CASE_FIXTURE(Workshop, "meshes are closed and exact for every volume and format") {
  const Size size = {9, 8, 7};
  for (const BitVolume& volume :
       {small_ball(), one_voxel(), checkerboard(size), box(size, {0, 0, 0}, {8, 7, 6}),
        discmc::reference::random(size, 128, 1), discmc::reference::spiral({12, 12, 5})}) {
    write("v.nrrd", volume);
    for (const std::string& format : meshes) {
      done("extract v.nrrd --iso 100 -o v." + format);
      const FileMesh mesh = mesh_in("v." + format);
      CHECK(mesh.face_count() > 0);
      CHECK(check_mesh(mesh).is_closed());
      CHECK(volume_of(mesh) == doctest::Approx(enclosed(volume)));
    }
    if (!has_program("admesh")) continue;
    const Result checked = shell("admesh -e v.stl");
    INFO(checked.out);
    const std::string disconnected = "Total disconnected facets        :";
    CHECK(count_after(checked.out, disconnected) == 0);
  }
}

TEST_CASE_FIXTURE(Workshop, "an open border leaves the surface open where the volume ends") {
  write("cut.nrrd", box({6, 6, 6}, {2, 2, 0}, {3, 3, 3}));
  write("full.nrrd", box({3, 3, 3}, {0, 0, 0}, {2, 2, 2}));
  done("extract cut.nrrd --iso 100 --border open -o v.obj");
  const MeshReport report = check_mesh(mesh_in("v.obj"));
  CHECK(report.open_edges > 0);
  CHECK(report.non_manifold_edges + report.wrongly_oriented + report.degenerate_faces == 0);
  done("extract full.nrrd --iso 100 --border open --allow-empty -o v.dmc");
  CHECK(info_of("v.dmc")["regions"] == "0");
  CHECK(info_of("v.dmc")["border"] == "open");
  done("extract full.nrrd --iso 100 --border closed -o v.dmc");
  CHECK(info_of("v.dmc")["regions"] == "26");
}

TEST_CASE_FIXTURE(Ball, "JSON Lines output has the corners of polygons in half-steps") {
  write("one.nrrd", one_voxel());
  done("extract one.nrrd --iso 100 -o one.jsonl");
  const std::string lines = read("one.jsonl");
  CHECK(lines_in(lines) == 8);
  CHECK(contains(lines, "{\"normal\":[1,1,1],\"rings\":[[[0,0,1],[1,0,0],[0,1,0]]]}\n"));
  done("extract v.nrrd --iso 100 -o v.dmc");
  done("decode v.dmc -o v.jsonl");
  CHECK(std::to_string(lines_in(read("v.jsonl"))) == info_of("v.dmc")["regions"]);
}

TEST_CASE_FIXTURE(Workshop,
                  "mesh faces are triangles by default, and polygons with --faces polygons if the "
                  "format supports them") {
  const BitVolume volume = box({5, 5, 5}, {1, 1, 1}, {3, 3, 3});
  write("v.nrrd", volume);
  done("extract v.nrrd --iso 100 -o v.dmc");
  for (const std::string& format : meshes) {
    done("decode v.dmc -o v." + format);
    const std::string triangles = read("v." + format);
    const FileMesh mesh = mesh_of("v." + format, triangles);
    for (std::size_t face = 0; face < mesh.face_count(); ++face) CHECK(mesh.face_size(face) == 3);
    done("decode v.dmc --faces triangles -o v." + format);
    CHECK(read("v." + format) == triangles);
  }
  for (const std::string format : {"ply", "obj", "vtp"}) {
    done("decode v.dmc --faces polygons -o v." + format);
    const std::string polygons = read("v." + format);
    const FileMesh mesh = mesh_of("v." + format, polygons);
    CHECK(check_mesh(mesh).is_closed());
    CHECK(volume_of(mesh) == doctest::Approx(enclosed(volume)));
    CHECK(std::to_string(mesh.face_count()) == info_of("v.dmc")["regions"]);
    done("extract v.nrrd --iso 100 -q --faces polygons -o v." + format);
    CHECK(read("v." + format) == polygons);
  }
  for (const std::string command : {"extract v.nrrd --iso 100", "decode v.dmc"})
    for (const std::string name : {"no.stl", "no.glb", "no.3mf", "no.dmc"})
      fails(command + " --faces polygons -o " + name, 2,
            {"--faces", name, ".ply, .obj, .vtp or .jsonl"});
}

TEST_CASE_FIXTURE(Ball,
                  "options that the --format of standard output cannot represent are refused") {
  const std::pair<std::string, std::string> wrong[] = {
      {"stl --faces polygons",
       "--faces: .stl on standard output cannot hold polygons; leave it "
       "out, or give --format .ply, .obj, .vtp or .jsonl"},
      {"stl --normals surface",
       "--normals: .stl on standard output cannot hold normals; give "
       "--format .ply, .obj, .glb or .vtp"},
      {"jsonl --space voxel", "--space: .jsonl on standard output has coordinates"},
      {"csv --unit inch", "--unit: .csv on standard output has a fixed unit"},
      {"glb --unit inch", "--unit: .glb on standard output is in metres"},
      {"jsonl --triangles 9", "--triangles: .jsonl on standard output holds merged polygons"},
      {"jsonl --surface interpolated", "--surface: .jsonl on standard output has vertices"}};
  for (const auto& [words, message] : wrong)
    fails("extract v.nrrd --iso 100 -o - --format " + words, 2, {message});
}

TEST_CASE_FIXTURE(Workshop, "--iso is in the units that the volume file declares") {
  const std::string samples = volume_files::stored(volume_files::SampleType::u8);
  write("v.nii", volume_files::Nifti().scale(2, -1000).file(samples));
  for (const std::string iso : {"--iso -900", "--iso=-900.5", "--iso -901.999"}) {
    done("extract v.nii " + iso + " -o v.dmc");
    CHECK(info_of("v.dmc")["threshold"] == "50");
  }
}

TEST_CASE_FIXTURE(Ball, "headerless samples of either byte order give the same stream") {
  std::string big = little_endian_u16;
  for (std::size_t i = 0; i < big.size(); i += 2) std::swap(big[i], big[i + 1]);
  write("little.raw", little_endian_u16);
  write("big.raw", big);
  done("extract little.raw " + layout + "-o little.dmc");
  done("extract big.raw --big-endian " + layout + "-o big.dmc");
  CHECK(read("little.dmc") == read("big.dmc"));
  done("extract v.nrrd --iso 100 -o v.jsonl");
  done("decode big.dmc -o big.jsonl");
  CHECK(read("v.jsonl") == read("big.jsonl"));
  done("extract big.raw --big-endian --spacing -0.5,1,2.25 " + layout + "-o big.dmc");
  CHECK(info_of("big.dmc")["spacing"] == "-0.5 1 2.25");
}

TEST_CASE_FIXTURE(Ball, "an empty surface is valid in every format") {
  for (const std::string iso : {"201", "1e9", "1e30"}) {
    for (const std::string& format : all_formats) {
      done("extract v.nrrd --allow-empty --iso " + iso + " -o v." + format);
      if (format == "dmc" || format == "jsonl") continue;
      const FileMesh mesh = mesh_in("v." + format);
      CHECK(mesh.face_count() + mesh.vertices_mm.size() == 0);
    }
    CHECK(read("v.jsonl").empty());
    CHECK(info_of("v.dmc")["regions"] == "0");
    CHECK(info_of("v.dmc")["complete"] == "yes");
    done("render v.dmc -o v.png --size 20,10");
  }
}

TEST_CASE_FIXTURE(
    Ball, "a table that cannot be written fails the command, and the stream is still written") {
  if (shell("test -c /dev/full").code != 0) return;
  const Result result = shell("\"$discmc\" extract v.nrrd --iso 100 -o v.dmc >/dev/full");
  check_failure(result, 1, {"standard output: writing failed (No space left on device)"});
  check_failure(shell("\"$discmc\" extract v.nrrd --iso 100 -o - --format stl >/dev/full"), 1,
                {"discmc: standard output: writing failed (No space left on device); free space"});
  CHECK(run("info v.dmc").code == 0);
  CHECK(shell("\"$discmc\" info v.dmc >/dev/full").code == 1);
}

TEST_CASE_FIXTURE(Workshop, "less memory makes the stream longer; the surface is unchanged") {
  const BitVolume volume = discmc::reference::random({16, 16, 16}, 128, 2);
  write("v.nrrd", volume);
  done("extract v.nrrd --iso 100 --memory 2M -o whole.dmc");
  auto whole = info_of("whole.dmc");
  CHECK(whole["fragments"] == "0");
  for (const std::string options :
       {"--memory 1500", "--memory 2K", "--capacities 20,0", "--capacities 100,9"}) {
    const std::string table = done("extract v.nrrd --iso 100 " + options + " -o v.dmc");
    CHECK(contains(table, "the arena lacked slots"));
    done("decode v.dmc -o v.stl");
    const FileMesh mesh = mesh_in("v.stl");
    CHECK(check_mesh(mesh).is_closed());
    CHECK(volume_of(mesh) == doctest::Approx(enclosed(volume)));
    auto pieces = info_of("v.dmc");
    CHECK(std::stoi(pieces["fragments"]) > 0);
    CHECK(std::stoul(pieces["bytes"]) > std::stoul(whole["bytes"]));
    done("decode v.dmc -o joined.dmc");
    auto joined = info_of("joined.dmc");
    CHECK(joined["fragments"] == "0");
    for (const char* key : {"regions", "rings", "holes", "links", "corners", "complete"}) {
      CHECK(pieces[key] == whole[key]);
      CHECK(joined[key] == whole[key]);
    }
  }
  for (const std::string memory : {"64KiB", "1MB"})
    CHECK(!contains(done("extract v.nrrd --iso 100 --memory " + memory + " -o v.dmc"), "lacked"));
  fails("extract v.nrrd --iso 100 --memory 100 -o no.dmc", 1, {"--memory 100 ", "at least "});
}

TEST_CASE_FIXTURE(
    Workshop,
    "file names may have blanks and non-ASCII letters, and the input may also be the output") {
  const std::string name = "ein Schädel; $x '* 頭";
  write(name + ".nrrd", small_ball());
  const std::string quoted = "\"ein Schädel; \\$x '* 頭";
  done("extract " + quoted + ".nrrd\" --iso 100 -o " + quoted + ".dmc\"");
  const std::string stream = read(name + ".dmc");
  done("decode " + quoted + ".dmc\" -o " + quoted + ".dmc\"");
  CHECK(read(name + ".dmc") == stream);
  CHECK(file_names().size() == 2);
}

TEST_CASE_FIXTURE(Ball, "wrong usage exits with code 2") {
  write("v.raw", little_endian_u16);
  std::vector<std::string> wrong = {"",
                                    "explode",
                                    "extract",
                                    "extract v.nrrd",
                                    "extract v.nrrd --iso",
                                    "extract --iso 1",
                                    "extract v.nrrd more --iso 1",
                                    "extract v.raw --iso 1 --dims 13,12,11",
                                    "extract v.raw --iso 1 --type f16 --dims 13,12,11",
                                    "render v.dmc -o v.jpg",
                                    "decode",
                                    "decode v.dmc",
                                    "info",
                                    "info a b",
                                    "render v.dmc",
                                    "render v.dmc -o v.png --size 5",
                                    "render v.dmc -o v.png --view 1,2"};
  for (const std::string iso : {"much", "nan", "inf", "''"})
    wrong.push_back("extract v.nrrd --iso " + iso);
  for (const std::string options :
       {"-x", "--memory 0", "--capacities 9", "--wire bits", "--wire slices -o v.stl",
        "--wire slices --normals gradient", "--key-slices 4", "--wire slices --key-slices 0",
        "--capacities 9,9 --memory 9K", "--memory 99999999999999999999", "-o v.vtk",
        "--big-endian"})
    wrong.push_back("extract v.nrrd --iso 1 " + options);
  for (const std::string options : {"--dims 13,12,11 --spacing 0,1,1", "", "--dims 13,12"})
    wrong.push_back("extract v.raw --iso 1 --type u16 " + options);
  for (const std::string& arguments : wrong) fails(arguments, 2, {"discmc: "});
}

TEST_CASE_FIXTURE(Workshop, "invalid values of options are reported with the expected values") {
  for (const char* memory : {"some", "3Q", "-5", "1.5M", ""})
    fails("extract v.nrrd --iso 1 --memory '" + std::string(memory) + "'", 2,
          {"invalid number of bytes '" + std::string(memory) + "'", "as in 24K"});
  fails("extract v.nrrd --iso 1 --border ajar", 2,
        {"invalid value 'ajar'", "expected closed|open"});
  fails("extract v.nrrd --iso 1 --dims 1,1,1 --type f16", 2,
        {"invalid value 'f16'", "expected u8|i8|u16|i16|u32|i32|u64|i64|f32|f64"});
  fails("extract v.nrrd --iso 1 --memory 3K --memory 4K", 2, {"--memory is given more than once"});
  fails("extract v.raw --iso 1 --type u8 --dims 3,4", 2,
        {"--dims: invalid value '3,4'; expected X,Y,Z"});
}

TEST_CASE_FIXTURE(Workshop, "an unreadable volume is reported by name, and no file is written") {
  write("block.nrrd", volume_files::nrrd("type: block\nencoding: raw\n") + "\n");
  write("empty.nrrd", "");
  const std::string cut = little_endian_u16.substr(0, little_endian_u16.size() - 1);
  write("v.raw", cut);
  write(
      "cut.nrrd",
      volume_files::nrrd("type: uint16\nendian: little\nencoding: raw\n", "13 12 11") + "\n" + cut);
  fails("extract none.nrrd --iso 1 -o v.dmc", 1, {"none.nrrd", "check"});
  fails("extract . --iso 1 -o v.dmc", 1, {".: "});
  fails("extract empty.nrrd --iso 1 -o v.dmc", 1, {"empty.nrrd"});
  fails("extract block.nrrd --iso 1 -o v.dmc", 1,
        {"block.nrrd", "'block'", "one number per voxel"});
  for (const std::string& format : all_formats)
    fails("extract cut.nrrd --iso 513 -o v." + format, 1,
          {"cut.nrrd: slice 10 ", "1 bytes of it are missing"});
  fails("extract v.raw " + layout + "-o v.dmc", 1,
        {"v.raw: the file has 3431 bytes", "13 x 12 x 11 u16 has 3432"});
}

TEST_CASE_FIXTURE(Workshop, "extract counts NaN samples as off and reports their number") {
  std::string samples = volume_files::stored(volume_files::SampleType::f32);
  const float nan = std::nanf("");
  std::memcpy(&samples[samples.size() - sizeof nan], &nan, sizeof nan);
  write("v.nrrd", volume_files::nrrd("type: float\nencoding: raw\nendian: little\n\n") + samples);
  check_parts(run("extract v.nrrd --iso 7 -o v.dmc"), 0,
              {"v.nrrd: 1 samples are not a number (NaN) and count as off"});
  done("extract v.nrrd --iso 7.25 --allow-empty -o none.dmc");
  CHECK(contains(done("info v.dmc"), "regions 8\n"));
  CHECK(contains(done("info none.dmc"), "regions 0\n"));
}

TEST_CASE_FIXTURE(Workshop,
                  "--normals gradient accepts samples of every type, for streams and meshes") {
  const std::string dims = " --dims 5,3,4 --type ";
  write("u8.raw", volume_files::stored(volume_files::SampleType::u8));
  write("f64.raw", volume_files::stored(volume_files::SampleType::f64));
  // Halfway between two samples, the same two in both.
  const auto normals_of = [&](const std::string& extension) {
    for (const std::string& volume :
         {"u8.raw --iso 122" + dims + "u8", "f64.raw --iso 0.05" + dims + "f64"})
      done("extract " + volume + " --normals gradient -o " + volume.substr(0, volume.find('.')) +
           extension);
    if (extension == ".dmc")
      for (const std::string name : {"u8", "f64"})
        done("decode " + name + ".dmc --normals gradient -o " + name + ".obj");
    return std::pair(mesh_in("u8.obj").normals, mesh_in("f64.obj").normals);
  };
  for (const std::string extension : {".obj", ".dmc"}) {
    const auto [of_bytes, of_floats] = normals_of(extension);
    REQUIRE(of_bytes.size() > 10);
    REQUIRE(of_bytes.size() == of_floats.size());
    for (std::size_t i = 0; i < of_bytes.size(); ++i)
      CHECK(discmc::meshing::dot(of_bytes[i], of_floats[i]) > 0.9998);
  }
  fails("extract f64.raw --iso 0 --iso 1" + dims + "f64 --normals gradient -o two.dmc", 1,
        {"f64", "one --iso"});
}

TEST_CASE_FIXTURE(Workshop, "a spacing that a stream cannot hold is refused") {
  write("v.nrrd", small_ball(), "spacings: 5000 1 1\n");
  fails("extract v.nrrd --iso 100 -o v.dmc", 1, {"spacing 5000"});
  CHECK(file_names().size() == 1);
}

TEST_CASE_FIXTURE(Ball, "--memory larger than any volume needs leaves the stream unchanged") {
  done("extract v.nrrd --iso 100 -o v.dmc");
  done("extract v.nrrd --iso 100 --memory 100000G -o more.dmc");
  CHECK(read("v.dmc") == read("more.dmc"));
}

TEST_CASE_FIXTURE(Workshop, "extract ended by a signal leaves no output file") {
  const Result result = shell(
      "truncate -s 2000000000 v.raw; \"$discmc\" extract v.raw --dims 1000,1000,2000 --type u8 "
      "--iso 1 "
      "-o v.dmc & while [ $(ls | wc -l) -lt 2 ]; do :; done; kill -TERM $!; wait $!");
  CHECK(result.code == 128 + 15);
  CHECK(file_names() == std::vector<std::string>{"v.raw"});
}

TEST_CASE_FIXTURE(Ball, "an output that is a named pipe stays a pipe") {
  done("extract v.nrrd --iso 100 -o v.dmc");
  const Result result = shell(
      "mkfifo p.dmc; timeout 10 cat p.dmc & \"$discmc\" extract v.nrrd --iso 100 -q -o p.dmc; "
      "wait");
  CHECK(result.out == read("v.dmc"));
}

TEST_CASE_FIXTURE(Workshop, "--format writes the same mesh to standard output as to a file") {
  write("v.nrrd", ball({12, 12, 12}, {11, 11, 11}, 60));
  for (const std::string format :
       {"stl", "ply", "obj", "glb", "3mf", "vtp", "jsonl", "csv", "json", "dmc", ".STL"}) {
    const std::string dot = format[0] == '.' ? "" : ".";
    done("extract v.nrrd --iso 100 -q -o v" + dot + format);
    const Result result = run("extract v.nrrd --iso 100 -o - --format " + format);
    CHECK(result.code == 0);
    CHECK(result.out == read("v" + dot + format));
    CHECK_FALSE(result.error.empty());
  }
  done("extract v.nrrd --iso 100 -o v.dmc");
  CHECK(done("decode v.dmc -o - --format ply") == done("extract v.nrrd --iso 100 -q --format ply"));
  const Result several = run("extract v.nrrd --labels all -o - --format glb");
  CHECK(several.out.substr(0, 4) == "glTF");
  CHECK(contains(several.error, "label"));
  fails("extract v.nrrd --iso 100 -o v.stl --format ply", 2, {"leave it out, as v.stl"});
  for (const std::string none : {"off", "a.stl", "''", ".", "..stl"})
    fails("extract v.nrrd --iso 100 -o - --format " + none, 2,
          {"'" + (none == "''" ? "" : none) + "' is not a format; expected .dmc, .stl, "});
}

TEST_CASE_FIXTURE(Workshop, "--unit and --scale change the coordinates of a mesh") {
  write("v.nrrd", ball({12, 12, 12}, {11, 11, 11}, 60));
  done("extract v.nrrd --iso 100 -o v.dmc");
  const auto volume = [&](const std::string& arguments) {
    return volume_of(mesh_of_obj(done(arguments + " -o - --format obj")));
  };
  const double mm3 = volume("extract v.nrrd --iso 100");
  CHECK(volume("extract v.nrrd --iso 100 --unit m --scale 10") == doctest::Approx(1e-6 * mm3));
  CHECK(volume("decode v.dmc --unit inch") == doctest::Approx(mm3 / (25.4 * 25.4 * 25.4)));
  done("extract v.nrrd --iso 100 --scale 2 -o v.glb");
  CHECK(volume_of(mesh_in("v.glb")) == doctest::Approx(8 * mm3).epsilon(1e-5));
  for (const std::string refused :
       {"--unit m -o v.glb", "--unit um -o w.dmc", "--scale 2 -o v.csv", "--scale 0 -o v.stl"})
    CHECK(run("extract v.nrrd --iso 100 " + refused).code == 2);
}

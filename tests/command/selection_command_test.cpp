// discmc extract with several surfaces, ranges and labels.
#include "command.hpp"

namespace {

using command_tests::check_failure;
using command_tests::contains;
using command_tests::Workshop;

// 60 voxels, five per row, three rows per slice: 0, 4, 8, ..., 236.
const std::string ramp = "extract v.raw --dims 5,3,4 --type u8 ";

struct Ramp : Workshop {
  Ramp() { write("v.raw", volume_files::stored(volume_files::SampleType::u8)); }
};

}  // namespace

TEST_CASE_FIXTURE(Ramp, "--range includes its lower and upper end") {
  // The voxels from 8 to 236 without those from 104 on are those from 8 to 100.
  done(ramp + "--range 8..100 -o range.jsonl");
  done(ramp + "--range 7.5..103.5 -o wider.jsonl");
  CHECK(read("range.jsonl") == read("wider.jsonl"));
  done(ramp + "--range 9..100 -o without8.jsonl");
  CHECK(read("range.jsonl") != read("without8.jsonl"));
  done(ramp + "--range 120.. -o upper.jsonl");
  done(ramp + "--iso 120 -o iso.jsonl");
  CHECK(read("upper.jsonl") == read("iso.jsonl"));
  done(ramp + "--range=..4 -o lower.jsonl");
  done(ramp + "--range 0..4 -o first_two.jsonl");
  CHECK(read("lower.jsonl") == read("first_two.jsonl"));
}

TEST_CASE_FIXTURE(Ramp, "--label selects the voxels of one value") {
  CHECK(contains(done(ramp + "--label 12 -o v.stl"), "classic Marching Cubes: 8 triangles"));
  CHECK(contains(done(ramp + "--label 13 --allow-empty -o v.stl"),
                 "classic Marching Cubes: 0 triangles"));
}

TEST_CASE_FIXTURE(
    Ramp, "each of several surfaces is written to a mesh file named after its threshold or range") {
  const std::string output = done(ramp + "--iso 100 --iso 20.5 --iso=-1 -o '{name} of v.stl'");
  for (const std::string iso : {"100", "20.5", "-1"}) {
    CHECK(contains(output, iso + " of v.stl: "));
    done(ramp + "--iso=" + iso + " -o alone.stl");
    CHECK(read(iso + " of v.stl") == read("alone.stl"));
  }
  done(ramp + "--range 1..9 --range 0..5 -q -o 'v{name}.ply'");
  done(ramp + "--range 0..5 -q -o alone.ply");
  CHECK(read("v0..5.ply") == read("alone.ply"));
}

TEST_CASE_FIXTURE(Ramp, "--range is encoded in streams of regions and of slices") {
  done(ramp + "--range 8..100 -o v.jsonl");
  for (const std::string wire : {"regions", "slices"}) {
    done(ramp + "--range 8..100 --wire " + wire + " -o v.dmc");
    done("decode v.dmc -o decoded.jsonl");
    CHECK(read("v.jsonl").size() == read("decoded.jsonl").size());
  }
}

TEST_CASE_FIXTURE(Ramp,
                  "invalid values of --iso, --range and --label are refused before any work") {
  fails(ramp + "-o v.stl", 2, {"--iso", "--range", "--label"});
  fails(ramp + "--range 9..8 -o v.stl", 2, {"'9..8'", "LOW..HIGH"});
  fails(ramp + "--range 9 -o v.stl", 2, {"'9'", "LOW..HIGH"});
  fails(ramp + "--range .. -o v.stl", 2, {"'..'"});
  fails(ramp + "--label 1.5 -o v.stl", 1, {"no label is called '1.5'"});
  fails(ramp + "--iso 1 --label 1 -o v.stl", 2, {"--iso", "--label"});
  fails(ramp + "--iso 1 --iso 2 -o v.stl", 2, {"{name}"});
  for (const std::string unknown : {"{nam}", "{label}", "{}"})
    fails(ramp + "--iso 1 --iso 2 -o '{name}-" + unknown + ".stl'", 2,
          {"--output: " + unknown + " is an unknown placeholder", "{name}"});
  fails(ramp + "--range 1..2 --normals gradient -o v.ply", 2, {"--normals surface"});
  fails(ramp + "--iso 1 -o none/v.stl", 1, {"none", "the folder does not exist"});
  fails(ramp + "--iso 1 --iso 2 --iso 3 --iso 4 --iso 5 -o v.dmc", 2, {"5 surfaces", "4 at most"});
}

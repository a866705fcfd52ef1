// discmc extract with several surfaces, ranges and labels.
#include <doctest/doctest.h>

#include <string>

#include "command.hpp"
#include "volume_files.hpp"

namespace {

using command_tests::check_failure;
using command_tests::contains;
using command_tests::Workshop;

// 60 voxels in a file of five a row, three rows a slice: 0, 4, 8 ... 236.
const std::string ramp = "extract v.raw --dims 5,3,4 --type u8 ";

}  // namespace

TEST_CASE("a range includes both ends") {
  const Workshop workshop;
  workshop.write("v.raw", volume_files::stored(volume_files::SampleType::u8));
  // The voxels from 8 to 236 less those from 104 on are those from 8 to 100.
  workshop.done(ramp + "--range 8..100 -o range.jsonl");
  workshop.done(ramp + "--range 7.5..103.5 -o wider.jsonl");
  CHECK(workshop.read("range.jsonl") == workshop.read("wider.jsonl"));
  workshop.done(ramp + "--range 9..100 -o without8.jsonl");
  CHECK(workshop.read("range.jsonl") != workshop.read("without8.jsonl"));
  workshop.done(ramp + "--range 120.. -o upper.jsonl");
  workshop.done(ramp + "--iso 120 -o iso.jsonl");
  CHECK(workshop.read("upper.jsonl") == workshop.read("iso.jsonl"));
  workshop.done(ramp + "--range=..4 -o lower.jsonl");
  workshop.done(ramp + "--range 0..4 -o first_two.jsonl");
  CHECK(workshop.read("lower.jsonl") == workshop.read("first_two.jsonl"));
}

TEST_CASE("a label selects the voxels of one value") {
  const Workshop workshop;
  workshop.write("v.raw", volume_files::stored(volume_files::SampleType::u8));
  CHECK(
      contains(workshop.done(ramp + "--label 12 -o v.stl"), "classic Marching Cubes: 8 triangles"));
  CHECK(contains(workshop.done(ramp + "--label 13 --allow-empty -o v.stl"),
                 "classic Marching Cubes: 0 triangles"));
}

TEST_CASE("several surfaces are as many meshes, with their names") {
  const Workshop workshop;
  workshop.write("v.raw", volume_files::stored(volume_files::SampleType::u8));
  const std::string told =
      workshop.done(ramp + "--iso 100 --iso 20.5 --iso=-1 -o '{name} of v.stl'");
  for (const std::string iso : {"100", "20.5", "-1"}) {
    CHECK(contains(told, iso + " of v.stl: "));
    workshop.done(ramp + "--iso=" + iso + " -o alone.stl");
    CHECK(workshop.read(iso + " of v.stl") == workshop.read("alone.stl"));
  }
  workshop.done(ramp + "--range 1..9 --range 0..5 -q -o 'v{name}.ply'");
  workshop.done(ramp + "--range 0..5 -q -o alone.ply");
  CHECK(workshop.read("v0..5.ply") == workshop.read("alone.ply"));
}

TEST_CASE("a range is encoded in streams of both kinds") {
  const Workshop workshop;
  workshop.write("v.raw", volume_files::stored(volume_files::SampleType::u8));
  workshop.done(ramp + "--range 8..100 -o v.jsonl");
  for (const std::string wire : {"regions", "slices"}) {
    workshop.done(ramp + "--range 8..100 --wire " + wire + " -o v.dmc");
    workshop.done("decode v.dmc -o decoded.jsonl");
    CHECK(workshop.read("v.jsonl").size() == workshop.read("decoded.jsonl").size());
  }
}

TEST_CASE("selections that make no sense are refused before any work") {
  const Workshop workshop;
  workshop.write("v.raw", volume_files::stored(volume_files::SampleType::u8));
  const auto names = workshop.names();
  check_failure(workshop.run(ramp + "-o v.stl"), 2, {"--iso", "--range", "--label"});
  check_failure(workshop.run(ramp + "--range 9..8 -o v.stl"), 2, {"'9..8'", "LOW..HIGH"});
  check_failure(workshop.run(ramp + "--range 9 -o v.stl"), 2, {"'9'", "LOW..HIGH"});
  check_failure(workshop.run(ramp + "--range .. -o v.stl"), 2, {"'..'"});
  check_failure(workshop.run(ramp + "--label 1.5 -o v.stl"), 1, {"no label is called '1.5'"});
  check_failure(workshop.run(ramp + "--iso 1 --label 1 -o v.stl"), 2, {"--iso", "--label"});
  check_failure(workshop.run(ramp + "--iso 1 --iso 2 -o v.stl"), 2, {"{name}"});
  for (const std::string unknown : {"{nam}", "{label}", "{}"})
    check_failure(workshop.run(ramp + "--iso 1 --iso 2 -o '{name}-" + unknown + ".stl'"), 2,
                  {"--output: " + unknown + " is an unknown placeholder", "{name}"});
  check_failure(workshop.run(ramp + "--range 1..2 --normals gradient -o v.ply"), 2,
                {"--normals surface"});
  check_failure(workshop.run(ramp + "--iso 1 -o none/v.stl"), 1,
                {"none", "the folder does not exist"});
  check_failure(workshop.run(ramp + "--iso 1 --iso 2 --iso 3 --iso 4 --iso 5 -o v.dmc"), 2,
                {"5 surfaces", "4 at most"});
  CHECK(workshop.names() == names);
}

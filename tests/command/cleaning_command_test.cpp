// discmc extract, decode and render, with noise and specks removed.
#include "command.hpp"

namespace {

using namespace command_tests;

// Two boxes and a voxel; on is 1.
std::string boxes() {
  BitVolume volume = discmc::reference::box({20, 16, 12}, {2, 2, 2}, {9, 9, 9});
  const BitVolume other = discmc::reference::box({20, 16, 12}, {13, 3, 3}, {16, 8, 8});
  for (std::size_t i = 0; i < volume.on.size(); ++i) volume.on[i] |= other.on[i];
  volume.on[19] = 1;
  return {volume.on.begin(), volume.on.end()};
}

const std::string extract = "extract v.raw --dims 20,16,12 --type u8 --spacing 1,1,1 --iso 1 ";

struct Boxes : Workshop {
  Boxes() { write("v.raw", boxes()); }
};

}  // namespace

TEST_CASE_FIXTURE(Boxes, "--largest keeps the largest bodies in meshes of volumes and of streams") {
  done(extract + "-o all.jsonl");
  const auto kept = [&](const std::string& options) {
    const auto result = run(extract + options + " --allow-empty -q -o kept.jsonl");
    CHECK(result.code == 0);
    done(extract + "-q -o v.dmc");
    const auto decoded = run("decode v.dmc " + options + " -o decoded.jsonl");
    CHECK(decoded.code == 0);
    CHECK(lines_in(read("kept.jsonl")) == lines_in(read("decoded.jsonl")));
    const std::string source = "v.raw: ";
    CHECK(result.error.empty() == decoded.error.empty());
    if (result.error.empty()) return result.error;
    CHECK(contains(result.error, source));
    CHECK(contains(decoded.error, result.error.substr(result.error.find(source) + source.size())));
    return result.error;
  };
  constexpr std::size_t of_box = 26, of_voxel = 8;
  CHECK(contains(kept("--largest 2"), "2 of 3 bodies and cavities are kept"));
  CHECK(lines_in(read("kept.jsonl")) == 2 * of_box);
  CHECK(contains(kept("--largest 1"), "1 of 3"));
  CHECK(kept("--largest 9").empty());
  CHECK(read("kept.jsonl") == read("all.jsonl"));
  CHECK(kept("--min-volume 0.15").empty());
  CHECK(lines_in(read("kept.jsonl")) == 2 * of_box + of_voxel);
  CHECK(contains(kept("--min-volume 0.2"), "2 of 3"));
  CHECK(contains(kept("--min-volume 200"), "1 of 3"));
  CHECK(contains(kept("--min-volume 1e9"), "0 of 3"));
}

TEST_CASE_FIXTURE(Boxes,
                  "--median removes specks from meshes and from streams of regions and of slices") {
  CHECK(contains(run(extract + "--median 3 --largest 1 -o one.jsonl").error, "1 of 2"));
  done(extract + "--median 3 --largest 2 -o v.jsonl");
  for (const std::string wire : {"regions", "slices"}) {
    done(extract + "--median 3 --wire " + wire + " -o v.dmc");
    done("decode v.dmc -o decoded.jsonl");
    CHECK(lines_in(read("v.jsonl")) == lines_in(read("decoded.jsonl")));
  }
}

TEST_CASE_FIXTURE(Boxes, "cleaning options that contradict each other are refused") {
  fails(extract + "--largest 1 -o v.dmc", 2, {"--largest", "a stream"});
  fails(extract + "--min-volume 1 -o v.dmc", 2, {"--min-volume"});
  fails(extract + "--largest 0 -o v.stl", 2, {"--largest"});
  fails(extract + "--largest 1 --border open -o v.stl", 2, {"--border"});
  fails(extract + "--median 5 -o v.stl", 2, {"--median"});
  fails(extract + "--median 3 --normals gradient -o v.dmc", 2, {"--median", "--normals"});
}

TEST_CASE_FIXTURE(Workshop,
                  "invalid values of cleaning options are refused with the expected form") {
  for (const std::string none : {"0", "2.5", "abc", "-1"})
    fails("extract v.nrrd --iso 1 -o v.stl --largest=" + none, 2,
          {"invalid value '" + none + "'; expected a whole number from 1"});
  for (const std::string none : {"100mm", "-1", "inf"})
    fails("extract v.nrrd --iso 1 -o v.stl --min-volume=" + none, 2,
          {"invalid value '" + none + "'; expected cubic millimetres"});
}

TEST_CASE_FIXTURE(
    Boxes, "render draws only the bodies that cleaning options keep, for volumes and for streams") {
  done(extract + "-q -o v.dmc");
  const std::string layout = "v.raw" + extract.substr(extract.find(" --dims"));
  const auto picture = [&](const std::string& input, const std::string& options) {
    return done("render " + input + " " + options + " --size 60,50 -o -");
  };
  const std::string one = picture("v.dmc", "--largest 1");
  CHECK(one != picture("v.dmc", ""));
  CHECK(one == picture(layout, "--largest 1"));
  CHECK(one == picture(layout, "--min-volume 300"));
  for (const std::string other : {"--classic", "--border open"})
    fails("render " + layout + other + " --largest 1 -o v.png", 2, {"--largest"});
}

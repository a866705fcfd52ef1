// Volumes in parts, on several cores: the surface equals that of one sweep.
#include "extraction/part_extraction.hpp"

#include <discmc/decoder.hpp>

#include "command.hpp"
#include "hand_made.hpp"
#include "oracle/thinned.hpp"
#include "sample_reader.hpp"
#include "surface/growing_joiner.hpp"

namespace {

using discmc::Border;
using discmc::command::ExtractionOptions;
using discmc::command::VolumeInfo;
using namespace discmc::meshing;
using command_tests::Workshop;
using discmc::reference::BitVolume;
using discmc::reference::describe_difference;
using discmc::reference::random;
using hand_made::are_same;
using hand_made::regions_of;
using sample_reader::bit_threshold;
using sample_reader::SampleReader;

ExtractionOptions options_with(Border border, bool filters_by_majority = false) {
  ExtractionOptions options{{bit_threshold}, border};
  options.filters_by_majority = filters_by_majority;
  return options;
}

struct Extracted {
  Extraction extraction;
  Surface surface;
};

Extracted extracted(const BitVolume& volume, const ExtractionOptions& options) {
  SampleReader reader(volume);
  SurfaceBuilder builder;
  SurfaceRequest request{options.selection, discmc::make_sink(builder)};
  request.builder = &builder;
  const Extraction extraction = extract(reader, options, std::vector<SurfaceRequest>{request})[0];
  CHECK(builder.incomplete_regions() == 0);
  return {extraction, std::move(builder.surface())};
}

Surface streamed(const BitVolume& volume, const ExtractionOptions& options) {
  SampleReader reader(volume);
  std::vector<std::uint8_t> bytes;
  discmc::Encoder encoder;
  REQUIRE(encoder.start({}, {&bytes, [](void* kept, const std::uint8_t* part, std::size_t count) {
                               auto& stream = *static_cast<std::vector<std::uint8_t>*>(kept);
                               stream.insert(stream.end(), part, part + count);
                               return count;
                             }}) == discmc::Status::ok);
  SurfaceRequest request{options.selection, discmc::make_sink(encoder)};
  request.encoder = &encoder;
  extract(reader, options, std::vector<SurfaceRequest>{request});
  SurfaceBuilder builder;
  discmc::Decoder decoder;
  REQUIRE(decoder.start(discmc::make_sink(builder)) == discmc::Status::ok);
  CHECK(decoder.push(bytes.data(), bytes.size()).status == discmc::Status::ok);
  static_cast<void>(decoder.finish());
  CHECK(decoder.report().is_complete());
  CHECK(builder.incomplete_regions() == 0);
  return std::move(builder.surface());
}

// Tall enough for several parts.
std::vector<BitVolume> tall_volumes() {
  return {random({9, 8, 50}, 128, 1), random({20, 17, 70}, 40, 2), random({5, 40, 33}, 220, 3),
          discmc::reference::ball({30, 30, 90}, {30, 30, 90}, 1600),
          discmc::reference::checkerboard({6, 6, 34})};
}

void check_same_surface(const BitVolume& volume, ExtractionOptions options) {
  const Extracted whole = extracted(volume, options);
  options.jobs = 2;
  const Extracted parts = extracted(volume, options);
  CHECK(describe_difference(regions_of(parts.surface), regions_of(whole.surface)) == "");
  CHECK(parts.extraction.voxels == whole.extraction.voxels);
  CHECK(parts.extraction.is_full == whole.extraction.is_full);
  CHECK(parts.extraction.statistics.regions == whole.extraction.statistics.regions);
  CHECK(parts.extraction.statistics.rings == whole.extraction.statistics.rings);
  CHECK(parts.extraction.statistics.fragments == 0);
  CHECK_FALSE(parts.extraction.is_of_slab);
  CHECK(are_same(whole.surface, parts.surface));
  for (const unsigned jobs : {1U, 5U, 7U}) {
    CAPTURE(jobs);
    options.jobs = jobs;
    CHECK(are_same(extracted(volume, options).surface, parts.surface));
  }
}

VolumeInfo info_of(std::uint32_t width, std::uint32_t height, std::uint32_t depth) {
  VolumeInfo info;
  info.dims = {width, height, depth};
  return info;
}

std::vector<SliceSpan> parts_of(const VolumeInfo& info) {
  return discmc::meshing::parts_of(info, {0, info.dims[2]});
}

}  // namespace

TEST_CASE(
    "parts for parallel extraction cover the volume and are as thick as memory per slice allows") {
  for (const std::uint32_t depth : {1U, 15U, 16U, 17U, 33U, 275U, 5000U}) {
    std::uint32_t end = 0;
    for (const SliceSpan& part : parts_of(info_of(4, 4, depth))) {
      CHECK(part.first == end);
      CHECK(part.count() >= 1);
      CHECK(part.count() <= 32);
      end = part.end;
    }
    CHECK(end == depth);
  }
  CHECK(parts_of(info_of(4, 4, 16)).size() == 1);
  CHECK(parts_of(info_of(512, 512, 512)).size() == 16);
  // At most 64 MiB, but at least two slices.
  CHECK(parts_of(info_of(4096, 4096, 100)).size() == 25);
  CHECK(parts_of(info_of(32766, 32766, 10)).size() == 5);
}

TEST_CASE("parts of a slab cover exactly the slices of the slab") {
  const auto parts = discmc::meshing::parts_of(info_of(4, 4, 100), {30, 80});
  CHECK(parts.size() > 1);
  CHECK(parts.front().first == 30);
  for (std::size_t i = 1; i < parts.size(); ++i) CHECK(parts[i].first == parts[i - 1].end);
  CHECK(parts.back().end == 80);
}

TEST_CASE("extraction in parts gives the regions of one sweep, in an order independent of --jobs") {
  for (const BitVolume& volume : tall_volumes())
    for (const Border border : {Border::closed, Border::open}) {
      check_same_surface(volume, options_with(border));
      check_same_surface(volume, options_with(border, true));
    }
}

TEST_CASE("the statistics of parts equal those of one sweep, within one cell and facet per seam") {
  const BitVolume volume = random({20, 17, 70}, 128, 2);
  const auto whole = extracted(volume, options_with(Border::closed)).extraction.statistics;
  ExtractionOptions options = options_with(Border::closed);
  options.jobs = 2;
  const auto parts = extracted(volume, options).extraction.statistics;
  const std::uint64_t seams = parts_of(info_of(20, 17, 70)).size() - 1;
  CHECK(parts.cells <= whole.cells);
  CHECK(parts.cells + seams >= whole.cells);
  CHECK(parts.facets + seams >= whole.facets);
  CHECK(parts.classic_triangles == whole.classic_triangles);
}

TEST_CASE_FIXTURE(Workshop, "files written by extract do not depend on --jobs") {
  std::string samples;
  std::uint32_t noise = 1;
  for (int i = 0; i < 40 * 40 * 70; ++i) {
    noise = noise * 1664525 + 1013904223;
    samples.push_back(static_cast<char>(i % 40 / 4 % 2 * 60 + static_cast<int>(noise >> 26)));
  }
  write("v.raw", samples);
  write("m.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 40 40 70\nencoding: raw\n\n" +
                      std::string(40 * 40 * 35, 1) + std::string(40 * 40 * 35, 0));
  const std::string volume = "extract v.raw --dims 40,40,70 --type u8 --iso 50 -q ";
  for (const std::string options :
       {"-o v.stl", "-o v.ply", "-o v.obj --normals surface", "-o v.glb --border open",
        "-o v.ply --median 3 --largest 1", "-o v.ply --surface interpolated --mask m.nrrd",
        "-o v.ply --smooth auto --triangles 3000", "-o v.dmc", "-o v.dmc --iso 80 --wire regions",
        "-o v.dmc --wire slices --levels 4"}) {
    CAPTURE(options);
    const std::string file = options.substr(3, 5);
    done(volume + options + " --jobs 1");
    const std::string one = read(file);
    CHECK(one.size() > 10000);
    constexpr int jobs[] = {2, 7, 3};
    for (std::size_t i = 0; i < std::size(jobs); i += discmc::reference::step(2)) {
      done(volume + options + " --jobs " + std::to_string(jobs[i]));
      CHECK(read(file) == one);
    }
  }
  done(volume + "-o v.stl --jobs 1");
  done(volume + "-o all.stl");
  CHECK(read("all.stl") == read("v.stl"));
  const std::string slices = volume + "--wire slices --iso 80 --mask m.nrrd --median 3 ";
  done(slices + "-o v.dmc");
  CHECK(read("v.dmc").size() > 3000);
  done(slices + "-o jobs.dmc --jobs 2");
  CHECK(read("jobs.dmc") == read("v.dmc"));
}

TEST_CASE_FIXTURE(Workshop, "meshes and output of --labels do not depend on --jobs") {
  std::string labels;
  for (int i = 0; i < 32 * 32 * 24; ++i) {
    const int x = i % 32, y = i / 32 % 32, z = i / 1024;
    labels.push_back(static_cast<char>(1 + x / 8 + 4 * (y / 8) + 16 * (z / 8)));
  }
  write("v.raw", labels);
  const std::string volume = "extract v.raw --dims 32,32,24 --type u8 --labels all ";
  for (const std::string options :
       {"-o v.glb", "-o v.csv --bodies", "-o v.glb --smooth auto",
        "-o v.3mf --smooth auto --triangles 10", "-o '{name}.stl' --largest 1 --max-error 0.1"}) {
    CAPTURE(options);
    const std::string file = options[3] == 'v' ? options.substr(3, 5) : "17.stl";
    const std::string printed = done(volume + options + " --jobs 1");
    const std::string one = read(file);
    CHECK(one.size() > 100);
    CHECK(done(volume + options + " --jobs 3") == printed);
    CHECK(read(file) == one);
  }
}

TEST_CASE("packets of parts hold the regions of one sweep, in an order independent of --jobs") {
  for (const BitVolume& volume : tall_volumes()) {
    ExtractionOptions options = options_with(Border::closed);
    const auto whole = regions_of(extracted(volume, options).surface);
    options.jobs = 2;
    const Surface parts = streamed(volume, options);
    CHECK(describe_difference(regions_of(parts), whole) == "");
    options.jobs = 5;
    CHECK(are_same(streamed(volume, options), parts));
  }
}

TEST_CASE_FIXTURE(Workshop,
                  "extract refuses a truncated volume with any --jobs, and leaves no file") {
  write("v.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 20 20 60\nencoding: raw\n\n" +
                      std::string(20 * 20 * 45, 'a'));
  for (const std::string jobs : {"1", "4"}) {
    fails("extract v.nrrd --iso 50 -o v.stl --jobs " + jobs, 1, {"v.nrrd"});
  }
}

TEST_CASE_FIXTURE(Workshop, "--jobs 0, and --jobs for a stream with normals, are refused") {
  write("v.raw", std::string(4 * 4 * 4, 'a'));
  const auto refused = [&](const std::string& options, const std::string& part) {
    fails("extract v.raw --dims 4,4,4 --type u8 --iso 50 " + options, 2, {part});
  };
  refused("-o v.stl --jobs 0", "--jobs");
  refused("-o v.dmc --jobs 2 --normals gradient", "leave one out");
}

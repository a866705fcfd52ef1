// A volume in slabs, one stream each, and their join: extract --slab, and join.
#include <discmc/encoder.hpp>

#include "command.hpp"
#include "hand_made.hpp"
#include "oracle/thinned.hpp"
#include "streams/stream_output.hpp"
#include "streams/stream_reader.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"

namespace {

using namespace command_tests;
using namespace discmc;
using discmc::reference::Region;

// Bodies and noise, so that many chains, and holes too, cross every seam.
std::string rough_samples(int width, int height, int depth) {
  std::string samples;
  std::uint32_t noise = 1;
  for (int i = 0; i < width * height * depth; ++i) {
    noise = noise * 1664525 + 1013904223;
    const int x = i % width, y = i / width % height;
    samples.push_back(static_cast<char>((x / 3 + y / 3) % 2 * 60 + static_cast<int>(noise >> 26)));
  }
  return samples;
}

const std::string volume = "extract v.raw --dims 13,11,9 --type u8 --iso 50 -q ";

// Encodes a stream again, as firmware does if the number of slices is not known in advance.
class WithoutDepth {
 public:
  SinkResult accept(const Event& event) {
    if (event.kind == Event::Kind::start) {
      StreamLabel label = event.header->label();
      label.depth = 0;
      REQUIRE(encoder_.start(label, output_.byte_output()) == Status::ok);
    }
    return encoder_.accept(event);
  }
  std::string stream() {
    REQUIRE(encoder_.flush() == Status::ok);
    return bytes_.str();
  }

 private:
  std::ostringstream bytes_;
  discmc::command::StreamOutput output_{&bytes_};
  discmc::Encoder encoder_;
};

struct Slabs : Workshop {
  Slabs() { write("v.raw", rough_samples(13, 11, 9)); }
  std::vector<Region> regions_in(const std::string& stream) const {
    discmc::meshing::SurfaceBuilder builder;
    discmc::meshing::GrowingJoiner joiner(discmc::make_sink(builder));
    discmc::meshing::StreamReader reader(discmc::make_sink(joiner));
    std::istringstream in(read(stream));
    reader.read(in);
    joiner.finish();
    CHECK(reader.report().is_complete());
    return hand_made::regions_of(builder.surface());
  }
  std::string write_slabs(int count, const std::string& options = {}) const {
    std::string names;
    for (int slab = 1; slab <= count; ++slab) {
      const std::string name = "part" + std::to_string(slab) + ".dmc";
      done(volume + options + "--slab " + std::to_string(slab) + "/" + std::to_string(count) +
           " -o " + name);
      names = name + " " + names;  // counted from above
    }
    return names;
  }
  void forget_depth(const std::string& stream) const {
    WithoutDepth encoder;
    discmc::meshing::StreamReader reader(discmc::make_sink(encoder));
    std::istringstream in(read(stream));
    reader.read(in);
    write(stream, encoder.stream());
  }
};

}  // namespace

TEST_CASE_FIXTURE(Slabs, "join gives the regions of the whole volume for slabs of any thickness") {
  for (const std::string options :
       {"", "--border open ", "--median 3 ", "--memory 1024 ", "--crop 2..12,0..10,1..7 "}) {
    done(volume + options + "-o whole.dmc");
    const std::vector<Region> whole = regions_in("whole.dmc");
    CHECK(whole.size() > 20);
    constexpr int counts[] = {2, 1, 3, 7};
    for (std::size_t i = 0; i < std::size(counts); i += discmc::reference::step(2)) {
      const int count = counts[i];
      INFO("options ", options, ", count ", count);
      done("join " + write_slabs(count, options) + "-o joined.dmc");
      CHECK(discmc::reference::describe_difference(regions_in("joined.dmc"), whole) == "");
      CHECK(info_of("joined.dmc")["complete"] == "yes");
    }
  }
}

TEST_CASE_FIXTURE(
    Slabs,
    "join gives the regions of the whole volume for slabs that are extracted in several parts") {
  std::string samples = rough_samples(20, 20, 80);
  // A plate with many holes does not fit a packet.
  for (int i = 30 * 400; i < 34 * 400; ++i)
    samples[static_cast<std::size_t>(i)] = i % 2 == 0 || i / 20 % 2 == 0 ? 'z' : 0;
  write("v.raw", samples);
  const std::string tall = "extract v.raw --dims 20,20,80 --type u8 --iso 50 -q ";
  done(tall + "-o whole.dmc");
  for (const std::string slab : {"1", "2"}) {
    done(tall + "--slab " + slab + "/2 -o " + slab + ".dmc");
    done(tall + "--slab " + slab + "/2 --jobs 3 -o jobs.dmc");
    CHECK(read("jobs.dmc") == read(slab + ".dmc"));
  }
  done("join 2.dmc 1.dmc -o joined.dmc");
  CHECK(discmc::reference::describe_difference(regions_in("joined.dmc"), regions_in("whole.dmc")) ==
        "");
  auto whole = info_of("whole.dmc"), joined = info_of("joined.dmc");
  for (const std::string key : {"regions", "holes", "links", "corners", "complete", "fragments"}) {
    CAPTURE(key);
    CHECK(joined[key] == whole[key]);
  }
}

TEST_CASE_FIXTURE(Slabs, "slabs may be joined in several steps, and missing slices are listed") {
  done(volume + "-o whole.dmc");
  write_slabs(9);
  const Result part = run("join part1.dmc part2.dmc part5.dmc part9.dmc -o part.dmc");
  CHECK(part.code == 3);
  CHECK(contains(part.error, "the slices 2 to 3 and 5 to 7 are missing"));
  CHECK(contains(run("info part.dmc").out, "slab of the slices 4 to 4 of 9"));
  CHECK(contains(run("decode part.dmc -o part.stl").error,
                 "the stream holds only the slices 0 to 1, 4 to 4 and 8 to 8 of 9; join it with "
                 "the other slabs by discmc join"));
  done("join part4.dmc part6.dmc part.dmc part3.dmc part8.dmc part7.dmc -o all.dmc");
  CHECK(discmc::reference::describe_difference(regions_in("all.dmc"), regions_in("whole.dmc")) ==
        "");
  CHECK_FALSE(contains(done("info all.dmc"), "slab"));
}

TEST_CASE_FIXTURE(Slabs,
                  "the report of join matches its output, also if a slab is truncated or missing") {
  write_slabs(3);
  const std::string cut = read("part2.dmc");
  write("cut.dmc", cut.substr(0, cut.size() * 3 / 4));
  for (const std::string slabs :
       {"part1.dmc cut.dmc part3.dmc", "cut.dmc", "part1.dmc part3.dmc"}) {
    CAPTURE(slabs);
    const Result joined = run("join " + slabs + " -o joined.dmc");
    CHECK(joined.code == 3);
    auto written = info_of("joined.dmc");
    CHECK(contains(joined.out, "\n" + written["regions"] + " polygons\n"));
    if (contains(joined.error, "loose fragments have no partner"))
      CHECK(contains(joined.error,
                     " " + written["lost_pieces"] + " loose fragments have no partner"));
  }
}

TEST_CASE_FIXTURE(Slabs, "join reads the depth of the volume from the slabs' records") {
  done(volume + "-o whole.dmc");
  write_slabs(3);
  for (const std::string part : {"part1.dmc", "part2.dmc", "part3.dmc"}) forget_depth(part);
  const Result part = run("join part3.dmc part1.dmc -o part.dmc");
  CHECK(part.code == 3);
  CHECK(contains(part.error, "the slices 3 to 5 are missing"));
  done("join part.dmc part2.dmc -o all.dmc");
  CHECK(discmc::reference::describe_difference(regions_in("all.dmc"), regions_in("whole.dmc")) ==
        "");
  done(
      "extract v.raw --dims 13,11,8 --skip-bytes 143 --type u8 --iso 50 -q --slab 2/2 "
      "-o other.dmc");
  forget_depth("other.dmc");
  CHECK(contains(run("join part1.dmc other.dmc -o joined.dmc").error,
                 "other.dmc: its slab is part of 8 slices, and the volume has 9"));
}

TEST_CASE_FIXTURE(Slabs, "join refuses streams that are no slabs of one surface") {
  write_slabs(3);
  done("extract v.raw --dims 13,11,9 --type u8 --iso 51 -q --slab 2/3 -o other.dmc");
  done("extract v.raw --dims 13,11,9 --type u8 --iso 50 -q --wire slices -o slices.dmc");
  const auto refused = [&](const std::string& streams, const std::string& part) {
    fails("join " + streams + " -o joined.dmc", 1, {part});
  };
  refused("part1.dmc part2.dmc part1.dmc", "discmc: part1.dmc: the slices 0 to 2 are given twice");
  refused("part1.dmc other.dmc", "at threshold 51, and part1.dmc has");
  refused("part1.dmc slices.dmc", "discmc: slices.dmc: the slices 0 to 2 are given twice");
  refused("part1.dmc v.raw", "v.raw");
  done(volume + "--iso 20 -o two.dmc");
  refused("two.dmc", "channel 1 (threshold 20), and join accepts one surface per stream");
}

TEST_CASE_FIXTURE(Slabs, "an invalid slab is refused with the valid range") {
  for (const std::string slab : {"0/3", "4/3", "1", "1/", "/2", "a/b", "1/0", "1/3x", "-1/3"})
    fails(volume + "--slab=" + slab + " -o s.dmc", 2, {"as in 2/7"});
}

TEST_CASE_FIXTURE(Workshop, "help and completions of join accept any number of streams") {
  CHECK(contains(done("join --help"), "discmc join [OPTIONS] -o FILE STREAM..."));
  CHECK(contains(done("completions zsh"), "'*:FILE:_files'"));
}

TEST_CASE_FIXTURE(Slabs, "extract --slab reads no slices behind the slab") {
  const Result result = shell(
      "head -c $((13 * 11 * 4)) v.raw | \"$discmc\" extract - --dims 13,11,9 --type u8 --iso 50 "
      "--spacing 1,1,1 --slab 1/3 -q -o first.dmc");
  CHECK(result.code == 0);
  CHECK(result.error.empty());
}

// The commands for streams (decode, info, render), with complete, damaged and hostile streams.
#include <discmc/placement.hpp>

#include "command.hpp"
#include "oracle/slice_stream.hpp"
#include "oracle/stream.hpp"
#include "oracle/thinned.hpp"

namespace {

using namespace command_tests;
using discmc::reference::ball;
using discmc::reference::box;
using discmc::test::Bytes;

Bytes bytes_of(const std::string& text) {
  return Bytes(text.begin(), text.end());
}

std::string text_of(const Bytes& bytes) {
  return std::string(bytes.begin(), bytes.end());
}

// Writes the stream of a volume of a few packets and returns it.
std::string write_stream(const Workshop& workshop, const std::string& name) {
  workshop.write("v.nrrd", ball({20, 20, 20}, {19, 19, 19}, 81), "spacings: 0.5 1 2\n");
  workshop.done("extract v.nrrd --iso 100 -o " + name);
  return workshop.read(name);
}

std::uint32_t big_endian_at(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

void check_size(const std::string& png, std::uint32_t width, std::uint32_t height) {
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(big_endian_at(png, 16) == width);
  CHECK(big_endian_at(png, 20) == height);
}

}  // namespace

TEST_CASE_FIXTURE(Workshop, "a file that is no stream is refused with the command that reads it") {
  write_stream(*this, "v.dmc");
  done("decode v.dmc -o v.stl");
  fails("decode v.nrrd -o o.stl", 1,
        {"v.nrrd: this is a volume, not a stream; give it to discmc extract"});
  fails("decode . -o o.stl", 1, {"this is a volume, not a stream"});
  for (const std::string arguments : {"decode v.stl -o o.ply", "info v.stl"})
    fails(arguments, 1, {"v.stl: this is a mesh, not a stream; only discmc compare"});
}

TEST_CASE_FIXTURE(
    Workshop,
    "a stream of another version is refused with the version's number, even after lost packets") {
  const Bytes stream = bytes_of(write_stream(*this, "v.dmc"));
  for (const std::uint8_t version : Bytes{0, 2, 99}) {
    const Bytes other = discmc::test::with_version(version, stream);
    Bytes late = discmc::test::frames_of(stream)[1];
    late.insert(late.end(), other.begin(), other.end());
    for (const Bytes& refused : {other, late}) {
      write("other.dmc", text_of(refused));
      for (const std::string arguments :
           {"decode other.dmc -o o.stl", "info other.dmc", "render other.dmc -o o.png",
            "info other.dmc --stream-channel 0 --scan 0"}) {
        const Result result = run(arguments);
        CHECK(result.code == 1);
        CHECK(contains(result.error, "other.dmc: stream version " + std::to_string(version) +
                                         " is unknown; this discmc reads version 1, so use the "
                                         "release of discmc that wrote the stream"));
      }
    }
  }
}

TEST_CASE_FIXTURE(Workshop, "info of a stream prints a key and a value per line") {
  const std::string stream = write_stream(*this, "v.dmc");
  auto info = info_of("v.dmc");
  for (const char* key :
       {"dimensions", "spacing", "threshold", "border", "regions", "rings", "holes", "links",
        "corners", "polygons_3", "polygons_4", "polygons_5plus", "fragments", "skipped_rows",
        "lost_packets", "lost_pieces", "bytes", "complete"}) {
    INFO(key);
    CHECK(info.count(key) == 1);
    CHECK(!info[key].empty());
  }
  CHECK(info["dimensions"] == "20 20 20");
  CHECK(info["spacing"] == "0.5 1 2");
  CHECK(info["threshold"] == "100");
  CHECK(info["border"] == "closed");
  CHECK(info["bytes"] == std::to_string(stream.size()));
  CHECK(info["complete"] == "yes");
  CHECK(std::stoi(info["regions"]) + std::stoi(info["holes"]) == std::stoi(info["rings"]));
  CHECK(std::stoi(info["polygons_3"]) + std::stoi(info["polygons_4"]) +
            std::stoi(info["polygons_5plus"]) ==
        std::stoi(info["regions"]));
}

TEST_CASE_FIXTURE(Workshop, "info of a stream counts simple rings and their corners") {
  write("v.nrrd", box({6, 4, 5}, {1, 1, 1}, {4, 2, 3}));
  done("extract v.nrrd --iso 100 -o v.dmc");
  auto info = info_of("v.dmc");
  CHECK(info["regions"] == "26");
  CHECK(info["rings"] == "26");
  CHECK(info["holes"] == "0");
  CHECK(info["polygons_3"] == "8");
  CHECK(info["polygons_4"] == "18");
  CHECK(info["corners"] == "96");
  CHECK(info["normals"] == "0");
  done("extract v.nrrd --iso 100 --normals gradient -o v.dmc");
  // One normal per corner.
  CHECK(info_of("v.dmc")["normals"] == "96");
}

TEST_CASE_FIXTURE(Workshop, "decode, info and render read streams from standard input and pipes") {
  write_stream(*this, "v.dmc");
  done("decode v.dmc -o v.stl");
  done("render v.dmc -o v.png --size 30,20");
  CHECK(shell("\"$discmc\" info - < v.dmc").out == done("info v.dmc"));
  CHECK(shell("cat v.dmc | \"$discmc\" decode - -o piped.stl").code == 0);
  CHECK(shell("cat v.dmc | \"$discmc\" render - -o piped.png --size 30,20").code == 0);
  CHECK(read("piped.stl") == read("v.stl"));
  CHECK(read("piped.png") == read("v.png"));
  const Result result =
      shell("\"$discmc\" extract v.nrrd --iso 100 -q | \"$discmc\" decode - -o piped.stl");
  CHECK(result.code == 0);
  CHECK(read("piped.stl") == read("v.stl"));
}

TEST_CASE_FIXTURE(Workshop, "streams of slices and of regions are recognized automatically") {
  const std::string regions = write_stream(*this, "v.dmc");
  done("extract v.nrrd --iso 100 --wire slices -o s.dmc");
  CHECK(read("s.dmc").size() < regions.size() / 2);
  for (const char* stream : {"v.dmc", "s.dmc"}) {
    done(std::string("decode ") + stream + " -o " + stream + ".stl");
    done(std::string("decode ") + stream + " -o again-" + stream);
    done(std::string("render ") + stream + " -o " + stream + ".png --size 30,20");
  }
  CHECK(read("s.dmc.stl") == read("v.dmc.stl"));
  CHECK(read("s.dmc.png") == read("v.dmc.png"));
  CHECK(read("again-s.dmc") == read("again-v.dmc"));
  auto of_regions = info_of("v.dmc"), of_slices = info_of("s.dmc");
  CHECK(of_regions["wire"] == "regions");
  CHECK(of_slices["wire"] == "slices");
  for (const char* key : {"dimensions", "spacing", "threshold", "regions", "links", "complete"})
    CHECK(of_slices[key] == of_regions[key]);
}

TEST_CASE_FIXTURE(Workshop,
                  "info of a stream of slices with a lost packet reports the missing rows") {
  write_stream(*this, "v.dmc");
  done("extract v.nrrd --iso 100 --wire slices --key-slices 5 -o s.dmc");
  const std::string whole = read("s.dmc");
  // The third frame is that of the second key slice; the first is the header.
  const std::size_t second = whole.find('\0', whole.find('\0') + 1) + 1;
  const std::size_t third = whole.find('\0', second) + 1;
  write("lost.dmc", whole.substr(0, second) + whole.substr(third));
  const Result result = run("info lost.dmc");
  CHECK(result.code == 3);
  CHECK(result.error.find("1 packet is missing, 100 rows are missing; send or copy") !=
        std::string::npos);
  CHECK(result.out.find("lost_rows 100\n") != std::string::npos);
  CHECK(result.out.find("skipped_rows 0\n") != std::string::npos);
  CHECK(result.out.find("slices") != std::string::npos);
}

TEST_CASE_FIXTURE(Workshop, "a stream that claims more lost rows than a scan can have is refused") {
  write("v.dmc", text_of(discmc::test::lost_slices({1, 1, 2000})));
  CHECK(run("info v.dmc").code == 3);
  write("v.dmc", text_of(discmc::test::lost_slices({1, 32766, 0x3FFFFFFF})));
  fails("info v.dmc", 1, {"more than 68650825 rows were lost"});
}

TEST_CASE_FIXTURE(Workshop, "render draws a picture of the given --size") {
  write_stream(*this, "v.dmc");
  done("render v.dmc -o plain.png --size 60,40");
  done("render v.dmc -o edges.png --size 60,40 --edges");
  done("render v.dmc -o side.png --size 60,40 --view -1,0,0");
  done("render v.dmc -o above.png --size 1,7 --view 0,0,1");
  for (const char* name : {"plain.png", "edges.png", "side.png"}) check_size(read(name), 60, 40);
  check_size(read("above.png"), 1, 7);
  CHECK(read("plain.png") != read("edges.png"));
  CHECK(read("plain.png") != read("side.png"));
}

TEST_CASE_FIXTURE(
    Workshop, "decode of an incomplete stream writes all complete regions and exits with code 3") {
  const auto frames = discmc::test::frames_of(bytes_of(write_stream(*this, "v.dmc")));
  REQUIRE(frames.size() > 5);
  auto gap = frames, no_end = frames;
  gap.erase(gap.begin() + 2);
  no_end.resize(frames.size() - 2);
  write("gap.dmc", text_of(discmc::test::joined(gap)));
  write("no end.dmc", text_of(discmc::test::joined(no_end)));
  const int whole = std::stoi(info_of("v.dmc")["regions"]);
  for (const std::string name : {"gap", "'no end'"}) {
    INFO(name);
    check_parts(run("info " + name + ".dmc"), 3, {".dmc: the stream is incomplete"});
    auto info = info_of(name + ".dmc");
    CHECK(info["complete"] == "no");
    CHECK(std::stoi(info["regions"]) > 0);
    CHECK(std::stoi(info["regions"]) < whole);
    if (name == "gap") {
      CHECK(info["lost_packets"] == "1");
      CHECK(std::stoi(info["regions"]) + std::stoi(info["lost_pieces"]) == whole);
    }
    for (const std::string output : {"o.dmc", "o.stl", "o.obj", "o.ply", "o.jsonl"}) {
      CHECK(run("decode " + name + ".dmc -o " + output).code == 3);
      CHECK(!read(output).empty());
    }
    CHECK(info_of("o.dmc")["regions"] == info["regions"]);
    CHECK(info_of("o.dmc")["complete"] == "no");
    CHECK(run("render " + name + ".dmc -o o.png --size 9,9").code == 3);
    check_size(read("o.png"), 9, 9);
  }
}

TEST_CASE_FIXTURE(Workshop,
                  "noise and empty files are refused as streams by name, and no file is written") {
  std::string noise;
  discmc::test::Chance chance(3);
  for (int i = 0; i < 5000; ++i) noise += static_cast<char>(chance.byte());
  write("noise.dmc", noise);
  write("empty.dmc", "");
  for (const std::string file : {"noise.dmc", "empty.dmc", "none.dmc", "."})
    for (const std::string& arguments :
         {"info " + file, "decode " + file + " -o o.stl", "decode " + file + " -o o.dmc",
          "render " + file + " -o o.png"}) {
      if (arguments == "render . -o o.png") continue;  // a folder may be a volume of slices
      fails(arguments, 1, {"discmc: " + file + ": "});
    }
  CHECK(contains(run("info none.dmc").error, "check the name"));
}

TEST_CASE_FIXTURE(Workshop,
                  "streams with damaged bytes or packets cause an exit code and never a crash") {
  const std::string stream = write_stream(*this, "v.dmc");
  const auto frames = discmc::test::frames_of(bytes_of(stream));
  discmc::test::Chance chance(4);
  const auto below = [&chance](std::size_t limit) {
    return chance.below(static_cast<std::uint32_t>(limit));
  };
  for (uint32_t round = 0; round < 25; round += discmc::reference::step(3)) {
    std::string damaged = stream;
    if (round % 2 == 0) {  // a change that the checksum detects
      for (int i = 0; i < 3; ++i) damaged[below(damaged.size())] = static_cast<char>(chance.byte());
    } else {  // a change that the checksum does not detect
      auto mended = frames;
      auto& frame = mended[1 + below(frames.size() - 1)];
      auto packet = discmc::test::packet_of(frame);
      packet.payload[below(packet.payload.size())] = chance.byte();
      frame = discmc::test::frame_of(packet);
      damaged = text_of(discmc::test::joined(mended));
    }
    write("d.dmc", damaged);
    for (const char* arguments : {"info d.dmc", "decode d.dmc -o o.stl", "decode d.dmc -o o.dmc",
                                  "render d.dmc -o o.png --size 16,16"}) {
      const Result result = run(arguments);
      INFO(round, " ", arguments, "\n", result.error);
      CHECK(result.code < 4);
      CHECK(result.code != 2);
      CHECK((result.code == 0 || contains(result.error, "discmc: ")));
      CHECK(!contains(result.error, "runtime error"));  // the report of a sanitizer
      CHECK(!contains(result.error, "Sanitizer"));
    }
  }
}

TEST_CASE_FIXTURE(Workshop, "decode to a stream keeps all regions if the header comes late") {
  auto frames = discmc::test::frames_of(bytes_of(write_stream(*this, "v.dmc")));
  std::swap(frames[0], frames[1]);
  write("late.dmc", text_of(discmc::test::joined(frames)));
  run("decode late.dmc -o late.jsonl");
  run("decode late.dmc -o anew.dmc");
  run("decode anew.dmc -o anew.jsonl");
  CHECK(!read("late.jsonl").empty());
  CHECK(read("late.jsonl") == read("anew.jsonl"));
}

TEST_CASE_FIXTURE(Workshop, "info prints application records and a placement as text") {
  discmc::test::Line line;
  discmc::Encoder encoder;
  const auto volume = discmc::reference::from_bits({1, 1, 1}, 1);
  discmc::reference::require_ok(
      discmc::test::begin_stream(encoder, discmc::test::header_of(volume), line.output()));
  const std::uint8_t bytes[] = {0xCA, 0xFE};
  discmc::reference::require_ok(encoder.write_record({9, 3, 5, bytes, 2}));
  discmc::Placement placement{};
  placement.space = discmc::Space::ras;
  std::uint8_t buffer[discmc::Placement::record_bytes];
  discmc::reference::require_ok(encoder.write_record(discmc::record_of(placement, buffer)));
  discmc::test::encode_all(encoder, discmc::test::events_of(volume));
  write("r.dmc", text_of(line.bytes));
  const std::string info = done("info r.dmc");
  CHECK(contains(info, "record kind 9"));
  CHECK(contains(info, "RAS"));
}

TEST_CASE_FIXTURE(Workshop, "decode skips and reports an invalid polygon in a stream") {
  using Kind = discmc::Event::Kind;
  discmc::test::Line line;
  discmc::Encoder encoder;
  const auto volume = discmc::reference::from_bits({3, 3, 3}, 1 << 13);
  discmc::reference::require_ok(
      discmc::test::begin_stream(encoder, discmc::test::header_of(volume), line.output()));
  discmc::Event event{};
  const auto tell = [&](Kind kind) {
    event.kind = kind;
    REQUIRE(encoder.accept(event) == discmc::SinkResult::accepted);
  };
  event.incidence = discmc::incidence_of({0, 0, 1});
  event.start = {3, 2, 0};
  tell(Kind::region);
  for (const bool is_hole : {false, true}) {  // the same square twice
    event.is_hole = is_hole;
    tell(Kind::ring);
    for (int side = 0; side < 4; ++side) {
      event.run = discmc::Run::straight(static_cast<discmc::Direction>((6 + 2 * side) % 8), 1);
      tell(Kind::run);
    }
  }
  tell(Kind::region_end);
  discmc::test::encode_all(encoder, discmc::test::events_of(volume));
  write("c.dmc", text_of(line.bytes));
  for (const char* arguments : {"decode c.dmc -o c.stl", "render c.dmc -o c.png --size 16,16"}) {
    const Result result = run(arguments);
    CHECK(result.code == 3);  // the trailer counts eight regions
    CHECK(contains(result.error, "discmc: c.dmc: 1 of 9 polygons are invalid"));
    CHECK(contains(result.error, "the first is in -o FILE.jsonl, line 1\n"));
  }
  CHECK(read("c.stl").size() == 84 + 8 * 50);
}

TEST_CASE_FIXTURE(Workshop,
                  "packets of two scans with the same number are reported with a remedy") {
  write("v.nrrd", ball({20, 20, 20}, {19, 19, 19}, 81));
  done("extract v.nrrd --iso 100 --wire slices -o a.dmc");
  write("v.nrrd", ball({20, 20, 20}, {19, 19, 19}, 80));
  done("extract v.nrrd --iso 100 --wire slices -o b.dmc");
  auto a = discmc::test::frames_of(bytes_of(read("a.dmc")));
  const auto b = discmc::test::frames_of(bytes_of(read("b.dmc")));
  REQUIRE(a.size() == b.size());
  a.back() = b.back();
  write("m.dmc", text_of(discmc::test::joined(a)));
  check_parts(run("info m.dmc"), 3, {"give every scan another number"});
}

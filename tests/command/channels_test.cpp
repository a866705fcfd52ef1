// Several surfaces in one stream or on one link, through the command.
#include "command.hpp"

namespace {

using namespace command_tests;

// A cone of samples: the nearer to the middle, the higher.
std::string cone(int size) {
  std::string samples;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const auto far = [size](int at) { return std::abs(2 * at + 1 - size); };
        samples.push_back(static_cast<char>(std::max(0, 120 - 4 * (far(x) + far(y) + far(z)))));
      }
  return samples;
}

const std::string volume = "v.raw --dims 16,16,16 --type u8 ";

struct Cone : Workshop {
  Cone() { write("v.raw", cone(16)); }
};

}  // namespace

TEST_CASE_FIXTURE(Cone,
                  "extract with several --iso gives each threshold its own channel in streams of "
                  "regions and of slices") {
  for (const std::string wire : {"regions", "slices"}) {
    CAPTURE(wire);
    done("extract " + volume + "--iso 20 --iso 40 --iso 60 --scan 77 --wire " + wire +
         " -o all.dmc");
    const char* const isos[] = {"20", "40", "60"};
    for (int channel = 0; channel < 3; ++channel) {
      const std::string chosen = "all.dmc --stream-channel " + std::to_string(channel);
      auto info = info_of(chosen);
      CHECK(info["stream_channel"] == std::to_string(channel));
      CHECK(info["threshold"] == isos[channel]);
      CHECK(info["scan"] == "77");
      CHECK(info["complete"] == "yes");
      done("decode " + chosen + " -o of_all.stl");
      done("extract " + volume + "--iso " + isos[channel] + " -o alone.stl");
      CHECK(read("of_all.stl") == read("alone.stl"));
      done("decode " + chosen + " -o again.dmc");
      CHECK(info_of("again.dmc")["threshold"] == isos[channel]);
      CHECK(info_of("again.dmc")["stream_channel"] == std::to_string(channel));
    }
    done("render all.dmc --stream-channel 1 -o p.png");
  }
}

TEST_CASE_FIXTURE(Cone, "each channel of a stream has the normals of its own surface") {
  const std::string normals = " --normals gradient -o ";
  done("extract " + volume + "--iso 60 --iso 80" + normals + "all.dmc");
  for (const int channel : {0, 1}) {
    const std::string iso = std::to_string(60 + 20 * channel);
    done("extract " + volume + "--iso " + iso + normals + "alone.dmc");
    done("decode alone.dmc" + normals + "alone.ply");
    done("decode all.dmc --stream-channel " + std::to_string(channel) + normals + "of_all.ply");
    CHECK(contains(read("of_all.ply"), "property float nx"));
    CHECK(read("of_all.ply") == read("alone.ply"));
  }
}

TEST_CASE_FIXTURE(
    Cone, "without --stream-channel, decode reads the first surface, and a note lists all") {
  done("extract " + volume + "--iso 20 --iso 40 -o all.dmc");
  const auto first = run("decode all.dmc -o first.stl");
  CHECK(first.code == 0);
  CHECK(contains(
      first.error,
      "scan 0 channel 0 of scan 0 channel 0 (threshold 20), scan 0 channel 1 (threshold 40)"));
  CHECK(run("decode all.dmc --stream-channel 0 -o first.stl").error.empty());
  const auto none = run("decode all.dmc --stream-channel 2 -o none.stl");
  CHECK(none.code == 1);
  CHECK(contains(none.error, "no such surface; choose one of scan 0 channel 0 (threshold 20), "));
}

TEST_CASE_FIXTURE(Cone, "info and decode separate the streams of two scans in one file") {
  done("extract " + volume + "--iso 20 --scan 1 -o one.dmc");
  done("extract " + volume + "--iso 40 --scan 2 -o two.dmc");
  write("link.dmc", read("one.dmc") + read("two.dmc"));
  auto info = info_of("link.dmc");
  CHECK(info["scan"] == "1");
  CHECK(info["complete"] == "yes");
  CHECK(std::stoi(info["foreign_packets"]) > 2);
  info = info_of("link.dmc --scan 2");
  CHECK(info["scan"] == "2");
  CHECK(info["threshold"] == "40");
  CHECK(info["complete"] == "yes");
  CHECK(info["foreign_packets"] == "0");
  CHECK(contains(run("info link.dmc").error, "choose with --scan N"));
  done("decode two.dmc -o alone.stl");
  done("decode link.dmc --scan 2 -o of_link.stl");
  CHECK(read("of_link.stl") == read("alone.stl"));
  CHECK(run("decode link.dmc --scan 3 -o none.stl").code == 1);
  CHECK(run("render " + volume + "--iso 20 --scan 1 -o p.png").code == 2);
}

TEST_CASE_FIXTURE(
    Cone, "info lists every surface of joined streams that share a scan number and a channel") {
  done("extract " + volume + "--iso 20 --wire slices -o a.dmc");
  done("extract " + volume + "--iso 30 --iso 40 --wire slices -o b.dmc");
  write("link.dmc", read("a.dmc") + read("b.dmc"));
  const std::string list = done("info link.dmc");
  CHECK(contains(list, "surface scan 0 channel 0 threshold 20\n"));
  CHECK(contains(list, "surface scan 0 channel 0 threshold 30\n"));
  CHECK(contains(list, "surface scan 0 channel 1 threshold 40\n"));
}

TEST_CASE_FIXTURE(Cone, "extract prints the encoder's memory for a stream of slices") {
  const std::string extract = "extract " + volume + "--iso 20 --wire slices -o s.dmc";
  const auto result = run(extract);
  CHECK(contains(result.out, "bytes of slice encoder"));
  CHECK_FALSE(contains(result.out, "arena"));
  for (const std::string memory : {" --memory 64K", " --capacities 100,10"})
    fails(extract + memory, 2, {"leave out --memory"});
}

TEST_CASE_FIXTURE(Cone, "render refuses several --iso, and --stream-channel for a volume") {
  CHECK(run("render " + volume + "--iso 20 --stream-channel 1 -o p.png").code == 2);
  CHECK(run("render " + volume + "--iso 20 --iso 30 -o p.png").code == 2);
}

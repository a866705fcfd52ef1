// discmc tune: the cost of a volume on a device, and the code for its firmware.
#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>

#include "command.hpp"

namespace {

using namespace command_tests;
using discmc::Limits;

constexpr Limits limits{40, 40};

struct Ball : Workshop {
  Ball() { write("v.nrrd", discmc::reference::ball({40, 40, 40}, {39, 39, 39}, 330)); }
};

std::string with_commas(std::uint64_t value) {
  std::string text = std::to_string(value);
  if (text.size() > 3) text.insert(text.size() - 3, ",");
  return text;
}

// The words of the line with this beginning, or none.
std::vector<std::string> words_of(const std::string& text, const std::string& begin) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.compare(0, begin.size(), begin) != 0) continue;
    std::istringstream words(line.substr(begin.size()));
    return {std::istream_iterator<std::string>(words), {}};
  }
  return {};
}

std::string code_of(const std::string& report, const std::string& heading) {
  const std::size_t at = report.find("---- " + heading + " ----\n");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = report.find('\n', at) + 1;
  return report.substr(begin, report.find("\n----", begin) - begin) + "\n";
}

}  // namespace

TEST_CASE_FIXTURE(Ball, "tune predicts the stream that extract makes in the same memory") {
  const std::string report = done("tune v.nrrd --iso 100 --memory 2K --baud 9600");
  INFO(report);
  done("extract v.nrrd --iso 100 --memory 2K -o v.dmc");
  const std::size_t bytes = read("v.dmc").size();
  const auto chosen = words_of(report, ">");
  REQUIRE(chosen.size() == 9);
  CHECK(chosen[0] == "2,048");
  CHECK(chosen[2] == with_commas(bytes));
  CHECK(std::stod(chosen[3]) ==
        doctest::Approx(static_cast<double>(bytes) * 10 / 9600).epsilon(0.01));
}

TEST_CASE_FIXTURE(
    Ball, "the memory that tune prints for no fragments suffices, and 256 bytes less do not") {
  const auto words = words_of(done("tune v.nrrd --iso 100"), "  no fragments from   ");
  REQUIRE(!words.empty());
  std::string digits = words[0];
  digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
  const auto fragments = [&](std::uint64_t memory) {
    done("extract v.nrrd --iso 100 -q -o v.dmc --memory " + std::to_string(memory));
    return info_of("v.dmc").at("fragments");
  };
  const std::uint64_t minimum = std::stoull(digits);
  CHECK(fragments(minimum) == "0");
  CHECK(fragments(minimum - 256) != "0");
}

TEST_CASE_FIXTURE(Ball, "tune prints estimates only for the kind of stream that --wire selects") {
  const std::string regions = done("tune v.nrrd --iso 100 --wire regions");
  CHECK(contains(regions, "Regions:"));
  CHECK(!contains(regions, "Slices:"));
  const std::string slices = done("tune v.nrrd --iso 100 --wire slices");
  CHECK(!contains(slices, "Regions:"));
  CHECK(contains(slices, with_commas(discmc::SliceEncoder::minimum_bytes({limits, {}, 16}))));
}

TEST_CASE_FIXTURE(Ball, "the code that tune prints compiles, in C++ and in C") {
  for (const char* options :
       {"", "--memory 3K --border open", "--capacities 300,20", "--median 3"}) {
    const std::string report = done(std::string("tune v.nrrd --iso 100 ") + options);
    for (const char* wire : {"regions", "slices"}) {
      INFO(report);
      write("block.cpp", code_of(report, std::string(wire) + ", C++"));
      write("block.c", code_of(report, std::string(wire) + ", C"));
      const std::string include = " -fsyntax-only -Wall -Wextra -Werror -Wno-unused -I '" +
                                  std::string(DISCMC_SOURCE_DIR) + "/lib' ";
      CHECK(shell("c++ -std=c++17" + include + "block.cpp").error == "");
      CHECK(shell("cc -std=c99" + include + "block.c").error == "");
    }
  }
}

TEST_CASE_FIXTURE(
    Ball,
    "the code that tune prints lists options of the surface that the code does not implement") {
  const auto code = [&](const std::string& options, const char* heading) {
    return code_of(done("tune v.nrrd " + options), heading);
  };
  const std::string left = "Not in this code: voxels above 250 are off; a MajorityFilter";
  for (const char* heading : {"regions, C++", "regions, C", "slices, C++", "slices, C"}) {
    CHECK(contains(code("--range 100..250 --median 3", heading), left));
    CHECK(!contains(code("--iso 100", heading), "Not in this code"));
  }
}

TEST_CASE_FIXTURE(Ball, "the code that tune prints states the threshold's value in the file") {
  const auto samples = volume_files::stored(volume_files::SampleType::u8);
  write("scaled.nii", volume_files::Nifti().scale(2, -1000).file(samples));
  const std::string scaled = done("tune scaled.nii --iso=-900");
  for (const char* heading : {"regions, C++", "regions, C", "slices, C++", "slices, C"})
    CHECK(contains(code_of(scaled, heading),
                   "The threshold of the stored samples is 50 for the value -900."));
  CHECK(!contains(done("tune v.nrrd --iso 100"), "of the stored samples"));
}

TEST_CASE_FIXTURE(Ball, "tune prints the value of a named threshold") {
  const Result result = run("tune v.nrrd --iso otsu");
  CHECK(contains(result.out, " (otsu)\n"));
  CHECK(!contains(result.out, ", at otsu"));
}

TEST_CASE_FIXTURE(Ball, "tune scales processor load by --clock, and by the costs of --core") {
  const auto work = [&](const std::string& options) {
    return std::stod(words_of(done("tune v.nrrd --iso 100 " + options), ">")[5]);
  };
  const double at_1_mhz = work("--clock 1M");
  CHECK(work("--clock 2MHz") == doctest::Approx(at_1_mhz / 2).epsilon(0.02));
  CHECK(work("--clock 1M --core cortex-m0plus") > at_1_mhz);
  CHECK(work("--clock 1M --core cortex-m7") < at_1_mhz);
}

TEST_CASE_FIXTURE(Ball, "tune refuses invalid values with the value and the remedy") {
  const auto refused = [&](const std::string& options, int code, const std::string& remedy) {
    fails("tune v.nrrd " + options, code, {remedy});
  };
  refused("", 2, "add --iso auto, or the threshold");
  refused("--iso 100 --clock fast", 2, "invalid clock 'fast'; expected Hertz, as in 48M");
  refused("--iso 100 --baud 0", 2, "invalid value '0'; expected bits per second");
  refused("--iso 100 --memory 100", 1,
          "give at least " + std::to_string(discmc::Extractor16::minimum_bytes(limits)));
  refused("--iso 100 --memory 1M", 1,
          "give at most " + std::to_string(discmc::Extractor16::bytes_for(limits, {32759, 0})));
  refused("--iso 100 --capacities 40000,1", 1, "expected 4 to 32759");
  refused("--iso 300", 1, "no voxel reaches 300");
  refused("--iso 300 --allow-empty", 2, "'--allow-empty' is not an option of tune");
  refused("--iso 100 --wire slices --memory 2K", 2, "leave out --memory and --capacities");
}

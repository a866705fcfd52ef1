// discmc info for volumes, and the distinction between volumes and streams.
#include "command.hpp"

namespace {

using namespace command_tests;
using namespace volume_files;

const std::string directions =
    "space: LPS\nspace directions: (0.5,0,0) (0,2,0) (0,0,3)\nspace origin: (1,2,3)\n";
const std::string u8_file = nrrd(nrrd_u8 + directions) + "\n" + u8;

std::string text_volume(const std::string& type, const std::string& sizes,
                        const std::string& samples) {
  return text_nrrd(type, sizes, samples, "2");
}

bool has_line(const std::string& text, const std::string& line) {
  return contains("\n" + text, "\n" + line + "\n");
}

}  // namespace

TEST_CASE_FIXTURE(Workshop, "info prints the header and the statistics of a volume") {
  write("v.nrrd", u8_file);
  const std::string info = done("info v.nrrd");
  INFO(info);
  for (const char* line :
       {"format NRRD, raw",  "type u8",          "slope 1",           "intercept 0",
        "frames 1",          "channels 1",       "dimensions 5 3 4",  "extent 2.5 6 12",
        "spacing 0.5 2 3",   "space lps",        "origin 1 2 3",      "axis_x 0.5 0 0",
        "axis_y 0 2 0",      "axis_z 0 0 3",     "voxels 60",         "not_numbers 0",
        "infinite 0",        "range 0 236",      "mean 118",          "percentile_1 0",
        "percentile_5 8",    "percentile_25 56", "percentile_50 116", "percentile_75 176",
        "percentile_95 224", "percentile_99 236"})
    CHECK(has_line(info, line));
}

TEST_CASE_FIXTURE(Workshop, "the histogram of info counts every voxel once, and fits 80 columns") {
  std::string samples = "-100000 90000";  // outliers
  for (int i = 0; i < 998; ++i) samples += ' ' + std::to_string(i);
  write("v.nrrd", text_volume("int", "10 10 10", samples));
  std::istringstream lines(done("info v.nrrd"));
  std::vector<std::array<double, 3>> found;
  for (std::string line; std::getline(lines, line);) {
    INFO(line);
    CHECK(line.size() <= 80);
    std::istringstream words(line);
    std::string key, bar;
    std::array<double, 3> values{};
    words >> key;
    if (key != "histogram") continue;
    words >> values[0] >> values[1] >> values[2] >> bar;
    found.push_back(values);
    CHECK(!bar.empty());
    CHECK(bar.size() <= 34);
  }
  REQUIRE(found.size() == 10);
  CHECK(found.front() == std::array<double, 3>{-100000, 100, 101});
  CHECK(found[4] == std::array<double, 3>{400, 500, 100});
  CHECK(found.back() == std::array<double, 3>{900, 90000, 99});
}

TEST_CASE_FIXTURE(
    Workshop, "info lists a few distinct values individually, and proposes integers as labels") {
  write("v.nrrd", text_volume("short", "2 2 2", "0 0 0 0 0 5 5 12"));
  const std::string info = done("info v.nrrd");
  INFO(info);
  CHECK(contains(info, "histogram          0          0           5 ####"));
  CHECK(contains(info, "histogram          5          5           2 ####"));
  CHECK(contains(info, "histogram         12         12           1 ####"));
  CHECK(has_line(info, "proposal --label N: one of 5 12"));
  REQUIRE(contains(info, "proposal --labels all: the values are few and whole"));
  CHECK(info.find("proposal --label") < info.find("proposal --iso"));
  write("v.nrrd", text_volume("float", "2 2 2", "0 0 0 0 0 5 5 12.5"));
  CHECK(!contains(done("info v.nrrd"), "--label"));
  write("v.nrrd", text_volume("double", "2 2 2", "0 0 0 0 0 5 5 1e300"));
  CHECK(!contains(done("info v.nrrd"), "--label"));
}

TEST_CASE_FIXTURE(Workshop, "info proposes Otsu's threshold, and tissues in Hounsfield units") {
  write("ct.nrrd", text_volume("short", "2 2 2", "-1000 -1000 -990 40 50 60 1200 1100"));
  write("mri.nrrd", text_volume("float", "2 2 2", "0.1 0.2 0.1 0.3 0.7 0.8 0.75 nan"));
  const std::string ct = done("info ct.nrrd");
  CHECK(contains(ct, "proposal --iso=300 bone"));
  CHECK(contains(ct, "proposal --iso=-300 skin"));
  CHECK(contains(ct, "proposal --iso="));
  const std::string mri = done("info mri.nrrd");
  INFO(mri);
  CHECK(contains(mri, "proposal --iso=0.5 otsu"));
  CHECK(!contains(mri, "skin"));
  CHECK(has_line(mri, "range 0.1 0.8"));
  CHECK(has_line(mri, "not_numbers 1"));
  const std::string series = DISCMC_SOURCE_DIR "/tests/command/volumes/dicom/";
  const Result dicom = run("info " + series + "u16.dcm");
  if (dicom.code == 0) CHECK(contains(dicom.out, " bone: "));  // if built with DICOM
}

TEST_CASE_FIXTURE(Workshop, "info of a volume without finite values prints no values") {
  write("v.nrrd", text_volume("float", "2 1 2", "nan inf nan nan"));
  const std::string info = done("info v.nrrd");
  CHECK(has_line(info, "not_numbers 3"));
  CHECK(has_line(info, "infinite 1"));
  CHECK(has_line(info, "note no value is finite; check the file"));
  CHECK(!contains(info, "range"));
  CHECK(!contains(info, "proposal"));
}

TEST_CASE_FIXTURE(Workshop,
                  "info prints a histogram for the extreme values of 64-bit floating point") {
  std::string least, most;
  for (int i = 0; i < 20; ++i) {
    least += std::to_string(i) + "e-322 ";
    most += (i % 2 == 0 ? "-0." : "0.") + std::to_string(i + 1) + "e308 ";
  }
  for (const std::string& samples : {least, most}) {
    write("v.nrrd", text_volume("double", "20 1 1", samples));
    CHECK(contains(done("info v.nrrd"), "\nhistogram "));
  }
  write("v.nrrd",
        text_volume("double", "2 2 2", "1.7e308 1.7e308 1.7e308 1.7e308 1.7e308 -1e308 5 1e300"));
  CHECK(has_line(done("info v.nrrd"), "mean 9.3750000125e+307"));
}

TEST_CASE_FIXTURE(
    Workshop,
    "info recognizes volumes and streams by their first bytes if the extension is unknown") {
  write("v.nrrd", u8_file);
  write("v.raw", u8);
  done("extract v.nrrd --iso 100 -q -o v.dmc");
  const std::string volume = done("info v.nrrd");
  const std::string stream = done("info v.dmc");
  write("packed", gzip(u8_file));
  shell("cp v.nrrd volume; cp v.dmc stream; cp v.raw samples");
  CHECK(done("info volume") == volume);
  CHECK(done("info stream") == stream);
  CHECK(shell("\"$discmc\" info - <v.nrrd").out == volume);
  CHECK(shell("cat v.nrrd | \"$discmc\" info -").out == volume);
  CHECK(shell("cat v.dmc | \"$discmc\" info -").out == stream);
  CHECK(contains(shell("cat packed | \"$discmc\" info -").out, "format NRRD, raw, gzip\n"));
  CHECK(contains(done("info samples --dims 5,3,4 --type u8"), "\nrange 0 236\n"));
  CHECK(contains(shell("\"$discmc\" info - --dims 5,3,4 --type u8 <v.raw").out, "\nrange 0 236\n"));
}

TEST_CASE_FIXTURE(Workshop, "info reads a large volume completely from a pipe") {
  write("v.nrrd",
        nrrd(nrrd_u8, "300 300 10") + "\n" + std::string(300 * 300 * 10 - 1, '\1') + '\7');
  const Result result = shell("cat v.nrrd | \"$discmc\" info -");
  CHECK(result.out == done("info v.nrrd"));
  CHECK(contains(result.out, "\nhistogram          7          7           1 #\n"));
}

TEST_CASE_FIXTURE(Workshop,
                  "info refuses volume options for streams, stream options for volumes, and files "
                  "of unknown content") {
  write("v.nrrd", u8_file);
  write("nothing", "words");
  fails("info v.nrrd --stream-channel 1", 2, {"--stream-channel", "applies to streams"});
  fails("info v.dmc --frame 1", 2, {"--frame", "applies to volumes"});
  fails("info nothing", 1, {"nothing", "no header of a discmc stream", "--dims and --type"});
  fails("info none.nrrd", 1, {"none.nrrd", "there is no such file"});
  fails("info " + std::string(300, 'v') + ".dmc", 1,
        {"v.dmc: ", "; check the name and the permissions"});
  write("short.nrrd", u8_file.substr(0, u8_file.size() - 1));
  CHECK(run("info short.nrrd").code == 1);
}

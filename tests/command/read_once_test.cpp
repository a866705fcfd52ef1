// Volumes from standard input and pipes.
#include <sys/stat.h>

#include <thread>

#include "command.hpp"

namespace {

using namespace command_tests;
using namespace volume_files;

const std::filesystem::path files = DISCMC_SOURCE_DIR "/tests/command/volumes";
const std::string nrrd_file = nrrd(nrrd_u8) + "\n" + u8;

}  // namespace

TEST_CASE_FIXTURE(Folder, "a pipe is read like a file with the same content") {
  const auto pipe = path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string local = metaimage(metaimage_u8 + "ElementDataFile = LOCAL\n");
  const std::pair<std::string, std::string> cases[] = {
      {nrrd_file, "NRRD, raw"},
      {gzip(nrrd_file), "NRRD, raw, gzip"},
      {Nifti().file(u8), "NIfTI-1"},
      {gzip(Nifti().file(u8)), "NIfTI-1, gzip"},
      {local + u8, "MetaImage, raw"},
      {contents(files / "vtk/u8-big.vtk"), "VTK, raw"},
      {contents(files / "numpy/u8-little.npy"), "NumPy"},
      {contents(files / "vti/u8-little-appended-raw.vti"), "VTK XML, raw"},
  };
  for (const auto& [content, format] : cases) {
    std::thread writer([&, bytes = content] { std::ofstream(pipe, std::ios::binary) << bytes; });
    check_volume(pipe, format);
    writer.join();
  }
}

TEST_CASE_FIXTURE(
    Folder, "a pipe whose header claims a large volume uses memory only for the samples received") {
  const auto pipe = path() / "pipe";
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  const std::string claim = nrrd(nrrd_u8, "32766 32766 1000000") + "\n" + u8;
  std::thread writer([&] { std::ofstream(pipe, std::ios::binary) << claim; });
  check_refusal(refusal(pipe), "slice 0 (the first is 0) of 1000000: 1073610696 bytes of it are");
  writer.join();
}

TEST_CASE_FIXTURE(Workshop,
                  "extract and render give the same results for standard input as for the file") {
  write("v.nrrd", nrrd_file);
  write("v.raw", u8);
  done("extract v.nrrd --iso 100 -o file.dmc");
  const auto piped = [&](const std::string& source, const std::string& arguments) {
    const Result result = shell(source + " | \"$discmc\" " + arguments);
    INFO(arguments, "\n", result.error);
    CHECK(result.code == 0);
  };
  piped("cat v.nrrd", "extract - --iso 100 -o piped.dmc");
  CHECK(read("piped.dmc") == read("file.dmc"));
  piped("gzip -c v.nrrd", "extract - --iso 100 -o packed.dmc");
  CHECK(read("packed.dmc") == read("file.dmc"));
  piped("cat v.raw", "extract - --dims 5,3,4 --type u8 --iso 100 -o raw.dmc");
  CHECK(read("raw.dmc") == read("file.dmc"));
  done("render v.nrrd --iso 100 --size 32,32 -o file.png");
  piped("cat v.nrrd", "render - --iso 100 --size 32,32 -o piped.png");
  CHECK(read("piped.png") == read("file.png"));
}

TEST_CASE_FIXTURE(
    Workshop, "standard input refuses options that read the volume twice, and surplus samples") {
  write("v.nrrd", nrrd_file);
  write("v.raw", u8 + "x");
  const auto check = [&](const std::string& source, const std::string& arguments,
                         const std::string& part) {
    check_failure(shell(source + " | \"$discmc\" " + arguments), 1, {part});
  };
  const std::string second = "standard input: normals of the gradient read the volume twice";
  check("cat v.nrrd", "extract - --iso 100 --normals gradient -o v.ply", second);
  check("cat v.nrrd", "render - --iso 100 --shade smooth -o v.png", second);
  check("cat v.raw", "extract - --dims 5,3,4 --type u8 --iso 100 -o v.dmc",
        "longer than the 60 bytes of the volume");
  CHECK(file_names() == std::vector<std::string>{"v.nrrd", "v.raw"});
}

// Archives of NumPy: the choice of the array. container_table_test has the sample types.
#include "command.hpp"

namespace {

using namespace volume_files;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";
const std::string several = files / "npz_arrays/several.npz";

TEST_CASE("the only array with three axes in an NPZ file is the volume; several require a name") {
  check_volume(files / "npz/i16-little-deflate.npz", SampleType::i16, "NumPy, npz");
  check_volume((files / "npz/u8-little.npz").string() + ":/volume", "NumPy, npz");
  check_refused(several, "holds 2 arrays: /scan (5 x 3 x 4), /truth (5 x 3 x 4)");
  check_volume(several + ":/scan", "NumPy, npz");
  check_refused(
      several + ":/none",
      "no array '/none' of numbers with two or more dimensions in the file; choose one of /scan");
  check_refused(several + ":/words", "samples of type '<U5' are not supported");
}

TEST_CASE_FIXTURE(Folder,
                  "an NPZ archive that is damaged, truncated, or without an array is refused") {
  const std::string bytes = contents(files / "npz/i16-little-deflate.npz");
  for (std::size_t size = 0; size < bytes.size(); size += 11) {
    INFO("cut at ", size);
    const auto file = write("cut.npz", bytes.substr(0, size));
    const bool is_table_cut_alone = size > bytes.find("PK\1\2");
    if (is_table_cut_alone)
      check_volume(file, SampleType::i16, "NumPy, npz");
    else
      refusal(file);
  }
  std::string changed = bytes;
  changed[100] = static_cast<char>(changed[100] ^ 1);
  refusal(write("changed.npz", changed));
  check_refused(path() / "none.npz", "there is no such file");
}

}  // namespace

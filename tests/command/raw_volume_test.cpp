// Headerless samples: the file must agree with the options.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

VolumeOptions layout_of(SampleType type, std::uint64_t skipped_bytes = 0) {
  return {RawLayout{{5, 3, 4}, type, false, skipped_bytes}};
}

}  // namespace

TEST_CASE_FIXTURE(Folder,
                  "headerless samples longer or shorter than --dims and --type are refused") {
  const std::string i16 = stored(SampleType::i16);
  const auto check = [&](const std::string& bytes, const std::string& part) {
    check_refused(write("v.raw", bytes), layout_of(SampleType::i16), part);
  };
  check(i16 + std::string(12, 'x'),
        "has 132 bytes, but a volume of 5 x 3 x 4 i16 has 120; correct --dims and --type, or skip "
        "a header with --skip-bytes 12");
  check(i16.substr(1), "has 119 bytes, but a volume of 5 x 3 x 4 i16 has 120");
  check("", "has 0 bytes");
  const auto packed = write("v.raw.gz", gzip(i16 + "x"));
  check_refused(packed, layout_of(SampleType::i16), "longer than the 120 bytes");
  check_refused(write("v.raw.gz", gzip(i16.substr(1))), layout_of(SampleType::i16),
                "1 bytes of it are missing");
}

TEST_CASE_FIXTURE(
    Folder, "the refusal of headerless samples proposes a type or number of slices that fits") {
  const auto check = [&](std::size_t bytes, const std::string& part) {
    const auto file = write("v.raw", std::string(bytes, 'x'));
    check_refused(file, layout_of(SampleType::i16), part);
  };
  check(60, "has 120; give --type u8 or i8, which fits the length, or copy the file again");
  check(240,
        "has 120; give --type u32 or i32 or f32, which fits the length, or skip a header with");
  check(90, "has 120; give --dims 5,3,3, which fits the length");
  check(150, "has 120; give --dims 5,3,5, which fits the length");
}

TEST_CASE_FIXTURE(Folder, "--skip-bytes skips bytes before headerless samples") {
  const std::string i16 = stored(SampleType::i16);
  const auto file = write("v.raw", "a header of some program" + i16);
  check_volume(file, SampleType::i16, "raw", layout_of(SampleType::i16, 24));
  check_volume(write("v.raw.gz", gzip("header" + i16)), SampleType::i16, "raw, gzip",
               layout_of(SampleType::i16, 6));
  check_refused(file, layout_of(SampleType::i16, 23), "--skip-bytes 24");
  check_refused(file, layout_of(SampleType::i16, 25), "has 119 bytes after the 25 skipped");
  check_refused(file, layout_of(SampleType::i16, 145), "of 145 bytes to skip 1 are missing");
}

TEST_CASE_FIXTURE(Folder,
                  "a file with a known format's first bytes is refused as headerless samples") {
  const std::vector<std::pair<std::string, std::string>> heads = {
      {"NRRD0004\n", "NRRD"},
      {"ObjectType = Image\n", "MetaImage"},
      {"# vtk DataFile Version 3.0\n", "VTK"},
      {"<?xml version=\"1.0\"?>", "VTK XML"},
      {"\x93NUMPY", "NumPy"},
      {std::string("II*\0", 4), "TIFF"},
      {"\x89PNG\r\n", "PNG"},
      {"\x1f\x8b\x08", "gzip"},
      {"PK\x03\x04", "zip"},
      {std::string(128, '\0') + "DICM", "DICOM"},
      {std::string(344, '\0') + std::string("n+1\0", 4), "NIfTI"},
  };
  for (const auto& [head, format] : heads) {
    const auto file = write("v.raw", head + std::string(400 - head.size(), ' '));
    check_refused(file, {RawLayout{{10, 10, 4}}}, "begins like " + format);
    CHECK_NOTHROW(open_volume(file, {RawLayout{{39, 10, 1}, SampleType::u8, false, 10}}));
  }
}

TEST_CASE_FIXTURE(
    Folder,
    "a file with the extension of a format with a header is refused as headerless samples") {
  for (const std::string name : {"v.nrrd", "v.nii.gz", "v.mhd"})
    check_refused(write(name, u8), layout_of(SampleType::u8),
                  "this name has the extension of a format with a header");
  for (const std::string name : {"v.img", "v.raw", "v", "v.dat"})
    check_volume(write(name, u8), "raw", layout_of(SampleType::u8));
  VolumeOptions options = layout_of(SampleType::u8);
  options.frame = 1;
  check_refused(write("v.raw", u8), options,
                "the input has one volume, and volume 1 was requested");
  options.frame = std::nullopt;
  options.channel = 1;
  check_refused(write("v.raw", u8), options,
                "the input has one channel, and channel 1 was requested; leave out --channel");
}

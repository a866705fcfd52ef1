// Packed files: every filter of libarchive, with every kind of reader.
#include <archive.h>
#include <archive_entry.h>

#include "command.hpp"

namespace {

using namespace volume_files;

std::string packed(const std::string& bytes, int (*add_filter)(archive*)) {
  std::string out(bytes.size() + (1U << 20), '\0');
  std::size_t count = 0;
  archive* writer = archive_write_new();
  REQUIRE(add_filter(writer) == ARCHIVE_OK);
  archive_write_set_format_raw(writer);
  REQUIRE(archive_write_open_memory(writer, out.data(), out.size(), &count) == ARCHIVE_OK);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, "volume");
  archive_entry_set_filetype(entry, AE_IFREG);
  REQUIRE(archive_write_header(writer, entry) == ARCHIVE_OK);
  archive_write_data(writer, bytes.data(), bytes.size());
  archive_entry_free(entry);
  archive_write_close(writer);
  archive_write_free(writer);
  return out.substr(0, count);
}

struct Way {
  const char* name;
  const char* ending;
  int (*add_filter)(archive*);
};
constexpr Way ways[] = {{"gzip", ".gz", archive_write_add_filter_gzip},
                        {"bzip2", ".bz2", archive_write_add_filter_bzip2},
                        {"xz", ".xz", archive_write_add_filter_xz},
                        {"zstd", ".zst", archive_write_add_filter_zstd},
                        {"lz4", ".lz4", archive_write_add_filter_lz4}};

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";

TEST_CASE_FIXTURE(
    Folder, "compressed volumes are recognized by the ending of the name and by the first bytes") {
  const std::string nii = Nifti().file(u8);
  for (const Way& way : ways) {
    INFO(way.name);
    const std::string bytes = packed(nii, way.add_filter);
    const std::string format = std::string("NIfTI-1, ") + way.name;
    check_volume(write(std::string("a.nii") + way.ending, bytes), format);
    check_volume(write("no-ending", bytes), format);
  }
}

TEST_CASE_FIXTURE(
    Folder,
    "a compressed volume is unpacked to a temporary file for libraries that read only files") {
  const std::pair<const char*, const char*> cases[] = {{"hdf5/u8-little.h5", "HDF5, /volume, raw"},
                                                       {"npz/u8-little.npz", "NumPy, npz"}};
  for (const auto& each : cases)
    for (const Way& way : ways) {
      const auto& [name, format] = each;
      INFO(each.first, " ", way.name);
      const std::string bytes = packed(contents(files / name), way.add_filter);
      const std::string called = fs::path(name).filename().string() + way.ending;
      check_volume(write(called, bytes), std::string(format) + ", " + way.name);
    }
  for (const std::string name : {"dicom/u16.dcm", "pictures/u16.tif", "pictures/bits.png"}) {
    INFO(name);
    const std::string bytes = packed(contents(files / name), archive_write_add_filter_zstd);
    const fs::path file = write(fs::path(name).filename().string() + ".zst", bytes);
    CHECK(read_samples(file) == read_samples(files / name));
  }
}

TEST_CASE_FIXTURE(Folder,
                  "compressed headerless samples are recognized only by the ending of the name") {
  const VolumeOptions options = with(&VolumeOptions::layout, RawLayout{{5, 3, 4}, SampleType::i16});
  for (const Way& way : ways) {
    INFO(way.name);
    const std::string bytes = packed(stored(SampleType::i16), way.add_filter);
    check_volume(write(std::string("a.raw") + way.ending, bytes), SampleType::i16,
                 std::string("raw, ") + way.name, options);
  }
  const auto file = write("a.raw", packed(u8, ways[3].add_filter));
  check_refused(file, options, "begins like zstd, not like samples");
}

TEST_CASE_FIXTURE(Folder, "the two files of a NIfTI pair may have different compressions") {
  const std::string whole = Nifti().pair().file(u8);
  write("a.hdr.xz", packed(whole.substr(0, 348), archive_write_add_filter_xz));
  write("a.img.bz2", packed(whole.substr(352), archive_write_add_filter_bzip2));
  check_volume(path() / "a.hdr.xz", "NIfTI-1 pair, bzip2");
  check_volume(path() / "a.img.bz2", "NIfTI-1 pair, bzip2");
}

TEST_CASE_FIXTURE(Folder, "compressed files that are truncated or damaged are refused") {
  const std::string nii = Nifti().file(u8);
  for (const Way& way : ways) {
    const std::string bytes = packed(nii, way.add_filter);
    for (std::size_t size = 0; size + 1 < bytes.size(); size += 7) {
      INFO(way.name, " cut at ", size);
      refusal(write(std::string("cut.nii") + way.ending, bytes.substr(0, size)));
    }
  }
  std::string bytes = packed(nii, archive_write_add_filter_bzip2);
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
  check_refused(write("changed.nii.bz2", bytes), "the compressed data is damaged");
}

TEST_CASE_FIXTURE(Folder, "concatenated compressed streams are read as one file") {
  const std::string nii = Nifti().file(u8);
  for (const Way& way : ways) {
    INFO(way.name);
    const std::string both =
        packed(nii.substr(0, 370), way.add_filter) + packed(nii.substr(370), way.add_filter);
    check_volume(write(std::string("a.nii") + way.ending, both),
                 std::string("NIfTI-1, ") + way.name);
  }
}

}  // namespace

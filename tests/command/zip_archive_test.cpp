// Archives of zip: DICOM and pictures in them, read as from a folder.
#include <archive.h>
#include <archive_entry.h>
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "command.hpp"
#include "volume_files.hpp"

namespace {

using namespace volume_files;
using command::contains;
using command::contents;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";

using Members = std::vector<std::pair<std::string, std::string>>;

std::string zip(const Members& members) {
  std::string bytes(1 << 20, '\0');
  std::size_t used = 0;
  archive* const writer = archive_write_new();
  archive_write_set_format_zip(writer);
  archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
  for (const auto& [name, content] : members) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    REQUIRE(archive_write_header(writer, entry) == ARCHIVE_OK);
    archive_write_data(writer, content.data(), content.size());
    archive_entry_free(entry);
  }
  archive_write_free(writer);
  bytes.resize(used);
  return bytes;
}

Members members_of(const fs::path& folder, const std::string& prefix) {
  Members members;
  for (const auto& entry : fs::directory_iterator(folder))
    members.emplace_back(prefix + entry.path().filename().string(), contents(entry.path()));
  std::sort(members.begin(), members.end());
  return members;
}

std::size_t folders_left() {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path()))
    count += contains(entry.path().filename().string(), "discmc-zip-") ? 1U : 0U;
  return count;
}

std::string refusal_of(const std::string& bytes) {
  const Folder folder;
  try {
    open_volume(folder.write("study.zip", bytes));
  } catch (const VolumeError& error) {
    return error.what();
  }
  FAIL("not refused");
  return {};
}

}  // namespace

TEST_CASE("a zip is read like the folder that was packed, wherever its names lead") {
  const std::size_t before = folders_left();
  for (const fs::path& packed : {files / "dicom/series", files / "pictures/stack"})
    for (const std::string prefix : {"", "study/a/", "/", "../../"}) {
      CAPTURE(packed.string());
      CAPTURE(prefix);
      const Folder folder;
      const auto unpacked = open_volume(packed);
      // By its name, and by what it begins with.
      for (const std::string name : {"study.ZIP", "study"}) {
        const auto reader = open_volume(folder.write(name, zip(members_of(packed, prefix))));
        CHECK(reader->info().format == unpacked->info().format + ", zip");
        CHECK(reader->info().dims == unpacked->info().dims);
        CHECK(reader->info().placement == unpacked->info().placement);
        CHECK(folders_left() == before + 1);
        CHECK(read_all(*reader) == read_all(*open_volume(packed)));
      }
    }
  CHECK(folders_left() == before);
}

TEST_CASE("errors name the archive, and the member where it is one's") {
  Members members = members_of(files / "dicom/series", "series/");
  REQUIRE(members.size() == 5);
  Members fewer = members;
  fewer.erase(fewer.begin() + 1);
  CHECK(contains(refusal_of(zip(fewer)), "study.zip/series: 1 slice is missing"));
  CHECK(
      contains(refusal_of(zip({{"read me", "nothing"}})), "study.zip: the folder holds no DICOM"));
  CHECK(contains(refusal_of("no zip"), "study.zip: the archive is damaged or no zip; copy"));
  const std::string whole = zip(members);
  CHECK(contains(refusal_of(whole.substr(0, whole.size() / 2)), "study.zip: "));
  std::string damaged = whole;
  for (std::size_t i = 200; i < 600; ++i) damaged[i] = '\x55';
  CHECK(contains(refusal_of(damaged), "study.zip"));
  CHECK_FALSE(contains(refusal_of(damaged), "discmc-zip-"));
}

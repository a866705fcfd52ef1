// Archives of zip: their DICOM files and pictures are read as from a folder.
#include "command.hpp"
#include "zip_files.hpp"

namespace {

using namespace volume_files;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes";

// Sets the folder for temporary files during the lifetime of this object; other programs use
// another one.
class TemporaryFiles {
 public:
  TemporaryFiles() { setenv("TMPDIR", folder_.path().c_str(), 1); }
  TemporaryFiles(const TemporaryFiles&) = delete;
  TemporaryFiles& operator=(const TemporaryFiles&) = delete;
  ~TemporaryFiles() { unsetenv("TMPDIR"); }
  std::size_t folders_of_zips() const {
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      count += contains(entry.path().filename().string(), "discmc-unpacked-") ? 1U : 0U;
    return count;
  }

 private:
  Folder folder_;
};

std::string refusal_of(const std::string& bytes) {
  const Folder folder;
  return refusal(folder.write("study.zip", bytes));
}

}  // namespace

TEST_CASE_FIXTURE(Folder, "a zip is read like the packed folder, for any names of members") {
  const TemporaryFiles temporary;
  for (const fs::path& packed : {files / "dicom/series", files / "pictures/stack"})
    for (const std::string prefix : {"", "study/a/", "/", "../../"}) {
      INFO(packed.string(), ", prefix ", prefix);
      const VolumeInfo unpacked = read_info(packed);
      // Recognised by its name, and by its first bytes.
      for (const std::string name : {"study.ZIP", "study"}) {
        const auto reader = open_volume(write(name, zip(members_of(packed, prefix))));
        CHECK(reader->info().format == unpacked.format + ", zip");
        CHECK(reader->info().dims == unpacked.dims);
        CHECK(reader->info().placement == unpacked.placement);
        CHECK(temporary.folders_of_zips() == 1);
        CHECK(read_all(*reader) == read_samples(packed));
      }
    }
  CHECK(temporary.folders_of_zips() == 0);
}

TEST_CASE("other files in a zip are ignored, and member names may have non-ASCII characters") {
  const std::size_t slices = read_info(files / "pictures/stack").dims[2];
  for (const std::string folder : {"Sch\xC3\xA4"
                                   "del/",
                                   "\xE5\xA4\xB4/\xC3\xA9/", "a\x1B[1m/"}) {
    CAPTURE(folder);
    Members members = members_of(files / "pictures/stack", folder);
    members.emplace_back("__MACOSX/" + folder + "._slice0.png", "resources");
    members.emplace_back(folder + "._slice0.png", "resources");
    members.emplace_back(".DS_Store", "layout");
    members.emplace_back("README.txt", "read me");
    const Folder place;
    CHECK(read_info(place.write("study.zip", zip(members))).dims[2] == slices);
  }
  Members series = members_of(files / "dicom/series", "s/");
  series.back().first =
      "Sch\xC3\xA4"
      "del";
  const Folder place;
  CHECK(read_info(place.write("study.zip", zip(series))).dims[2] == series.size());
  series.emplace_back("preview.png", "of the first slice");
  CHECK(noted(read_info(place.write("with-picture.zip", zip(series))),
              "such as 'preview.png'; to read them, give a pattern, such as '"));
}

TEST_CASE_FIXTURE(Folder, "a pattern selects files in a zip, as the refusal advises") {
  const std::string picture = contents(files / "pictures/u8.png");
  Members members;
  for (const std::string name : {"z0_c0.png", "z0_c1.png", "z1_c0.png", "z1_c1.png", "z2_c0.png"})
    members.emplace_back("scan/" + name, picture);
  const std::string packed = write("scan.zip", zip(members)).string();
  check_refused(packed, "such as '" + packed + "/scan/*_c0.png'");
  CHECK(read_info(packed + "/scan/*_c0.png").dims[2] == 3);
  CHECK(read_info(packed + "/scan/z0*.png").format == "PNG, zip");
  CHECK_THROWS_AS(open_volume(packed + "/none/*.png"), VolumeError);
  // So is the note about one slice.
  const auto slice = open_volume(packed + "/scan/z2*.png");
  for (const std::vector<std::string>& notes : {slice->info().notes, slice->notes()}) {
    REQUIRE(!notes.empty());
    CHECK(contains(notes[0], "such as '" + packed + "/scan/*.png'"));
  }
}

TEST_CASE_FIXTURE(
    Folder, "unpacked zip files are removed after a signal, and if two zips were open at once") {
  const TemporaryFiles temporary;
  const std::string packed = zip(members_of(files / "dicom/series", "")),
                    command = std::string("'") + DISCMC_COMMAND + "' ",
                    place = "cd '" + path().string() + "' && ";
  write("study.zip", packed);
  // Stopped while it opens its output, a pipe without a reader, with the archive unpacked.
  const std::string stopped = place + "mkfifo v.stl && { timeout -s KILL 2 " + command +
                              "extract study.zip --iso=-1000 -q -o v.stl; sleep 1; }";
  CHECK(std::system(stopped.c_str()) == 0);
  CHECK(temporary.folders_of_zips() == 0);
  const std::string both =
      place + command + "compare study.zip study.zip --iso=-1000 >messages 2>&1";
  CHECK(std::system(both.c_str()) == 0);
  CHECK(temporary.folders_of_zips() == 0);
}

TEST_CASE("errors in a zip name the archive") {
  Members members = members_of(files / "dicom/series", "series/");
  REQUIRE(members.size() == 5);
  Members fewer = members;
  fewer.erase(fewer.begin() + 1);
  CHECK(contains(refusal_of(zip(fewer)), "study.zip: 1 slice is missing"));
  CHECK(
      contains(refusal_of(zip({{"read me", "nothing"}})), "study.zip: the folder holds no DICOM"));
  CHECK(contains(refusal_of("not a ZIP file"),
                 "study.zip: the archive is damaged, or not a ZIP file; copy"));
  const std::string whole = zip(members);
  CHECK(contains(refusal_of(whole.substr(0, whole.size() / 2)), "study.zip: "));
  std::string damaged = whole;
  for (std::size_t i = 200; i < 600; ++i) damaged[i] = '\x55';
  CHECK(contains(refusal_of(damaged), "study.zip"));
  CHECK_FALSE(contains(refusal_of(damaged), "discmc-unpacked-"));
}

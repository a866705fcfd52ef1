// Volumes with samples in several files.
#include "volume_files.hpp"

namespace {

using namespace volume_files;

const std::string i16 = stored(SampleType::i16);
const std::string nrrd_i16 = "type: short\nendian: little\nencoding: ";
const std::string metaimage_i16 = "ElementType = MET_SHORT\nElementByteOrderMSB = False\n";

std::string slice(int number) {
  return i16.substr(static_cast<std::size_t>(number) * 30, 30);
}

void write_slices(const Folder& folder) {
  for (int i = 0; i < 4; ++i)
    folder.write("a0" + std::to_string(7 - 2 * i) + ".raw", "header" + slice(i) + "behind");
}

}  // namespace

TEST_CASE_FIXTURE(Folder,
                  "NRRD and MetaImage headers name one file per slice by a pattern or a list") {
  write_slices(*this);
  const auto nrrd_of = [&](const std::string& files) {
    return write("v.nhdr", nrrd(nrrd_i16 + "raw\nbyte skip: 6\ndata file: " + files));
  };
  const std::string list = "a07.raw\na05.raw\n\na03.raw\r\na01.raw";
  check_volume(nrrd_of("a%02d.raw 7 1 -2"), SampleType::i16, "NRRD, raw, detached");
  check_volume(nrrd_of("a0%d.raw 7 1 -2 2\n"), SampleType::i16, "NRRD, raw, detached");
  check_volume(nrrd_of("LIST\n" + list), SampleType::i16, "NRRD, raw, detached");
  check_volume(nrrd_of("LIST 2\n" + list + "\n"), SampleType::i16, "NRRD, raw, detached");
  const auto metaimage_of = [&](const std::string& files) {
    return write("v.mhd",
                 metaimage(metaimage_i16 + "HeaderSize = 6\nElementDataFile = " + files + "\n"));
  };
  check_volume(metaimage_of("a%02d.raw 7 1 -2"), SampleType::i16, "MetaImage, raw, detached");
  check_volume(metaimage_of("LIST\n" + list), SampleType::i16, "MetaImage, raw, detached");
}

TEST_CASE_FIXTURE(
    Folder, "several data files of a header hold equal shares of the slices in the same encoding") {
  write("1", gzip(slice(0) + slice(1)));
  write("2", gzip(slice(2) + slice(3)));
  check_volume(write("v.nhdr", nrrd(nrrd_i16 + "gzip\ndata file: %d 1 2 1\n")), SampleType::i16,
               "NRRD, gzip, detached");
  write("3", "behind the text" + slice(0) + slice(1));
  write("4", slice(2) + slice(3));
  check_volume(write("v.nhdr", nrrd(nrrd_i16 + "raw\nbyte skip: -1\ndata file: LIST\n3\n4\n")),
               SampleType::i16, "NRRD, raw, detached");
}

TEST_CASE_FIXTURE(Folder, "names of data files may have blanks, percent signs and backslashes") {
  const auto check = [&](const std::string& written, const std::string& file_list) {
    INFO(file_list);
    write(written, i16);
    check_volume(write("v.mhd", metaimage(metaimage_i16 + "ElementDataFile = " + file_list + "\n")),
                 SampleType::i16, "MetaImage, raw, detached");
    check_volume(write("v.nhdr", nrrd(nrrd_i16 + "raw\ndata file: " + file_list + "\n")),
                 SampleType::i16, "NRRD, raw, detached");
  };
  check("best diastole 77 %.raw", "best diastole 77 %.raw");
  check("sub/a.raw", "sub\\a.raw");
  check("b.raw", ".\\b.raw");
  check("c\\d.raw", "c\\d.raw");
}

TEST_CASE_FIXTURE(
    Folder, "data file names that leave the header's folder are refused, and links are followed") {
  const std::string outside = write("outside1.raw", i16).string();
  for (const std::string& name :
       {outside, std::string("../outside1.raw"), std::string("..\\outside1.raw"),
        std::string("./../sub/../outside1.raw")}) {
    CAPTURE(name);
    const std::string pattern = name.substr(0, name.size() - 5) + "%d.raw 1 1 1";
    for (const std::string& file_list : {name, pattern, "LIST\n" + name}) {
      for (const fs::path& file :
           {write("sub/v.nhdr", nrrd(nrrd_i16 + "raw\ndata file: " + file_list + "\n")),
            write("sub/v.mhd", metaimage(metaimage_i16 + "ElementDataFile = " + file_list + "\n"))})
        check_refused(file, name + "', which lies outside of its folder; put that or a link");
    }
  }
  fs::create_symlink("../outside1.raw", path() / "sub/link.raw");
  write("sub/..b.raw", i16);
  for (const std::string name : {"link.raw", "..b.raw"})
    check_volume(write("sub/v.nhdr", nrrd(nrrd_i16 + "raw\ndata file: " + name + "\n")),
                 SampleType::i16, "NRRD, raw, detached");
}

TEST_CASE_FIXTURE(Folder,
                  "a list or pattern of data files that does not match the volume is refused") {
  write_slices(*this);
  write("short", slice(0).substr(1));
  const auto check = [&](const std::string& files, const std::string& part) {
    const auto file =
        write("v.nhdr", nrrd(nrrd_i16 + "raw\nbyte skip: 6\ndata file: " + files + "\n"));
    check_refusal(error_of(file), part);
  };
  check("a%02d.raw 1 8 1", "a02.raw: there is no such file");
  check("a%02d.raw 1 7 1", "7 data files share 120 bytes");
  check("a%02d.raw 1 4 1", "a02.raw: there is no such file");
  check("a%02d.raw 1 4 0", "whose range is empty");
  check("a%02d.raw 4 1 1", "whose range is empty");
  check("a%02d.raw 1 9223372036854775807 1", "whose range is empty");
  check("a%s.raw 1 4 1", "not a pattern with a range");
  check("a%02d%d.raw 1 4 1", "not a pattern with a range");
  check("LIST\nshort\nshort\nshort\nshort", "7 bytes of 30 are missing");
  check("LIST\na\001.raw", "control characters");
}

TEST_CASE_FIXTURE(Folder, "data files longer than their share are refused without a skip") {
  for (int i = 0; i < 4; ++i) {
    write("a" + std::to_string(i), "header" + slice(i));
    write("b" + std::to_string(i), gzip("header" + slice(i)));
  }
  const auto nrrd_of = [&](const std::string& lines) {
    return write("v.nhdr", nrrd(nrrd_i16 + lines));
  };
  const std::string more = "the data file is longer than its share of 30 bytes";
  CHECK_THROWS_WITH(read_samples(nrrd_of("raw\ndata file: a%d 0 3 1\n")),
                    doctest::Contains(more.c_str()));
  CHECK_THROWS_WITH(read_samples(nrrd_of("gzip\ndata file: b%d 0 3 1\n")),
                    doctest::Contains(more.c_str()));
  check_volume(nrrd_of("raw\nbyte skip: -1\ndata file: a%d 0 3 1\n"), SampleType::i16,
               "NRRD, raw, detached");
  check_volume(nrrd_of("gzip\nbyte skip: 6\ndata file: b%d 0 3 1\n"), SampleType::i16,
               "NRRD, gzip, detached");
  write_slices(*this);
  const auto skipping = nrrd_of("raw\nbyte skip: 6\ndata file: a%02d.raw 7 1 -2\n");
  CHECK(noted(read_info(skipping), "6 bytes after the samples of a data file are left out"));
}

// DICOM files of write_dicom.py, written by other programs. They are ordered by position and
// decoded, or refused if they contain no volume.
#include "command.hpp"

namespace {

using namespace volume_files;
using command_tests::Workshop;

constexpr int width = 8;
constexpr int height = 6;
constexpr int depth = 5;

const fs::path files = fs::path(DISCMC_SOURCE_DIR) / "tests/command/volumes/dicom";

template <class Change>
std::vector<double> changed(std::vector<double> values, Change change) {
  for (double& value : values) value = change(value);
  return values;
}

std::string replaced(std::string bytes, const std::string& old, const std::string& value) {
  REQUIRE(old.size() == value.size());
  REQUIRE(contains(bytes, old));
  return bytes.replace(bytes.find(old), old.size(), value);
}

std::string slice(int z) {
  const char* const names[] = {"IM3", "IM0", "IM4", "IM1", "IM2"};
  return contents(files / "series" / names[z]);
}

class Series : public Folder {
 public:
  Series() {
    for (int z = 0; z < depth; ++z) put(z, slice(z));
  }
  void put(int z, const std::string& bytes) const { write(name(z), bytes); }
  void drop(int z) const { fs::remove(path() / name(z)); }
  /// Replaces a text in every slice.
  void replace(const std::string& old, const std::string& value) const {
    for (int z = 0; z < depth; ++z) put(z, replaced(contents(path() / name(z)), old, value));
  }
  static std::string name(int z) { return "slice" + std::to_string(7 * z % 5); }
};

std::string place(int z) {
  return std::vector<std::string>{"100.000", "102.500", "105.000", "107.500",
                                  "110.000"}[static_cast<std::size_t>(z)];
}

const std::string orientation = "1.000\\0.000\\0.000\\0.000\\1.000\\0.000";

TEST_CASE(
    "DICOM slices of a folder are read in the order of their positions, with spacing and scale") {
  const auto reader = open_volume(files / "series");
  const VolumeInfo& info = reader->info();
  CHECK(info.dims == Dims{width, height, depth});
  CHECK(info.type == SampleType::i16);
  CHECK(info.spacing_mm == Spacing{0.5, 0.75, 2.5});
  CHECK(info.slope == 0.5);
  CHECK(info.intercept == -1024);
  CHECK(info.format == "DICOM");
  const discmc::meshing::VolumePlacement placement = {
      Space::lps, {-10, -20, 100}, {{{0.5, 0, 0}, {0, 0.75, 0}, {0, 0, 2.5}}}};
  CHECK(info.placement == placement);
  CHECK(read_all(*reader) == patterned(0, depth));
}

TEST_CASE(
    "frames of a DICOM file are read in the order of their positions, in every transfer syntax") {
  const auto unsigned_values = changed(patterned(0, depth), [](double v) { return v + 2000; });
  const auto bytes = changed(patterned(0, depth),
                             [](double v) { return std::fmod(std::fmod(v, 251) + 251, 251); });
  struct Case {
    std::string name;
    SampleType type;
    std::vector<double> expected;
    std::string format;
  };
  const std::vector<Case> cases = {
      {"little", SampleType::i16, patterned(0, depth), "DICOM"},
      {"implicit", SampleType::i16, patterned(0, depth), "DICOM"},
      {"big", SampleType::i16, patterned(0, depth), "DICOM"},
      {"u16", SampleType::u16, unsigned_values, "DICOM"},
      {"u16-rle", SampleType::u16, unsigned_values, "DICOM, RLE Lossless"},
      {"u16-jpeg", SampleType::u16, unsigned_values, "DICOM, JPEG Lossless"},
      {"u16-jpegls", SampleType::u16, unsigned_values, "DICOM, JPEG-LS Lossless"},
      {"u16-j2k", SampleType::u16, unsigned_values, "DICOM, JPEG 2000"},
      {"u8", SampleType::u8, bytes, "DICOM"},
      {"u8-rle", SampleType::u8, bytes, "DICOM, RLE Lossless"},
      {"u8-jpeg", SampleType::u8, bytes, "DICOM, JPEG Lossless"},
      {"u8-jpegls", SampleType::u8, bytes, "DICOM, JPEG-LS Lossless"},
      {"i32", SampleType::i32, changed(patterned(0, depth), [](double v) { return v * 70000; }),
       "DICOM"},
      {"f32", SampleType::f32, changed(patterned(0, depth), [](double v) { return v / 4; }),
       "DICOM"},
  };
  for (const Case& one : cases) {
    INFO(one.name);
    const auto reader = open_volume(files / (one.name + ".dcm"));
    const VolumeInfo& info = reader->info();
    CHECK(info.dims == Dims{width, height, depth});
    CHECK(info.type == one.type);
    CHECK(info.spacing_mm == Spacing{0.5, 0.75, 2.5});
    CHECK(info.slope == 0.5);
    CHECK(info.format.rfind(one.format, 0) == 0);
    CHECK(read_all(*reader) == one.expected);
  }
}

TEST_CASE("lossy JPEG of 8 and 12 bits is close to the original") {
  struct Case {
    std::string name;
    double factor;
    std::string format;
  };
  for (const Case& one : {Case{"u8-lossy", 5, "DICOM, JPEG Baseline"},
                          Case{"u12-lossy", 80, "DICOM, JPEG Extended, Process 2+4"}}) {
    INFO(one.name);
    const auto reader = open_volume(files / (one.name + ".dcm"));
    CHECK(reader->info().format == one.format);
    const std::vector<double> all = read_all(*reader);
    REQUIRE(all.size() == patterned(0, depth).size());
    for (int i = 0; i < static_cast<int>(all.size()); ++i) {
      const int x = i % width, y = i / width % height, z = i / width / height;
      CHECK(std::fabs(all[static_cast<std::size_t>(i)] - one.factor * (x + 2 * y + 4 * z)) <=
            0.5 * one.factor);
    }
  }
}

// The bytes of a file whose fragments are in two parts each, without an offset table.
std::string with_split_fragments(const std::string& bytes) {
  const std::string start = std::string("\xe0\x7f\x10\0OB\0\0\xff\xff\xff\xff", 12);
  const std::string item_tag("\xfe\xff\x00\xe0", 4);
  const auto item = [&](const std::string& value) {
    return item_tag + static_cast<char>(value.size() & 0xff) +
           static_cast<char>(value.size() >> 8) + std::string(2, '\0') + value;
  };
  std::size_t at = bytes.find(start) + start.size();
  std::string result = bytes.substr(0, at) + item("");
  for (bool is_table = true; bytes.compare(at, 4, item_tag) == 0; is_table = false) {
    const std::size_t size = static_cast<unsigned char>(bytes[at + 4]) +
                             256U * static_cast<unsigned char>(bytes[at + 5]);
    const std::string value = bytes.substr(at + 8, size);
    const std::size_t half = size / 4 * 2;
    if (!is_table) result += item(value.substr(0, half)) + item(value.substr(half));
    at += 8 + size;
  }
  return result + bytes.substr(at);
}

TEST_CASE_FIXTURE(Folder, "JPEG frames in several fragments each are read without offsets") {
  for (const std::string name : {"u8-jpeg.dcm", "u16-jpeg.dcm", "u8-lossy.dcm", "u16-jpegls.dcm"}) {
    INFO(name);
    const auto split = write("v.dcm", with_split_fragments(contents(files / name)));
    CHECK(read_samples(split) == read_samples(files / name));
  }
  check_refused(write("v.dcm", with_split_fragments(contents(files / "u16-j2k.dcm"))),
                "its part of the compressed pixel data is unknown");
}

TEST_CASE_FIXTURE(Folder, "JPEG frames beyond NumberOfFrames are left out with a note") {
  const std::string count("\x28\0\x08\0IS\2\0", 8);
  const std::string split = with_split_fragments(contents(files / "u8-jpeg.dcm"));
  const auto reader = open_volume(write("v.dcm", replaced(split, count + '5', count + '2')));
  CHECK(read_all(*reader).size() == 2 * width * height);
  CHECK(noted(reader->info(), "left out, as many as those of 3 further frames"));
}

TEST_CASE_FIXTURE(Folder, "JPEG of other size or samples than the file declares is refused") {
  const auto tag = [](char element, char value) {
    return std::string("\x28\0", 2) + element + std::string("\0US\2\0", 5) + value + '\0';
  };
  for (const std::string name : {"u8-lossy.dcm", "u12-lossy.dcm", "u8-jpeg.dcm", "u16-jpeg.dcm"}) {
    const std::string bytes = contents(files / name);
    const auto refused = [&](const std::string& changed) {
      return refusal(write("v.dcm", changed));
    };
    const std::string rows = tag('\x10', height);
    INFO(name);
    check_refusal(refused(replaced(bytes, rows, tag('\x10', 2 * height))),
                  "the JPEG picture has 8 x 6 samples of");
    const std::string columns = tag('\x11', width);
    check_refusal(refused(replaced(bytes, columns, tag('\x11', 2 * width))),
                  "expected 16 x 6 samples of");
  }
  // Samples of 8 bits in JPEG, declared as 16 bits.
  const std::string allocated("\x28\0\0\1US\2\0", 8);
  const std::string wide =
      replaced(contents(files / "u8-jpeg.dcm"), allocated + '\x8', allocated + '\x10');
  check_refused(write("v.dcm", wide), "of 8 bits; expected 8 x 6 samples of 16 bits");
  const std::string colours =
      replaced(contents(files / "u8-jpeg.dcm"), std::string("\0\6\0\x8\1", 5),
               std::string("\0\6\0\x8\3", 5));
  check_refused(write("v.dcm", colours), "has 3 components; expected 1");
}

TEST_CASE("a deflated DICOM file is refused with the remedy") {
  check_refused(files / "deflated.dcm", "deflated as a whole (inflate it with dcmconv +te)");
}

TEST_CASE("bits of DICOM samples above BitsStored are ignored") {
  CHECK(read_samples(files / "packed") == patterned(0, depth));
}

TEST_CASE("DICOM values are scaled correctly if slope and intercept differ between slices") {
  const auto reader = open_volume(files / "scaled");
  CHECK(reader->info().type == SampleType::f32);
  CHECK(reader->info().slope == 1);
  CHECK(reader->info().intercept == 0);
  CHECK(noted(reader->info(), "differ between slices"));
  auto expected = patterned(0, depth);
  const double slopes[] = {1, 0.25, 2, 0.5, 1};
  for (std::size_t i = 0; i < expected.size(); ++i)
    expected[i] = slopes[i / (width * height)] * expected[i] - 1024;
  CHECK(read_all(*reader) == expected);
}

TEST_CASE("a DICOM series with a missing slice is refused with the place of the gap") {
  const Series series;
  series.drop(2);
  check_refused(series.path(),
                "1 slice is missing between 102.5 mm (slice2) and 107.5 mm (slice1)");
  series.drop(1);
  // Two slices are on one side, one on the other.
  check_refused(series.path(),
                "2 slices are missing between 100 mm (slice0) and 107.5 mm (slice1)");
}

TEST_CASE("with gaps allowed, the nearest DICOM slice replaces a missing slice, with a note") {
  const Series series;
  series.drop(2);
  series.drop(3);
  const auto reader = open_volume(series.path(), gaps_allowed);
  CHECK(noted(reader->info(), "2 slices are missing between 102.5 mm (slice2) and 110 mm"));
  CHECK(reader->info().spacing_mm == Spacing{0.5, 0.75, 2.5});
  const std::vector<double> all = patterned(0, depth);
  constexpr std::ptrdiff_t of_slice = width * height;
  std::vector<double> expected(all.begin(), all.begin() + 2 * of_slice);
  for (const std::ptrdiff_t z : {1, 4, 4})
    expected.insert(expected.end(), all.begin() + z * of_slice, all.begin() + (z + 1) * of_slice);
  CHECK(read_all(*reader) == expected);
  // The gap is too large for lost slices, and could not be filled.
  series.put(4, replaced(slice(4), place(4), "1100000"));
  check_refused(series.path(), gaps_allowed, "too many to fill");
}

TEST_CASE_FIXTURE(
    Folder, "with gaps allowed, the nearest frame replaces a missing frame in every compression") {
  std::vector<double> expected = changed(patterned(0, depth), [](double v) { return v + 2000; });
  constexpr std::ptrdiff_t of_slice = width * height;
  const std::vector<double> repeated(expected.end() - 2 * of_slice, expected.end() - of_slice);
  expected.insert(expected.end() - of_slice, repeated.begin(), repeated.end());
  for (const std::string name : {"u16.dcm", "u16-rle.dcm", "u16-jpeg.dcm", "u16-j2k.dcm"}) {
    INFO(name);
    const auto file = write(name, replaced(contents(files / name), place(4), "112.500"));
    CHECK(read_samples(file, gaps_allowed) == expected);
  }
}

TEST_CASE("a gap is a whole number of slices, however many are missing") {
  const Series series;
  series.put(4, replaced(slice(4), place(4), "120.000"));
  CHECK(read_info(series.path(), gaps_allowed).dims[2] == 9);
  // At 4.92 and 5.04 slices.
  for (const std::string along : {"119.800", "120.100"}) {
    series.put(4, replaced(slice(4), place(4), along));
    check_refused(series.path(), gaps_allowed, "2.5 mm apart, but 12.", " mm between 107.5 mm (");
  }
}

TEST_CASE(
    "identical DICOM slices count once, and different slices at the same position are refused") {
  const Series series;
  series.write("copy", slice(1));
  const std::string uid = "1.2.826.0.1.3680043.10.1.1.2";
  series.write("sent-again", replaced(replaced(slice(1), uid, "1.2.826.0.1.3680043.10.1.1.8"), uid,
                                      "1.2.826.0.1.3680043.10.1.1.8"));
  const auto reader = open_volume(series.path());
  CHECK(noted(reader->info(), "2 slices that occur twice are dropped"));
  CHECK(read_all(*reader) == patterned(0, depth));
  series.write("echo", replaced(replaced(slice(2), place(2), place(1)), "Head 2.5", "Echo two"));
  check_refused(series.path(), "two slices at 102.5 mm differ: ");
}

TEST_CASE("--series chooses one of several series by number or UID") {
  const Series series;
  const std::string uid = "1.2.826.0.1.3680043.10.1.1";
  const std::string other = "1.2.826.0.1.3680043.10.1.2";
  for (int z = 0; z < depth; ++z) {
    std::string bytes = replaced(replaced_all(slice(z), uid, other), "Head 2.5", "Thin 1.5");
    for (std::size_t i = bytes.size() - 2 * width * height; i < bytes.size(); ++i) bytes[i] = 1;
    series.write("other" + std::to_string(z), bytes);
  }
  check_refusal(refusal(series.path()) + "\n",
                "\n  1: 5 slices of 8 x 6, 'CT', 'Head 2.5', UID " + uid + "\n",
                "\n  2: 5 slices of 8 x 6, 'CT', 'Thin 1.5', UID " + other + "\n", "--series N");
  const auto ones = std::vector<double>(patterned(0, depth).size(), 257);
  const auto chosen = [&](const std::string& name) {
    return read_samples(series.path(), {{}, {}, name});
  };
  CHECK(chosen("1") == patterned(0, depth));
  CHECK(chosen(uid) == patterned(0, depth));
  CHECK(chosen("2") == ones);
  CHECK(chosen(other) == ones);
  check_refused(series.path(), {{}, {}, "3"}, "no series '3'; give one of these with --series:\n");
  const auto nrrd_file = series.write("v.nrrd", nrrd(nrrd_u8) + "\n" + u8);
  check_refused(nrrd_file, {{}, {}, "1"}, "leave out --series");
}

TEST_CASE("--series chooses one of several volumes in a series by number, not by UID") {
  const Series series;
  series.put(0, replaced(slice(0), orientation, "-1.00\\0.000\\0.000\\0.000\\1.000\\0.000"));
  const std::string uid = "1.2.826.0.1.3680043.10.1.1";
  VolumeOptions by_uid = with(&VolumeOptions::series, uid);
  for (const VolumeOptions& options : {VolumeOptions{}, by_uid}) {
    const std::string text = refusal(series.path(), options);
    check_refusal(text, "several volumes in one series, of different directions; choose ");
    check_refusal(text, "--series N");
    CHECK(!contains(text, "--series UID"));
  }
  CHECK(read_info(series.path(), {{}, {}, "2"}).dims[2] +
            read_info(series.path(), {{}, {}, "1"}).dims[2] ==
        depth);
}

TEST_CASE("DICOM slices with and without position are refused as several volumes") {
  const Series series;
  series.put(2, replaced(slice(2), "-10.000\\-20.000\\" + place(2), "                       "));
  check_refused(series.path(), "several volumes in one series, with and without position (",
                "1 slice of 8 x 6 without position, 'CT'", "4 slices of 8 x 6, 'CT'");
}

TEST_CASE("pictures beside DICOM are left out, with a note") {
  const Series series;
  series.write("preview.png", "of the first slice");
  const auto reader = open_volume(series.path());
  CHECK(noted(reader->info(), "left out: 1, such as 'preview.png'; to read them, give a pattern"));
  CHECK(read_all(*reader) == patterned(0, depth));
}

TEST_CASE("a series UID of the maximum length is listed whole") {
  const Series series;
  const std::string uid = "2.25." + std::string(59, '7');
  std::string bytes = slice(0);
  const std::size_t at = bytes.find(std::string("\x20\x00\x0e\x00UI", 6));
  REQUIRE(at != std::string::npos);
  constexpr std::size_t header = 8;
  const auto old_length = static_cast<unsigned char>(bytes[at + header - 2]);
  bytes.replace(at + header, old_length, uid);
  bytes[at + header - 2] = static_cast<char>(uid.size());
  series.write("other", bytes);
  check_refusal(refusal(series.path()) + "\n", "UID " + uid + "\n");
  CHECK(read_info(series.path(), {{}, {}, uid}).dims[2] == 1);
}

TEST_CASE("files that hold no image are skipped and counted") {
  const Series series;
  series.write("reports/a", contents(files / "report.dcm"));
  series.write("reports/b.dcm", "not DICOM at all");
  series.write("notes.txt", "of a colleague");
  series.write("capture", contents(files / "colour.dcm"));
  series.write("capture2", contents(files / "colour.dcm"));
  const auto reader = open_volume(series.path());
  CHECK(noted(reader->info(),
              "4 files without a volume's image are skipped: a DICOM file without an image ('SR'); "
              "a colour image (2); not a DICOM file"));
  CHECK(read_all(*reader) == patterned(0, depth));
  check_refused(files / "report.dcm", "this is a DICOM file without an image");
  check_refused(files / "colour.dcm", "the file holds 3 channels");
  check_refused(series.path() / "reports", "none of 2 DICOM files holds an image to read: ");
  const Folder empty;
  check_refused(empty.path(), "holds no DICOM files and no pictures");
}

TEST_CASE("one slice of a series is a volume, with a hint to its folder") {
  const VolumeInfo info = read_info(files / "series" / "IM3");
  CHECK(info.dims == Dims{width, height, 1});
  CHECK(noted(info, "give its folder"));
}

TEST_CASE("DICOM slices seen from the other side are read in reverse, without mirroring") {
  const Series series;
  series.replace(orientation, "-1.00\\0.000\\0.000\\0.000\\1.000\\0.000");
  // Seen from the other side, the order is that of decreasing z.
  const auto reader = open_volume(series.path());
  CHECK(reader->info().spacing_mm == Spacing{-0.5, 0.75, -2.5});
  check_axes(reader->info(), {{{-0.5, 0, 0}, {0, 0.75, 0}, {0, 0, -2.5}}}, {-10, -20, 110});
  const auto all = patterned(0, depth);
  std::vector<double> expected;
  constexpr int of_slice = width * height;
  for (auto end = all.end(); end != all.begin(); end -= of_slice)
    expected.insert(expected.end(), end - of_slice, end);
  CHECK(read_all(*reader) == expected);
}

TEST_CASE_FIXTURE(Folder, "DICOM truncated at any byte is refused") {
  for (const std::string name : {"little.dcm", "u16-rle.dcm", "u16-jpeg.dcm", "u16-jpegls.dcm",
                                 "u16-j2k.dcm", "series/IM3"}) {
    const std::string bytes = contents(files / name);
    for (std::size_t size = 0; size + 1 < bytes.size(); size += 41) {
      INFO(name, " cut at ", size);
      refusal(write("cut.dcm", bytes.substr(0, size)));
    }
  }
}

// The bytes of a slice with sequences in sequences.
std::string nested(int levels, bool has_lengths) {
  const std::string start = has_lengths ? "" : std::string("\xff\xff\xff\xff");
  const auto length = [&](std::size_t bytes) {
    std::string text = start;
    for (unsigned shift = 0; has_lengths && shift < 32; shift += 8)
      text += static_cast<char>(bytes >> shift & 0xff);
    return text;
  };
  std::string inner;
  for (int i = 0; i < levels; ++i) {
    // With explicit lengths, the outermost one is written last.
    const std::string item = std::string("\xfe\xff\x00\xe0", 4) + length(inner.size());
    const std::string sequence =
        std::string("\x40\x00\x75\x02SQ\0\0", 8) + length(item.size() + inner.size());
    const std::string ends =
        has_lengths ? "" : std::string("\xfe\xff\x0d\xe0\0\0\0\0\xfe\xff\xdd\xe0\0\0\0\0", 16);
    inner.insert(0, sequence + item);
    inner += ends;
  }
  const std::string before = std::string("\x20\x00\x32\x00", 4);
  std::string bytes = slice(0);
  REQUIRE(contains(bytes, before));
  return bytes.insert(bytes.find(before), inner);
}

TEST_CASE_FIXTURE(Folder, "DICOM sequences that are nested too deeply are refused") {
  for (const bool has_lengths : {false, true}) {
    CHECK(read_info(write("v.dcm", nested(30, has_lengths))).dims[0] == width);
    check_refused(write("v.dcm", nested(20000, has_lengths)), "damaged, or deflated");
  }
}

TEST_CASE_FIXTURE(Workshop, "one command converts a folder of DICOM to a mesh") {
  const std::string folder = "'" + (files / "series").string() + "'";
  done("extract " + folder + " --iso -1000 -o v.stl");
  CHECK(!mesh_in("v.stl").vertices_mm.empty());
  done("extract '" + (files / "u16-j2k.dcm").string() + "' --iso -24 -o j.stl");
  CHECK(run("extract " + folder + " --series 2 --iso 0 -o v.stl").code == 1);
}

}  // namespace

// The order of DICOM slices: rounded positions, tilted gantries, missing positions, and orders that
// the user gives.
#include "command.hpp"
#include "dicom_files.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;
using command_tests::Workshop;
using discmc::command::SliceOrder;

// A folder of slices. change: sets the differences of each slice.
class Slices : public Folder {
 public:
  template <class Change>
  explicit Slices(Change change) {
    for (int z = 0; z < depth; ++z) {
      Dataset data = slice(z);
      change(data, z);
      write("IM" + std::to_string(7 * z % 5), data.file());
    }
  }
};

// Slices at even distances, with positions that are rounded to tenths of a millimetre.
template <class Change>
void write_rounded(const Folder& folder, int count, double first, double step, Change change,
                   int missing = -1) {
  for (int z = 0; z < count; ++z) {
    if (z == missing) continue;
    Dataset data = slice(z % depth, std::to_string(z));
    put_at(data, {-10.123456, -20, std::round(10 * (first + step * z)) / 10});
    change(data);
    folder.write("IM" + std::to_string(z), data.file());
  }
}

const double tilt = 15 * std::acos(-1.0) / 180;
const std::vector<double> tilted = {1, 0, 0, 0, std::cos(tilt), -std::sin(tilt)};
const Axes sheared = {
    {{0.5, 0, 0}, {0, 0.75 * std::cos(tilt), -0.75 * std::sin(tilt)}, {0, 0, 2.5}}};

Slices along_z(const std::vector<double>& places) {
  return Slices([&](Dataset& data, int z) {
    put_at(data, {-10, -20, places[static_cast<std::size_t>(z)]});
  });
}

TEST_CASE_FIXTURE(Folder, "files without a preamble are found among others by their contents") {
  for (int z = 0; z < depth; ++z) write("IM" + std::to_string(z), slice(z).encoded());
  write("notes", "not of the series, but in its folder");
  CHECK(read_samples(path()) == as_read(volume_values()));
  CHECK(read_info(path() / "IM3").dims[2] == 1);
}

TEST_CASE_FIXTURE(
    Folder, "DICOM positions rounded to tenths of a millimetre are read with one constant step") {
  const double step = 0.625;
  for (const bool has_spacing : {true, false})
    for (const double begin : {40.0, 40.04}) {
      INFO(has_spacing, " from ", begin);
      const auto rounded = [&](int z) { return std::round(10 * (begin + step * z)) / 10; };
      write_rounded(*this, 16, begin, step, [&](Dataset& data) {
        if (has_spacing) data.text(0x00180050, "DS", "0.625");
      });
      const VolumeInfo info = read_info(path());
      CHECK(noted(info, "the positions are rounded, slices assumed to be 0.62"));
      const double found = std::fabs(info.spacing_mm[2]);
      CHECK(found == doctest::Approx(step).epsilon(has_spacing ? 1e-12 : 0.01));
      for (int z = 0; z < 16; ++z)
        CHECK(std::fabs(info.placement->origin_mm[2] + z * found - rounded(z)) <= 0.05 + 1e-6);
    }
}

TEST_CASE("DICOM slices with rounded positions are read as one straight line in any direction") {
  const std::vector<double> orientation = {0.36, 0.48, -0.8, -0.8, 0.6, 0};
  const Slices slices([&](Dataset& data, int z) {
    std::vector<double> place = {-10 + 0.48 * 2.5 * z, -20 + 0.64 * 2.5 * z, 0.6 * 2.5 * z};
    for (double& coordinate : place) coordinate = std::round(10 * coordinate) / 10;
    put_at(data, place, orientation).text(0x00280030, "DS", "0.3\\0.3");
  });
  const VolumeInfo info = read_info(slices.path());
  CHECK(std::fabs(info.spacing_mm[2]) == doctest::Approx(2.5).epsilon(0.02));
}

TEST_CASE_FIXTURE(Folder,
                  "a slice distance in the file that does not fit the positions is ignored") {
  write_rounded(*this, 16, 40, 0.33, [](Dataset& data) { data.text(0x00180050, "DS", "0.5"); });
  CHECK(std::fabs(read_info(path()).spacing_mm[2]) == doctest::Approx(0.33).epsilon(0.02));
}

TEST_CASE_FIXTURE(Folder, "a missing slice is found among rounded positions") {
  write_rounded(
      *this, 10, 40, 0.625, [](Dataset& data) { data.text(0x00180050, "DS", "0.625"); }, 4);
  check_refused(path(), "1 slice is missing between 41.9 mm (IM3) and 43.1 mm");
  CHECK(read_info(path(), gaps_allowed).dims[2] == 10);
}

TEST_CASE("uneven positions with more decimals are refused, not treated as rounded") {
  check_refused(along_z({100, 100.6251, 101.2, 101.9, 102.5}).path(), "mm apart, but");
  check_refused(along_z({100, 101, 102.2, 103, 104}).path(), "1 mm apart, but 1.2 mm");
}

// `count` slices: 2.476 mm apart in the first half, 2.524 mm in the second.
std::string folder_of_growing(const Folder& folder, int count) {
  double place = 100;
  for (int z = 0; z < count; ++z) {
    Dataset data = slice(z % depth, std::to_string(z));
    put_at(data, {-10, -20, place});
    folder.write("IM" + std::to_string(z), data.file());
    place += 2 * z < count ? 2.47612 : 2.52387;
  }
  return folder.path();
}

TEST_CASE(
    "uneven distances of slices are noted, and refused if off by a quarter of a step or more") {
  const Folder few, some, many;
  CHECK(!noted(read_info(folder_of_growing(few, 4)), "from their place at even distances"));
  CHECK(noted(read_info(folder_of_growing(some, 40)), "slices lie up to 0.4"));
  check_refused(folder_of_growing(many, 60), "mm everywhere, slices would be 0.7");
}

TEST_CASE("a tilted gantry shears the volume by the positions of its slices, with a note") {
  const Slices slices([&](Dataset& data, int z) { put_at(data, position(z), tilted); });
  const auto reader = open_volume(slices.path());
  const VolumeInfo& info = reader->info();
  check_places(info, {-10, -20, 100}, sheared);
  CHECK(noted(info, "as by a gantry tilted by 15 degrees; the volume is sheared accordingly"));
  CHECK(std::fabs(info.spacing_mm[2]) == 2.5);
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Folder,
                  "for a tilted gantry with rounded positions, the volume is sheared by the step "
                  "fitted to the positions") {
  write_rounded(*this, 16, 40, 0.33,
                [](Dataset& data) { data.text(0x00200037, "DS", decimals(tilted)); });
  const VolumeInfo info = read_info(path());
  CHECK(noted(info, "the positions are rounded"));
  const auto& step = info.placement->axes_mm[2];
  CHECK(std::fabs(step[1]) < 0.005);
  CHECK(step[2] == doctest::Approx(0.33).epsilon(0.02));
}

TEST_CASE_FIXTURE(Workshop, "a tilted gantry shears the vertices like the voxels") {
  // One on voxel, (3, 2, 1).
  const Slices slices([&](Dataset& data, int z) {
    put_at(data, position(z), tilted);
    std::vector<std::int64_t> values(width * height, 0);
    if (z == 1) values[2 * width + 3] = 100;
    data.samples(values, 16, true);
  });
  done("extract '" + slices.path().string() + "' --iso 50 -o v.obj");
  const auto mesh = mesh_in("v.obj");
  CHECK(mesh.vertices_mm.size() == 6);
  // An octahedron of half a voxel, with a sixth of the cell's volume.
  const double cell = 0.5 * 0.75 * std::cos(tilt) * 2.5;
  CHECK(command_tests::volume_of(mesh) == doctest::Approx(cell / 6).epsilon(1e-6));
  discmc::meshing::Point middle{};
  for (const auto& vertex : mesh.vertices_mm)
    for (std::size_t i = 0; i < 3; ++i) middle[i] += vertex[i] / 6;
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = position(0)[i] + 3 * sheared[0][i] + 2 * sheared[1][i] + sheared[2][i];
    CHECK(middle[i] == doctest::Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("a slice that is shifted sideways against the others is refused") {
  const Slices slices([](Dataset& data, int z) {
    std::vector<double> place = position(z);
    if (z == 2) place[0] += 0.4;
    put_at(data, place);
  });
  check_refused(slices.path(), "is shifted sideways by 0.4 mm against IM");
}

TEST_CASE("slices shifted by a few micrometres are read as straight") {
  const Slices slices([](Dataset& data, int z) {
    std::vector<double> place = position(z);
    place[0] += 0.002 * z;
    put_at(data, place);
  });
  check_places(read_info(slices.path()), {-10, -20, 100}, along_axes);
}

// ---- decimals ----

TEST_CASE("a decimal comma in DICOM numbers is read as a point, with a note") {
  const Slices slices([](Dataset& data, int z) {
    data.text(0x00280030, "DS", "0,75\\0,5");
    data.text(0x00200032, "DS", "-10,0\\-20,0\\" + std::to_string(1000 + 25 * z).insert(3, ","));
  });
  const auto reader = open_volume(slices.path());
  check_places(reader->info(), {-10, -20, 100}, along_axes);
  CHECK(noted(reader->info(), "decimal commas are read as points"));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Dicom,
                  "a DICOM number that is not numeric is refused with the name of its element") {
  Dataset data = slice(0);
  const auto file = put(data.text(0x00280030, "DS", "0.75;0.5"));
  check_refused(file, "an image whose PixelSpacing is '0.75;0.5', which is not a number",
                "dcmodify -m PixelSpacing=VALUE FILE");
}

TEST_CASE(
    "a missing PixelSpacing is replaced by another element's spacing or by 1 mm, with a note") {
  struct Case {
    std::function<void(Dataset&)> change;
    Spacing spacing;
    std::string note;
  };
  const Case cases[] = {
      {[](Dataset&) {}, {1, 1, 2.5}, "no PixelSpacing"},
      {[](Dataset& data) { data.text(0x00181164, "DS", "0.75\\0.5"); },
       {0.5, 0.75, 2.5},
       "no PixelSpacing, ImagerPixelSpacing is used"},
      {[](Dataset& data) { data.text(0x00182010, "DS", "0.75\\0.5"); },
       {0.5, 0.75, 2.5},
       "no PixelSpacing, NominalScannedPixelSpacing is used"},
      {[](Dataset& data) {
         Dataset region;
         region.whole(0x00186024, {3}).whole(0x00186026, {3}).real(0x0018602c, {0.05});
         data.sequence(0x00186011, {region.real(0x0018602e, {0.075})});
       },
       {0.5, 0.75, 2.5},
       "no PixelSpacing, SequenceOfUltrasoundRegions is used"},
      {[](Dataset& data) { data.text(0x00280034, "IS", "3\\2"); },
       {1, 1.5, 2.5},
       "PixelAspectRatio is used, and 1 mm assumed along a row"}};
  for (const Case& one : cases) {
    INFO(one.note);
    const Slices slices([&](Dataset& data, int) { one.change(data.drop(0x00280030)); });
    const VolumeInfo info = read_info(slices.path());
    CHECK(info.spacing_mm == one.spacing);
    CHECK(noted(info, one.note));
  }
}

// ---- the order given by the user ----

VolumeOptions ordered(SliceOrder order) {
  return with(&VolumeOptions::order, order);
}

TEST_CASE("--order instance sorts slices without positions by InstanceNumber") {
  const Slices slices([](Dataset& data, int) {
    data.drop(0x00200032).drop(0x00200037).text(0x00180050, "DS", "2.5");
  });
  check_refused(slices.path(), "the 5 slices have no place (ImagePositionPatient and",
                "--order instance");
  const auto reader = open_volume(slices.path(), ordered(SliceOrder::instance));
  CHECK(reader->info().spacing_mm == Spacing{0.5, 0.75, 2.5});
  CHECK(!reader->info().placement);
  CHECK(noted(reader->info(), "in the order of their InstanceNumber; "));
  CHECK(noted(reader->info(), "which side is left, is unknown"));
  CHECK(noted(reader->info(), "the slices are assumed to be 2.5 mm apart, by SliceThickness"));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE("--order sorts slices that all have the same position") {
  const Slices slices([](Dataset& data, int) { put_at(data, {0, 0, 0}); });
  check_refused(slices.path(), "or read them as slices with --order instance");
  const auto reader = open_volume(slices.path(), ordered(SliceOrder::instance));
  CHECK(read_all(*reader) == as_read(volume_values()));
  CHECK(noted(reader->info(), "several slices have one position"));
  CHECK(!reader->info().placement);
}

TEST_CASE_FIXTURE(Dicom,
                  "a DICOM palette of greys is applied, and a palette of colours is refused") {
  std::vector<std::int64_t> samples;
  std::vector<double> expected;
  std::vector<std::uint64_t> words, low, pairs;
  for (int i = 0; i < width * height; ++i) {
    samples.push_back(5 * i);
    expected.push_back(255 - 5 * i);
  }
  for (std::uint64_t i = 0; i < 256; ++i) words.push_back(257 * (255 - i));
  for (std::uint64_t i = 0; i < 256; ++i) low.push_back(255 - i);
  for (std::uint64_t i = 0; i < 256; i += 2) pairs.push_back(255 - i + ((254 - i) << 8));
  Dataset data = image("1");
  put_at(data, position(0)).samples(samples, 8, false).text(0x00280004, "CS", "PALETTE COLOR");
  const std::pair<std::vector<std::uint64_t>, std::uint64_t> tables[] = {
      {words, 16}, {low, 16}, {pairs, 8}};
  for (const auto& [table, bits] : tables) {
    for (std::uint32_t colour = 0; colour < 3; ++colour)
      data.whole(0x00281101 + colour, {256, 0, bits}).whole(0x00281201 + colour, table);
    CHECK(read_samples(put(data)) == expected);
  }
  data.whole(0x00281203, std::vector<std::uint64_t>(128, 0));
  check_refused(put(data), "a colour image, by its palette");
}

TEST_CASE("a volume that mixes slices of MONOCHROME1 and MONOCHROME2 is refused") {
  const Slices slices([](Dataset& data, int z) {
    data.text(0x00280004, "CS", z == 3 ? "MONOCHROME1" : "MONOCHROME2");
  });
  check_refused(slices.path(), "some slices are MONOCHROME1 and others MONOCHROME2");
}

TEST_CASE("with --order instance, a gap in the instance numbers is a missing slice") {
  const Slices slices([](Dataset& data, int z) {
    data.drop(0x00200032).text(0x00200013, "IS", std::to_string(z < 3 ? z + 8 : z + 10));
  });
  check_refused(slices.path(), ordered(SliceOrder::instance),
                "2 slices are missing between instance 10 (IM4) and instance 13 (IM1)");
  VolumeOptions options = ordered(SliceOrder::instance);
  options.allow_gaps = true;
  CHECK(read_info(slices.path(), options).dims[2] == depth + 2);
}

TEST_CASE_FIXTURE(Folder, "--order instance sorts files of several slices without positions") {
  for (const int part : {1, 0}) {
    Dataset data = image("9." + std::to_string(part));
    std::vector<std::int64_t> values = slice_values(2 * part);
    for (const std::int64_t value : slice_values(2 * part + 1)) values.push_back(value);
    data.text(0x00280008, "IS", "2").text(0x00200013, "IS", std::to_string(part + 1));
    write("IM" + std::to_string(part), data.samples(values, 16, true).file());
  }
  std::vector<std::int64_t> expected;
  for (int z = 0; z < 4; ++z)
    for (const std::int64_t value : slice_values(z)) expected.push_back(value);
  CHECK(read_samples(path(), ordered(SliceOrder::instance)) == as_read(expected));
}

TEST_CASE(
    "--order instance refuses missing or equal instance numbers, and --order name reads slices "
    "without numbers") {
  Slices slices([](Dataset& data, int) { data.drop(0x00200032).drop(0x00200013); });
  check_refused(slices.path(), ordered(SliceOrder::instance), "has no InstanceNumber",
                "--order name");
  const Slices equal([](Dataset& data, int) { data.drop(0x00200032).text(0x00200013, "IS", "1"); });
  check_refused(equal.path(), ordered(SliceOrder::instance),
                "two slices have the same InstanceNumber: instance 1 (");
  const Folder named;
  for (int z = 0; z < depth; ++z)
    named.write("IM" + std::to_string(9 + z), slice(z).drop(0x00200032).drop(0x00200013).file());
  const auto reader = open_volume(named.path(), ordered(SliceOrder::name));
  CHECK(noted(reader->info(), "in the order of their names; "));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE("--merge-series reads slices with a series UID each as one volume") {
  const Slices slices(
      [](Dataset& data, int z) { data.text(0x0020000e, "UI", "1.2.3.77." + std::to_string(z)); });
  check_refused(slices.path(), "several volumes; choose ",
                "or read them as slices of one volume with --merge-series:");
  CHECK(read_samples(slices.path(), with(&VolumeOptions::merges_series, true)) ==
        as_read(volume_values()));
}

TEST_CASE_FIXTURE(Folder, "options for DICOM are refused for volumes of other formats") {
  const auto file = write("v.nrrd", nrrd(nrrd_u8) + "\n" + u8);
  check_refused(file, ordered(SliceOrder::name), "leave out --order");
  check_refused(file, with(&VolumeOptions::merges_series, true), "leave out --merge-series");
}

TEST_CASE_FIXTURE(
    Workshop,
    "the command advised for slices without positions, each with its own UID, writes a mesh") {
  const Slices unplaced([](Dataset& data, int z) {
    data.drop(0x00200032).text(0x0020000e, "UI", "1.2.3.77." + std::to_string(z));
  });
  const std::string folder = "'" + unplaced.path().string() + "'";
  CHECK(contains(run("extract " + folder + " --iso 0 -o v.stl").error, "--merge-series"));
  CHECK(contains(run("extract " + folder + " --iso 0 --merge-series -o v.stl").error,
                 "--order instance"));
  done("extract " + folder + " --iso 0 --merge-series --order instance -o v.stl");
  done("extract " + folder + " --iso 0 --merge-series --order name -o v.stl");
}

// ---- the location of the files ----

TEST_CASE("opening a DICOMDIR file reads the DICOM files of its folder") {
  const Slices slices([](Dataset&, int) {});
  Dataset directory;
  directory.text(0x00080016, "UI", "1.2.840.10008.1.3.10").text(0x00041130, "CS", "DISC");
  fs::create_directory(slices.path() / "IMAGES");
  for (int z = 0; z < depth; ++z) {
    const std::string name = "IM" + std::to_string(7 * z % 5);
    fs::rename(slices.path() / name, slices.path() / "IMAGES" / name);
  }
  // The data of a real file does not contain the class of the file.
  const std::string bytes = directory.file();
  for (const std::string name : {"DICOMDIR", "dicomdir.dcm"}) {
    const auto file = slices.write(name, bytes);
    CHECK(read_samples(file) == as_read(volume_values()));
  }
  const VolumeInfo info = read_info(slices.path());
  CHECK(info.notes.empty());
  const Folder alone;
  check_refused(alone.write("DICOMDIR", bytes), "there is no image beside the DICOMDIR");
}

TEST_CASE_FIXTURE(Folder, "DICOM slices that are compressed with gzip one by one are read") {
  for (int z = 0; z < depth; ++z) {
    const std::string bytes = slice(z).file();
    if (z == 0) write("IM0", bytes);
    if (z == 1) write("deeper/IM1.gz", gzip(bytes));
    if (z > 1) write("IM" + std::to_string(z) + ".dcm.gz", gzip(bytes));
  }
  const auto reader = open_volume(path());
  CHECK(reader->info().format == "DICOM, gzip");
  CHECK(read_all(*reader) == as_read(volume_values()));
  const auto one = open_volume(path() / "IM3.dcm.gz");
  CHECK(read_all(*one) == as_read(slice_values(3)));
  write("IM2.dcm.gz", gzip(slice(2).file()).substr(0, 300));
  CHECK(contains(refusal(path()), "IM2.dcm"));
}

TEST_CASE("dangling symbolic links are reported by name") {
  const Slices slices([](Dataset&, int) {});
  fs::create_symlink("/nowhere/IM9", slices.path() / "IM9");
  const VolumeInfo info = read_info(slices.path());
  CHECK(noted(info, "links that lead nowhere: 1, such as 'IM9'"));
  fs::remove(slices.path() / "IM2");
  check_refused(slices.path(), "1 slice is missing between",
                "(links that lead nowhere: 1, such as 'IM9'); ");
  const Folder dead;
  fs::create_symlink("/nowhere/IM9", dead.path() / "IM9.dcm");
  check_refused(dead.path(), "links that lead nowhere: 1, such as 'IM9.dcm'");
  check_refused(dead.path() / "IM9.dcm", "the link leads nowhere, to '/nowhere/IM9'");
  check_refused(dead.path() / "none.dcm", "there is no such file");
}

TEST_CASE("files in a DICOM folder whose names begin with a dot are ignored") {
  const Slices slices([](Dataset&, int) {});
  slices.write("._IM0", "\0\5\26\7");
  slices.write("._IM0.dcm", "\0\5\26\7");
  slices.write(".git/IM0", slice(0, "8").samples(slice_values(1), 16, true).file());
  const auto reader = open_volume(slices.path());
  CHECK(reader->info().notes.empty());
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Dicom, "PixelPaddingValue is scaled like the samples, with or without sign") {
  const auto padding_of = [&](Dataset data) {
    data.text(0x00281052, "DS", "-1024").text(0x00281053, "DS", "2");
    return read_info(put(data)).padding;
  };
  CHECK(!padding_of(frames()));
  Dataset data = frames();
  CHECK(padding_of(data.bytes(0x00280120, "SS", number_bytes(63536, 2, Order::little_endian))) ==
        -5024);
  CHECK(padding_of(data.whole(0x00280120, {63536})) == -5024);
  CHECK(padding_of(data.samples(volume_values(), 16, false).whole(0x00280120, {63536})) == 126048);
}

}  // namespace

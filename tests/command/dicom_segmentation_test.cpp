// DICOM segmentations: bits, fractions and numbers as labels, with the names and colours of their
// segments.
#include "command.hpp"
#include "dicom_files.hpp"
#include "volumes/formats/dicom/segmentation.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;
using discmc::command::Srgb;

using Voxels = std::vector<std::uint8_t>;
constexpr std::size_t voxels_of_slice = width * height;

// A box of voxels in a slice, from the first to the last along x and y.
Voxels box(int x0, int x1, int y0, int y1, std::uint8_t value = 1) {
  Voxels voxels(voxels_of_slice, 0);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) voxels[static_cast<std::size_t>(y * width + x)] = value;
  return voxels;
}

struct SegmentFrame {
  std::uint64_t segment;
  int z;
  Voxels voxels;
};

Dataset segment(std::uint64_t number, const std::string& name,
                const std::vector<std::uint64_t>& colour = {}) {
  Dataset data;
  data.whole(0x00620004, {number}).text(0x00620005, "LO", name);
  if (!colour.empty()) data.whole(0x0062000d, colour);
  return data;
}

struct SegmentSlices {
  std::uint32_t distance = 0x00180088;  // with SpacingBetweenSlices
  double aside_mm = 0;                  // along x, from slice to slice
};

// A segmentation whose frames have only a position and a segment.
Dataset segmentation(const std::string& type, const std::vector<Dataset>& segments,
                     const std::vector<SegmentFrame>& frames, const SegmentSlices& slices = {}) {
  Dataset measures, orientation, shared;
  measures.text(0x00280030, "DS", "0.75\\0.5").text(slices.distance, "DS", "2.5");
  orientation.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  shared.sequence(0x00289110, {measures}).sequence(0x00209116, {orientation});
  std::vector<Dataset> groups;
  Voxels all;
  for (const SegmentFrame& frame : frames) {
    Dataset place, identity, group;
    std::vector<double> at = position(frame.z);
    at[0] += slices.aside_mm * frame.z;
    place.text(0x00200032, "DS", decimals(at));
    identity.whole(0x0062000b, {frame.segment});
    group.sequence(0x00209113, {place}).sequence(0x0062000a, {identity});
    groups.push_back(group);
    all.insert(all.end(), frame.voxels.begin(), frame.voxels.end());
  }
  Dataset data = image("9", "SEG");
  data.drop(0x00280030).text(0x00620001, "CS", type).sequence(0x00620002, segments);
  data.sequence(0x52009229, {shared}).sequence(0x52009230, groups);
  data.text(0x00280008, "IS", std::to_string(frames.size()));
  if (type == "BINARY") return data.bits(all);
  return data.samples(std::vector<std::int64_t>(all.begin(), all.end()), 8, false);
}

std::vector<double> slices_of(const std::vector<Voxels>& slices) {
  std::vector<double> values;
  for (const Voxels& slice : slices) values.insert(values.end(), slice.begin(), slice.end());
  return values;
}

std::string name_of(const VolumeInfo& info, int value, std::uint32_t layer = 0) {
  for (const auto& label : info.labels)
    if (label.layer == layer && label.values == std::vector<discmc::meshing::LabelValue>{value})
      return label.name;
  return "";
}

struct Segments : Dicom {
  // All frames are those of segment 3.
  fs::path write_rib(const std::vector<SegmentFrame>& frames,
                     const SegmentSlices& slices = {}) const {
    return put(segmentation("BINARY", {segment(3, "Rib")}, frames, slices));
  }
};

const std::vector<Dataset> liver_and_spleen = {segment(1, "Liver"), segment(2, "Spleen")};

TEST_CASE_FIXTURE(
    Dicom,
    "a binary DICOM segmentation is one volume of segment numbers with the segments' names") {
  const auto file = put(
      segmentation("BINARY", liver_and_spleen,
                   {{2, 1, box(5, 6, 0, 5)}, {1, 0, box(0, 2, 1, 2)}, {1, 1, box(0, 3, 1, 4)}}));
  const auto reader = open_volume(file);
  const VolumeInfo& info = reader->info();
  CHECK(info.dims == Dims{width, height, 2});
  CHECK(info.type == SampleType::u8);
  CHECK(info.format == "DICOM segmentation");
  check_places(info, {-10, -20, 100}, along_axes);
  CHECK(name_of(info, 1) == "Liver");
  CHECK(name_of(info, 2) == "Spleen");
  Voxels second = box(0, 3, 1, 4);
  const Voxels spleen = box(5, 6, 0, 5, 2);
  for (std::size_t i = 0; i < second.size(); ++i) second[i] |= spleen[i];
  CHECK(read_all(*reader) == slices_of({box(0, 2, 1, 2), second}));
}

TEST_CASE_FIXTURE(Segments, "slices of a DICOM segmentation without any segment are empty") {
  const auto reader = open_volume(write_rib({{3, 4, box(0, 1, 0, 1)}, {3, 1, box(2, 3, 2, 3)}}));
  check_places(reader->info(), {-10, -20, 102.5}, along_axes);
  const Voxels none(voxels_of_slice, 0);
  CHECK(read_all(*reader) == slices_of({box(2, 3, 2, 3, 3), none, none, box(0, 1, 0, 1, 3)}));
  CHECK(noted(reader->info(), "no two slices are the 2.5 mm of SpacingBetweenSlices apart"));
}

TEST_CASE_FIXTURE(Segments, "a SliceThickness that matches no distance between slices is ignored") {
  constexpr std::uint32_t thickness = 0x00180050;
  const VolumeInfo info = read_info(write_rib(
      {{3, 0, box(0, 1, 0, 1)}, {3, 2, box(0, 1, 0, 1)}, {3, 4, box(2, 3, 2, 3)}}, {thickness}));
  CHECK(info.dims[2] == 3);
  check_places(info, {-10, -20, 100}, {{{0.5, 0, 0}, {0, 0.75, 0}, {0, 0, 5}}});
  CHECK(noted(info, "the slices are 5 mm apart, not the 2.5 mm of SliceThickness"));
}

TEST_CASE_FIXTURE(Segments, "evenly shifted slices of a DICOM segmentation shear the volume") {
  const VolumeInfo info = read_info(
      write_rib({{3, 0, box(0, 1, 0, 1)}, {3, 1, box(0, 1, 0, 1)}, {3, 3, box(2, 3, 2, 3)}},
                {0x00180088, 0.5}));
  check_places(info, {-10, -20, 100}, {{{0.5, 0, 0}, {0, 0.75, 0}, {0.5, 0, 2.5}}});
  CHECK(noted(info, "each slice is shifted by 0.5 mm"));
}

TEST_CASE_FIXTURE(Folder, "frames of a binary segmentation may begin in the middle of a byte") {
  Dataset data = segmentation("BINARY", {segment(1, "Odd")}, {});
  std::vector<std::uint8_t> bits;
  std::vector<double> expected;
  constexpr int odd = 7, high = 3;
  std::vector<Dataset> groups;
  for (int z = 0; z < depth; ++z) {
    Dataset place, identity, group;
    place.text(0x00200032, "DS", decimals(position(z)));
    identity.whole(0x0062000b, {1});
    groups.push_back(group.sequence(0x00209113, {place}).sequence(0x0062000a, {identity}));
    for (int i = 0; i < odd * high; ++i) {
      bits.push_back(static_cast<std::uint8_t>((i * 5 + z * 3) % 4 == 0));
      expected.push_back(bits.back());
    }
  }
  data.whole(0x00280010, {high}).whole(0x00280011, {odd}).sequence(0x52009230, groups);
  data.text(0x00280008, "IS", std::to_string(depth)).bits(bits);
  for (const Order order : {Order::little_endian, Order::big_endian})
    CHECK(read_samples(write("v.dcm", data.file(order))) == expected);
}

TEST_CASE_FIXTURE(
    Dicom,
    "overlapping segments are distributed over several volumes, each with its segments' names") {
  const auto file = put(
      segmentation("BINARY", {segment(1, "Liver"), segment(2, "Tumour"), segment(5, "Rib")},
                   {{1, 0, box(0, 3, 0, 3)}, {2, 0, box(2, 5, 2, 5)}, {5, 0, box(7, 7, 0, 0)}}));
  check_refused(file, "2 volumes");
  VolumeOptions options = of_frame(0);
  auto reader = open_volume(file, options);
  CHECK(reader->info().frames == 2);
  Voxels first = box(0, 3, 0, 3);
  first[7] = 5;
  CHECK(read_all(*reader) == slices_of({first}));
  CHECK(name_of(reader->info(), 1) == "Liver");
  CHECK(name_of(reader->info(), 5) == "Rib");
  CHECK(name_of(reader->info(), 2, 1) == "Tumour");
  options.frame = 1;
  reader = open_volume(file, options);
  CHECK(read_all(*reader) == slices_of({box(2, 5, 2, 5, 2)}));
}

TEST_CASE_FIXTURE(Dicom,
                  "overlapping segments are detected even if the file states that none overlaps") {
  const auto volumes = [this](const Voxels& second) {
    Dataset data =
        segmentation("BINARY", liver_and_spleen, {{1, 0, box(0, 3, 0, 3)}, {2, 0, second}});
    const auto file = put(data.text(0x00620013, "CS", "NO"));
    return read_info(file, of_frame(0)).frames;
  };
  CHECK(volumes(box(4, 5, 2, 5)) == 1);
  CHECK(volumes(box(2, 5, 2, 5)) == 2);
}

TEST_CASE("segments without a common voxel share a layer") {
  using discmc::command::Overlaps;
  Overlaps overlaps;
  const Voxels all(voxels_of_slice, 1);
  overlaps.start_slice(voxels_of_slice);
  overlaps.add(1, all.data());
  overlaps.add(2, all.data());
  overlaps.add(3, box(0, 0, 0, 0).data());
  overlaps.start_slice(voxels_of_slice);
  overlaps.add(4, all.data());
  const auto layers = overlaps.layers({1, 2, 3, 4});
  CHECK(layers.at(1) == 0);
  CHECK(layers.at(2) == 1);
  CHECK(layers.at(3) == 2);
  CHECK(layers.at(4) == 0);
}

TEST_CASE_FIXTURE(
    Dicom,
    "a voxel of a fractional segmentation belongs to a segment from a fraction of a half on") {
  Voxels fractions(voxels_of_slice, 0);
  fractions[3] = 99;
  fractions[4] = 100;
  fractions[5] = 200;
  Dataset data = segmentation("FRACTIONAL", {segment(1, "Liver")}, {{1, 0, fractions}});
  const auto reader = open_volume(put(data.whole(0x0062000e, {200})));
  CHECK(noted(reader->info(), "a voxel belongs to a segment from a half on"));
  CHECK(name_of(reader->info(), 1) == "Liver");
  Voxels expected(voxels_of_slice, 0);
  expected[4] = expected[5] = 1;
  CHECK(read_all(*reader) == slices_of({expected}));
}

TEST_CASE_FIXTURE(Dicom, "a DICOM label map with a palette is read unchanged") {
  Voxels labels = box(0, 3, 0, 3, 1);
  labels[20] = 2;
  Dataset data =
      segmentation("LABELMAP", liver_and_spleen, {{0, 0, labels}, {0, 2, box(1, 1, 1, 1, 2)}});
  data.text(0x00280004, "CS", "PALETTE COLOR");
  const auto reader = open_volume(put(data));
  CHECK(name_of(reader->info(), 2) == "Spleen");
  CHECK(read_all(*reader) == slices_of({labels, Voxels(voxels_of_slice, 0), box(1, 1, 1, 1, 2)}));
}

TEST_CASE("colours of DICOM segments are converted from CIELab to sRGB") {
  using discmc::command::srgb_of_cielab;
  // The colours that DCMTK, and therefore 3D Slicer, computes from these.
  CHECK(srgb_of_cielab({34889, 53479, 50166}) == Srgb{255, 0, 0});
  CHECK(srgb_of_cielab({57497, 10747, 54273}) == Srgb{0, 255, 0});
  CHECK(srgb_of_cielab({21168, 53249, 5173}) == Srgb{0, 0, 255});
  CHECK(srgb_of_cielab({65535, 32896, 32891}) == Srgb{255, 255, 255});
  CHECK(srgb_of_cielab({0, 32896, 32896}) == Srgb{0, 0, 0});
  CHECK(srgb_of_cielab({43803, 26565, 37721}) == Srgb{128, 174, 128});
  CHECK(srgb_of_cielab({56638, 32897, 42532}) == Srgb{241, 214, 145});
}

TEST_CASE_FIXTURE(Dicom, "a DICOM segmentation with missing or uneven positions is refused") {
  Dataset unplaced = segmentation("BINARY", {segment(1, "Liver")}, {{1, 0, box(0, 1, 0, 1)}});
  check_refused(put(unplaced.drop(0x52009229)), "a segmentation whose frames have no position");
  Dataset twice = segmentation("BINARY", {segment(1, "Liver")},
                               {{1, 0, box(0, 1, 0, 1)}, {1, 0, box(2, 3, 0, 1)}});
  check_refused(put(twice), "two frames have the same place and segment");
}

TEST_CASE_FIXTURE(Folder, "segmentations in the folder of an image are separate volumes") {
  for (int z = 0; z < depth; ++z) write("IM" + std::to_string(z), slice(z).file());
  Dataset data = segmentation("BINARY", liver_and_spleen, {{1, 0, box(0, 1, 0, 1)}});
  write("seg.dcm", data.text(0x0020000e, "UI", "1.2.9").file());
  check_refused(path(), "1 frame of 8 x 6, 'SEG', 2 segments, UID 1.2.9");
  CHECK(read_info(path(), with(&VolumeOptions::series, "1.2.9")).format == "DICOM segmentation");
}

TEST_CASE_FIXTURE(Dicom, "names of segments are converted to UTF-8 from any character set") {
  const struct {
    const char *set, *name, *utf8;
  } cases[] = {{"\\ISO 2022 IR 87", "\x1b$B4NB!\x1b(B", "\xe8\x82\x9d\xe8\x87\x93"},
               {"ISO 2022 IR 13\\ISO 2022 IR 87", "\xd4\x1b$B4N\x1b(J", "\xef\xbe\x94\xe8\x82\x9d"},
               {"", "\xc6rea", "\xc3\x86rea"},
               {"ISO_IR 100", "\xc4\xe4", "\xc3\x84\xc3\xa4"},
               {"\\ISO 2022 IR 149", "\x1b$)C\xb0\xa3", "\xea\xb0\x84"},
               {"\\ISO 2022 IR 58", "\x1b$)A\xb8\xce", "\xe8\x82\x9d"}};
  for (const auto& each : cases) {
    INFO(each.set);
    Dataset data = segmentation("BINARY", {segment(1, each.name)}, {{1, 0, box(1, 3, 1, 3)}});
    const VolumeInfo info = read_info(put(data.text(0x00080005, "CS", each.set)));
    REQUIRE(info.labels.size() == 1);
    CHECK(info.labels[0].name == each.utf8);
  }
}

}  // namespace

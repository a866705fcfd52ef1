// DICOM files with a common placement of all frames: cone beams, doses, nuclear medicine, mosaics.
#include "command.hpp"
#include "dicom_files.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;

Dataset cone_beam() {
  Dataset data = frames();
  return put_at(data, position(0)).text(0x00180050, "DS", "2.5");
}

TEST_CASE_FIXTURE(Dicom,
                  "DICOM frames with a common position are consecutive slices, with a note") {
  const auto reader = open_volume(put(cone_beam()));
  check_places(reader->info(), {-10, -20, 100}, along_axes);
  CHECK(noted(reader->info(), "one position for all frames, read as slices 2.5 mm apart"));
  CHECK(noted(reader->info(), "by SliceThickness"));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(
    Dicom, "the distance of DICOM frames is their spacing, else their thickness, else 1 mm") {
  const VolumeInfo info = read_info(put(cone_beam().text(0x00180088, "DS", "2")));
  CHECK(info.spacing_mm == Spacing{0.5, 0.75, 2});
  CHECK(noted(info, "2 mm apart, by SpacingBetweenSlices"));
  const auto file = put(cone_beam().drop(0x00180050));
  CHECK(read_info(file).spacing_mm == Spacing{0.5, 0.75, 1});
  CHECK(noted(read_info(file), "SpacingBetweenSlices and SliceThickness are missing"));
  CHECK(read_info(file, {{}, Spacing{1, 1, 3}}).spacing_mm == Spacing{1, 1, 3});
}

TEST_CASE_FIXTURE(Dicom, "DICOM frames with times are read as slices, with a note") {
  Dataset data = cone_beam();
  data.tags(0x00280009, 0x00181063).text(0x00181063, "DS", "33");
  CHECK(noted(read_info(put(data)), "the frames have times (FrameTime), and are read as slices"));
}

TEST_CASE_FIXTURE(Dicom,
                  "frames beyond NumberOfFrames are left out with a note; without NumberOfFrames "
                  "one frame is read") {
  Dataset data = slice(0);
  data.samples(volume_values(), 16, true);
  for (const std::string count : {"0", "1"}) {
    const auto reader = open_volume(put(data.text(0x00280008, "IS", count)));
    CHECK(read_all(*reader) == as_read(slice_values(0)));
    CHECK(noted(reader->info(), "left out, as many as those of 4 further frames"));
  }
  const auto whole = open_volume(put(slice(0)));
  read_all(*whole);
  CHECK_FALSE(noted(whole->info(), "left out"));
}

TEST_CASE_FIXTURE(Dicom, "a DICOM rescale slope of 0 is ignored with a note") {
  const Dataset data = slice(0).text(0x00281053, "DS", "0").text(0x00281052, "DS", "7");
  const VolumeInfo info = read_info(put(data));
  CHECK(info.slope == 1);
  CHECK(info.intercept == 0);
  CHECK(noted(info, "RescaleSlope is 0 and is ignored"));
}

TEST_CASE_FIXTURE(Folder, "pixels without a decoder are refused by the name of their packing") {
  const std::string standard = "1.2.840.10008.1.2.4.";
  const std::pair<std::string, std::string> cases[] = {
      {"201", "an image packed as HTJ2K"},
      {"201", standard + "201"},
      {"110", "an image packed as JPEG XL"},
      {"110", standard + "110"},
      {"102", "this is a video ('" + standard + "102'); it is not a volume"},
      {"107", "this is a video"},
      {"94", "this is an image whose pixels are on a server, by JPIP"},
      {"204", "an image whose pixels are on a server, by JPIP"}};
  for (const auto& [number, part] : cases)
    check_refused(write("v.dcm", slice(0).file(Order::little_endian, standard + number)), part);
}

TEST_CASE_FIXTURE(Folder, "DICOM samples of every integer type are read in either byte order") {
  struct Case {
    SampleType type;
    std::size_t bits;
    bool is_signed;
    std::int64_t factor;
  };
  for (const Order order : {Order::little_endian, Order::big_endian})
    for (const Case& one :
         {Case{SampleType::u8, 8, false, 1}, Case{SampleType::i8, 8, true, 1},
          Case{SampleType::u16, 16, false, 300}, Case{SampleType::i16, 16, true, 300},
          Case{SampleType::u32, 32, false, 20000001}, Case{SampleType::i32, 32, true, 20000001}}) {
      INFO(name(one.type));
      const auto values = changed(volume_values(), [&](std::int64_t value) {
        return one.factor * (value % 100 + (one.is_signed ? 0 : 100));
      });
      Dataset data = cone_beam();
      const auto reader =
          open_volume(write("v.dcm", data.samples(values, one.bits, one.is_signed).file(order)));
      CHECK(reader->info().type == one.type);
      CHECK(read_all(*reader) == as_read(values));
    }
}

TEST_CASE_FIXTURE(Folder, "DICOM samples of floating point are read in either byte order") {
  const auto values = changed(as_read(volume_values()), [](double value) { return value / 64; });
  for (const Order order : {Order::little_endian, Order::big_endian})
    for (const std::size_t bits : {32U, 64U}) {
      INFO(bits);
      Dataset data = cone_beam();
      const auto reader = open_volume(write("v.dcm", data.floats(values, bits).file(order)));
      CHECK(reader->info().type == (bits == 32 ? SampleType::f32 : SampleType::f64));
      CHECK(read_all(*reader) == values);
    }
}

TEST_CASE_FIXTURE(Folder,
                  "32-bit samples in bytes (OB) of big-endian files are read as big-endian") {
  Dataset data = cone_beam();
  const auto values = changed(volume_values(), [](std::int64_t value) { return value * 70001; });
  const auto file = write("v.dcm", data.samples(values, 32, true, "OB").file(Order::big_endian));
  CHECK(read_samples(file) == as_read(values));
}

TEST_CASE_FIXTURE(Folder, "8-bit samples in words (OW) of big-endian files are read in order") {
  Dataset data = cone_beam();
  const auto values =
      changed(volume_values(), [](std::int64_t value) { return 100 + value % 100; });
  std::vector<std::int64_t> stored = values;
  REQUIRE(stored.size() % 2 == 0);
  for (std::size_t i = 0; i < stored.size(); i += 2) std::swap(stored[i], stored[i + 1]);
  const auto file = write("v.dcm", data.samples(stored, 8, false, "OW").file(Order::big_endian));
  CHECK(read_samples(file) == as_read(values));
}

TEST_CASE_FIXTURE(Dicom, "the values of a parametric map are real-world values") {
  Dataset mapping;
  mapping.real(0x00409225, {0.25}).real(0x00409224, {-3});
  Dataset data = cone_beam();
  data.sequence(0x00409096, {mapping});
  CHECK(read_info(write("ct.dcm", data.file())).slope == 1);
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.30");
  Dataset shared;
  const VolumeInfo info =
      read_info(put(data.sequence(0x52009229, {shared.sequence(0x00409096, {mapping})})));
  CHECK(info.slope == 0.25);
  CHECK(info.intercept == -3);
}

// ---- doses ----

std::vector<std::int64_t> raised(const std::vector<std::int64_t>& values) {
  return changed(values, [](std::int64_t value) { return value + 2000; });
}

Dataset dose(const std::string& offsets) {
  Dataset data = frames("RTDOSE");
  put_at(data, position(0)).text(0x3004000c, "DS", offsets).text(0x3004000e, "DS", "0.02");
  return data.text(0x30040002, "CS", "GY").samples(raised(volume_values()), 32, false);
}

TEST_CASE_FIXTURE(Dicom,
                  "RT Dose values are in Gy, for relative and absolute GridFrameOffsetVector") {
  for (const std::string offsets :
       {"0\\2.5\\5\\7.5\\10", "100\\102.5\\105\\107.5\\110", "0.0\\2.5\\5.0\\7.5\\10.0"}) {
    INFO(offsets);
    const auto reader = open_volume(put(dose(offsets)));
    check_places(reader->info(), {-10, -20, 100}, along_axes);
    CHECK(reader->info().slope == 0.02);
    CHECK(reader->info().intercept == 0);
    CHECK(noted(reader->info(), "values are doses in Gy"));
    CHECK(read_all(*reader) == as_read(raised(volume_values())));
  }
}

TEST_CASE_FIXTURE(Dicom, "an RT Dose whose frame offsets decrease is read from its last frame") {
  for (const std::string offsets : {"0\\-2.5\\-5\\-7.5\\-10", "100\\97.5\\95\\92.5\\90"}) {
    INFO(offsets);
    const auto reader = open_volume(put(dose(offsets)));
    check_places(reader->info(), {-10, -20, 90}, along_axes);
    CHECK(read_all(*reader) == as_read(raised(reversed_values())));
  }
}

TEST_CASE_FIXTURE(
    Dicom, "frame offsets that are positions follow z even if the slice normal points down") {
  Dataset data = dose("100\\102.5\\105\\107.5\\110");
  put_at(data, position(0), {1, 0, 0, 0, -1, 0});
  const VolumeInfo info = read_info(put(data));
  check_places(info, {-10, -20, 110}, {{{0.5, 0, 0}, {0, -0.75, 0}, {0, 0, -2.5}}});
}

TEST_CASE_FIXTURE(
    Dicom, "RT Dose frame offsets that are uneven, or begin at neither 0 nor z, are refused") {
  const auto refused = [&](const std::string& offsets) { return refusal(put(dose(offsets))); };
  check_refusal(refused("40\\42.5\\45\\47.5\\50"),
                "GridFrameOffsetVector begins with 40, which is neither 0 nor the z");
  check_refusal(refused("0\\2.5\\5\\8.5\\11"), "2.5 mm apart, but 3.5 mm between");
  check_refusal(refused("0\\2.5\\5"), "more frames than offsets (GridFrameOffsetVector)");
}

TEST_CASE_FIXTURE(Folder,
                  "an RT Dose that is relative or has no DoseGridScaling is read with a note") {
  Dataset data = dose("0\\2.5\\5\\7.5\\10");
  const auto relative = write("r.dcm", data.text(0x30040002, "CS", "RELATIVE").file());
  CHECK(noted(read_info(relative), "values are relative doses"));
  const auto unscaled = write("u.dcm", data.drop(0x3004000e).file());
  CHECK(read_info(unscaled).slope == 1);
  CHECK(noted(read_info(unscaled), "a dose without DoseGridScaling"));
}

TEST_CASE_FIXTURE(Dicom, "an RT Dose without frame offsets is scaled by DoseGridScaling") {
  Dataset data = dose("0");
  const VolumeInfo info = read_info(put(data.drop(0x3004000c).text(0x00180050, "DS", "2.5")));
  CHECK(info.slope == 0.02);
  check_places(info, {-10, -20, 100}, along_axes);
}

// ---- nuclear medicine ----

Dataset nuclear(const std::string& type = "RECON TOMO") {
  Dataset data = frames("NM");
  Dataset detector;
  put_at(detector, position(0));
  return data.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\" + type + "\\EMISSION")
      .text(0x00180088, "DS", "2.5")
      .sequence(0x00540022, {detector});
}

TEST_CASE_FIXTURE(Dicom, "the detector and signed distance place slices of nuclear medicine") {
  Dataset data = nuclear();
  const auto reader = open_volume(put(data));
  check_places(reader->info(), {-10, -20, 100}, along_axes);
  CHECK(read_all(*reader) == as_read(volume_values()));
  const VolumeInfo down = read_info(write("down.dcm", data.text(0x00180088, "DS", "-2.5").file()));
  check_places(down, {-10, -20, 90}, along_axes);
}

TEST_CASE_FIXTURE(Dicom, "slices of nuclear medicine are in the order of their numbers") {
  Dataset data = nuclear();
  CHECK(read_samples(put(data.whole(0x00540080, {5, 4, 3, 2, 1}))) == as_read(reversed_values()));
}

TEST_CASE_FIXTURE(Dicom, "pictures of a gamma camera are refused with their kind") {
  for (const std::string type : {"STATIC", "TOMO", "WHOLE BODY"})
    check_refused(put(nuclear(type)),
                  "pictures of a gamma camera, not slices (image type " + type + ")", "RECON TOMO");
}

// ---- mosaics ----

std::string padded(const std::string& text, std::size_t size) {
  return text + std::string(size - text.size(), '\0');
}

std::string word(std::size_t value) {
  return number_bytes(value, 4, Order::little_endian);
}

using CsaElements = std::vector<std::pair<std::string, std::vector<std::string>>>;

// The header of Siemens scanners: every element has six items or none. The older kind adds the
// items of the first element to the lengths, and has no name.
std::string csa_header(const CsaElements& elements, bool is_newer) {
  std::string bytes = (is_newer ? "SV10\4\3\2\1" : "") + word(elements.size()) + word(77);
  const std::size_t of_first = elements[0].second.empty() ? 0 : 6;
  for (const auto& [name, values] : elements) {
    const std::size_t items = values.empty() ? 0 : 6;
    bytes +=
        padded(name, 64) + word(values.size()) + padded("IS", 4) + word(6) + word(items) + word(77);
    for (std::size_t i = 0; i < items; ++i) {
      const std::string value = i < values.size() ? values[i] + '\0' : "";
      const std::size_t length = is_newer ? value.size() : value.size() + of_first;
      bytes += word(is_newer ? value.size() : length) + word(value.size()) + word(77) +
               word(value.size()) + padded(value, (value.size() + 3) / 4 * 4);
    }
  }
  return bytes;
}

CsaElements csa_elements(const std::string& along_z) {
  return {{"EchoLinePosition", {"24"}},
          {"NumberOfImagesInMosaic", {"5"}},
          {"Empty", {}},
          {"SliceNormalVector", {"0.00000000", "0.00000000", along_z}}};
}

// Five slices in three rows of three.
constexpr int across = 3;

Dataset mosaic(const std::string& header) {
  std::vector<std::int64_t> picture(across * width * across * height, -7);
  for (int z = 0; z < depth; ++z)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const int row = z / across * height + y, column = z % across * width + x;
        picture[static_cast<std::size_t>(row * across * width + column)] = value_at(x, y, z);
      }
  Dataset data = image("7", "MR");
  // The position is that of a picture of the whole size, centred on the first slice.
  put_at(data, {-10 - 0.5 * width, -20 - 0.75 * height, 100});
  data.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC").text(0x00180088, "DS", "2.5");
  data.whole(0x00280010, {across * height}).whole(0x00280011, {across * width});
  if (!header.empty())
    data.text(0x00290010, "LO", "SIEMENS CSA HEADER").bytes(0x00291010, "OB", header);
  return data.samples(picture, 16, true);
}

TEST_CASE_FIXTURE(Dicom, "a mosaic of Siemens is unfolded, and placed by its first slice") {
  for (const bool is_newer : {true, false}) {
    INFO(is_newer);
    const std::string header = csa_header(csa_elements("1.00000000"), is_newer);
    const auto reader = open_volume(put(mosaic(header)));
    CHECK(reader->info().dims == Dims{width, height, depth});
    check_places(reader->info(), {-10, -20, 100}, along_axes);
    CHECK(read_all(*reader) == as_read(volume_values()));
  }
}

TEST_CASE_FIXTURE(Dicom, "slices of a mosaic follow the slice normal of its header") {
  const std::string header = csa_header(csa_elements("-1.00000000"), true);
  const auto reader = open_volume(put(mosaic(header)));
  check_places(reader->info(), {-10, -20, 90}, along_axes);
  CHECK(read_all(*reader) == as_read(reversed_values()));
}

TEST_CASE_FIXTURE(Dicom, "the header of a mosaic is found in any block") {
  Dataset data = mosaic("");
  data.text(0x00290010, "LO", "SIEMENS MEDCOM HEADER");
  data.text(0x00290011, "LO", "SIEMENS CSA HEADER");
  data.bytes(0x00291110, "OB", csa_header(csa_elements("1.0"), true));
  CHECK(read_samples(put(data)) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Dicom, "a mosaic without a usable header is refused by name") {
  const std::string whole = csa_header(csa_elements("1.0"), true);
  check_refused(put(mosaic("")),
                "a Siemens mosaic of an unknown number of slices without the CSA header");
  Dataset counted = mosaic("");
  counted.text(0x00190010, "LO", "SIEMENS MR HEADER").whole(0x0019100a, {5});
  check_refused(put(counted), "a Siemens mosaic of 5 slices");
  CsaElements many = csa_elements("1.0");
  many[1].second = {"50"};
  check_refused(put(mosaic(csa_header(many, true))),
                "mosaic of 50 slices that do not fit in 24 x 18 voxels");
  CsaElements aside = csa_elements("0.0");
  check_refused(put(mosaic(csa_header(aside, true))), "whose SliceNormalVector is not a normal");
  for (std::size_t size = 0; size <= whole.rfind("1.0"); size += 7) {
    INFO("cut at ", size);
    check_refused(put(mosaic(whole.substr(0, size))), "a Siemens mosaic of ");
  }
}

}  // namespace

// DICOM files that users reported to other programs: several patients with one UID, alternating
// stacks, coordinates of ultrasound, contradicting headers.
#include "command.hpp"
#include "dicom_files.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;

constexpr std::uint32_t patient_id = 0x00100020, study = 0x0020000d,
                        frame_of_reference = 0x00200052, pixel_spacing = 0x00280030;

template <class Change>
void write_slices(const Folder& folder, const std::string& prefix, Change change) {
  for (int z = 0; z < depth; ++z) {
    Dataset data = slice(z, prefix + "." + std::to_string(z));
    change(data, z);
    folder.write(prefix + std::to_string(z), data.file());
  }
}

TEST_CASE_FIXTURE(
    Folder,
    "each patient, study and frame of reference under one series UID is a separate volume") {
  for (const std::uint32_t tag : {patient_id, study, frame_of_reference}) {
    INFO(tag);
    for (const std::string of : {"1.1", "1.2"})
      write_slices(*this, of, [&](Dataset& data, int z) {
        put_at(data, {-10, -20, 100 + 2.5 * z + (of == "1.1" ? 0 : 1.25)});
        data.text(tag, tag == patient_id ? "LO" : "UI", of);
      });
    check_refused(path(), "several volumes in one series");
    check_refused(path(), "5 slices of 8 x 6");
    VolumeOptions options = with(&VolumeOptions::merges_series, true);
    check_refused(path(), options, "several volumes");
    options.merges_series = false;
    options.series = "2";
    CHECK(read_samples(path(), options) == as_read(volume_values()));
  }
}

TEST_CASE_FIXTURE(Folder, "a frame of reference per slice does not separate volumes") {
  write_slices(*this, "a", [](Dataset& data, int z) {
    data.text(frame_of_reference, "UI", "1.9." + std::to_string(z));
  });
  CHECK(read_samples(path()) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(
    Folder,
    "DICOM stacks acquired in turn are one volume, and stacks side by side are several volumes") {
  const auto stacks = [&](bool are_in_turn) {
    return enhanced(depth,
                    [are_in_turn](Dataset& group, int z) {
                      Dataset content, place;
                      content.text(0x00209056, "SH", std::to_string(are_in_turn ? z % 2 : z / 3));
                      place.text(
                          0x00200032, "DS",
                          decimals({-10, -20, 100 + 2.5 * z + (are_in_turn || z < 3 ? 0 : 40)}));
                      group.sequence(0x00209111, {content}).sequence(0x00209113, {place});
                      return slice_values(z);
                    })
        .file();
  };
  CHECK(read_samples(write("a.dcm", stacks(true))) == as_read(volume_values()));
  check_refused(write("b.dcm", stacks(false)),
                "3 slices of 8 x 6, 'MR', stack '0', at 100 to 105 mm",
                "2 slices of 8 x 6, 'MR', stack '1', at 147.5 to 150 mm");
}

TEST_CASE_FIXTURE(Dicom,
                  "label and control images of arterial spin labelling are separate volumes") {
  const auto file = put(enhanced(2 * depth, [](Dataset& group, int i) {
    Dataset labelling;
    labelling.text(0x00189257, "CS", i < depth ? "LABEL" : "CONTROL");
    place_frame(group, i % depth).sequence(0x00189251, {labelling});
    return slice_values(i % depth);
  }));
  check_refused(file, "label or control 'CONTROL'");
  CHECK(read_samples(file, {{}, {}, "2"}) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(
    Dicom,
    "ultrasound frames with positions in the space of the volume are read, also in reverse order") {
  Dataset data = enhanced(depth, [](Dataset& group, int i) {
    Dataset place, orientation;
    place.real(0x00209301, {0, 0, 2.5 * (depth - 1 - i)});
    orientation.real(0x00209302, {1, 0, 0, 0, 1, 0});
    group.sequence(0x0020930e, {place}).sequence(0x0020930f, {orientation});
    return slice_values(depth - 1 - i);
  });
  const auto reader = open_volume(put(data));
  CHECK(reader->info().spacing_mm == Spacing{0.5, 0.75, 2.5});
  CHECK_FALSE(noted(reader->info(), "no positions"));
  CHECK((!reader->info().placement || reader->info().placement->space == Space::scanner));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(
    Dicom, "frames with positions are not read as a mosaic, even if the image type has MOSAIC") {
  Dataset data = enhanced(depth, [](Dataset& group, int z) {
    place_frame(group, z);
    return slice_values(z);
  });
  data.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
  CHECK(read_samples(put(data)) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Dicom, "DICOM frames at one position are slices spaced by their thickness") {
  const auto reader = open_volume(put(enhanced(depth, [](Dataset& group, int z) {
    place_frame(group, 0);
    return slice_values(z);
  })));
  CHECK(noted(reader->info(), "one position for all frames, read as slices 2.5 mm apart"));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Folder, "a DICOM spacing of 0 or less is noted, and 1 mm is assumed") {
  for (const std::string none : {"0\\0", "-0.75\\-0.5"}) {
    write_slices(*this, "a", [&](Dataset& data, int) { data.text(pixel_spacing, "DS", none); });
    CHECK(noted(read_info(path()), "PixelSpacing is "));
    CHECK(noted(read_info(path()), "1 mm assumed"));
  }
}

TEST_CASE("DICOM slices slightly off their expected positions are read with a note") {
  const Folder along, aside;
  write_slices(along, "a", [](Dataset& data, int z) {
    put_at(data, {-10, -20, 100 + 2.5 * z + (z == 2 ? 0.123 : 0)});
  });
  CHECK(noted(read_info(along.path()), "slices lie up to 0.123 mm from their place"));
  write_slices(aside, "a", [](Dataset& data, int z) {
    put_at(data, {-10 + (z == 2 ? 0.123 : 0), -20, 100 + 2.5 * z});
  });
  const VolumeInfo info = read_info(aside.path());
  CHECK(noted(info, "slices lie up to 0.123 mm aside of a straight line"));
  check_places(info, {-10, -20, 100}, along_axes);
}

TEST_CASE_FIXTURE(Folder,
                  "the refusal of a sideways shift names the slices before and after the shift") {
  write_slices(*this, "a", [](Dataset& data, int z) {
    put_at(data, {z < 3 ? -10.0 : 0.0, -20, 100 + 2.5 * z});
  });
  check_refused(path(), "a3 is shifted sideways by 10 mm against a2");
}

TEST_CASE_FIXTURE(
    Folder, "the refusal of slices at the same position counts the positions that have several") {
  write_slices(*this, "a", [](Dataset&, int) {});
  for (const int z : {1, 2}) {
    Dataset other = slice(z + 1, "other" + std::to_string(z));
    write("other" + std::to_string(z),
          put_at(other, position(z)).text(0x00200013, "IS", "7").file());
  }
  check_refused(path(), "2 of 5 places hold several slices, from 102.5 to 105 mm");
}

TEST_CASE_FIXTURE(Folder,
                  "DICOM elements with the value representation UN are read by their tags") {
  write_slices(*this, "a",
               [](Dataset& data, int) { data.bytes(pixel_spacing, "UN", "0.75\\0.5"); });
  CHECK(read_info(path()).spacing_mm == Spacing{0.5, 0.75, 2.5});
}

TEST_CASE_FIXTURE(Folder,
                  "DICOM content that contradicts its transfer syntax is read with a note") {
  for (int z = 0; z < depth; ++z)
    write("a" + std::to_string(z), slice(z).file(Order::little_endian, "1.2.840.10008.1.2"));
  const auto reader = open_volume(path());
  CHECK(noted(reader->info(), "the transfer syntax in the header is wrong"));
  CHECK(read_all(*reader) == as_read(volume_values()));
}

TEST_CASE_FIXTURE(Dicom,
                  "contours (RTSTRUCT) are refused, and the message names a program that converts "
                  "contours to masks") {
  Dataset liver, data;
  liver.text(0x30060026, "LO", "Liver");
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.481.3").text(0x00080060, "CS", "RTSTRUCT");
  data.sequence(0x30060020, {liver});
  check_refused(put(data), "this is an RTSTRUCT, the contours 'Liver'", "dcmrtstruct2nii");
}

TEST_CASE_FIXTURE(Dicom,
                  "a document inside DICOM is refused, and the message names the command that "
                  "extracts the document") {
  Dataset data;
  data.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.104.3").text(0x00080060, "CS", "M3D");
  data.text(0x00420012, "LO", "model/stl").bytes(0x00420011, "OB", "solid");
  check_refused(put(data), "this is a document in a DICOM file ('model/stl'); it is not a volume",
                "EncapsulatedDocument");
}

TEST_CASE_FIXTURE(
    Folder, "a file named .dcm with other content is refused with the name of its actual format") {
  const std::string jpeg = "\xff\xd8\xff\xe0 JFIF";
  check_refused(write("i.jpg.dcm", jpeg), "this is JPEG, and not DICOM; rename it to i.jpg");
  const std::string parts = "--bnd\r\nContent-Type: application/dicom\r\n\r\n";
  check_refused(write("m.dcm", parts), "this is a MIME message, as DICOMweb sends");
}

TEST_CASE_FIXTURE(Folder,
                  "--channel reads DICOM colours, interleaved or planar; beside grey slices, "
                  "colour images are left out") {
  for (const std::uint64_t is_planar : {0U, 1U}) {
    std::vector<std::int64_t> samples;
    const std::size_t count = width * height;
    for (std::size_t z = 0; z < depth; ++z)
      for (std::size_t i = 0; i < 3 * count; ++i) {
        const std::size_t voxel = is_planar == 1 ? i % count : i / 3;
        const std::size_t channel = is_planar == 1 ? i / count : i % 3;
        samples.push_back(
            static_cast<std::int64_t>((7 * (z * count + voxel) + 50 * channel) % 256));
      }
    Dataset data = image("9", "US");
    data.samples(samples, 8, false).whole(0x00280002, {3}).text(0x00280004, "CS", "RGB");
    data.whole(0x00280006, {is_planar}).text(0x00280008, "IS", std::to_string(depth));
    const auto file = write("a.dcm", data.file());
    check_refused(file, "the file holds 3 channels ('red', 'green', 'blue')");
    data.text(0x00280004, "CS", "YBR_FULL");
    check_refused(write("y.dcm", data.file()), "the file holds 3 channels ('Y', 'Cb', 'Cr')");
    fs::remove(path() / "y.dcm");
    for (const std::uint32_t channel : {0U, 2U}) {
      const auto values = read_samples(file, of_channel(channel));
      REQUIRE(values.size() == depth * count);
      for (std::size_t i = 0; i < values.size(); ++i)
        REQUIRE(values[i] == static_cast<double>((7 * i + 50 * channel) % 256));
    }
  }
  write_slices(*this, "slice", [](Dataset&, int) {});
  const auto reader = open_volume(path());
  CHECK(read_all(*reader) == as_read(volume_values()));
  CHECK(noted(reader->info(), "are skipped: a colour image"));
}

}  // namespace

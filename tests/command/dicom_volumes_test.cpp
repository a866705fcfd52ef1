// Several volumes in one series of DICOM: times, echoes, phases, kernels; separation and selection.
#include "command.hpp"
#include "dicom_files.hpp"

namespace {

using namespace dicom_files;
using namespace volume_files;
using command_tests::Workshop;

constexpr std::uint32_t kernel = 0x00181210;
constexpr std::uint32_t echo_time = 0x00180081;
constexpr std::uint32_t trigger_time = 0x00181060;
constexpr std::uint32_t temporal_position = 0x00200100;
constexpr std::uint32_t acquisition_number = 0x00200012;
constexpr std::uint32_t instance_number = 0x00200013;
constexpr std::uint32_t inversion_time = 0x00180082;
constexpr std::uint32_t b_value = 0x00189087;

// Volume `number` of a series. Its values are those of the volume plus 5000 times the number.
std::vector<std::int64_t> numbered_values(int number) {
  return changed(volume_values(), [=](std::int64_t value) { return value + 5000 * number; });
}

std::vector<std::int64_t> numbered_slice_values(int number, int z) {
  return changed(slice_values(z), [=](std::int64_t value) { return value + 5000 * number; });
}

Dataset numbered_slice(int number, int z) {
  Dataset data = slice(z, std::to_string(number) + "." + std::to_string(z));
  return data.samples(numbered_slice_values(number, z), 16, true);
}

// A folder with volumes from 0 on. add: adds the differing elements to a slice, by volume number
// and z.
class Volumes : public Folder {
 public:
  template <class Add>
  Volumes(int count, Add add) {
    for (int number = 0; number < count; ++number)
      for (int z = 0; z < depth; ++z) {
        Dataset data = numbered_slice(number, z);
        add(data, number, z);
        write("IM" + std::to_string((7 * z + 3 * number) % 11) + std::to_string(number),
              data.file());
      }
  }

  std::vector<double> read_series(const std::string& series) const {
    return read_samples(path(), with(&VolumeOptions::series, series));
  }

  std::vector<double> read_frame(std::uint32_t frame) const {
    return read_samples(path(), of_frame(frame));
  }

  void check_all(int count) const {
    for (int number = 0; number < count; ++number) {
      INFO("volume ", number);
      CHECK(read_series(std::to_string(number + 1)) == as_read(numbered_values(number)));
      CHECK(read_frame(static_cast<std::uint32_t>(number)) == as_read(numbered_values(number)));
    }
  }
};

// Checks that the volumes are listed with these words, and read.
template <class Add>
void check_volumes(int count, const std::vector<std::string>& listed, Add add) {
  const Volumes volumes(count, add);
  for (const std::string& part : listed) check_refused(volumes.path(), part);
  volumes.check_all(count);
}

void put_kernel(Dataset& data, int number, int) {
  data.text(kernel, "SH", number == 0 ? "B30" : "B70");
}

void put_time(Dataset& data, int number, int) {
  data.text(temporal_position, "IS", std::to_string(number + 1));
}

TEST_CASE("DICOM volumes with one UID are separated and listed by convolution kernel") {
  const Volumes volumes(2, put_kernel);
  const std::string text = refusal(volumes.path()) + "\n";
  check_refusal(
      text, "several volumes in one series; choose one with --series N, its number in this list:");
  check_refusal(text, "\n  1: 5 slices of 8 x 6, 'CT', kernel 'B30', UID 1.2.3\n");
  check_refusal(text, "\n  2: 5 slices of 8 x 6, 'CT', kernel 'B70', UID 1.2.3\n");
  volumes.check_all(2);
}

TEST_CASE("DICOM volumes of two kernels are separated if their slices alternate") {
  check_volumes(2, {}, [](Dataset& data, int number, int z) {
    put_kernel(data, number, z);
    put_at(data, {-10, -20, 100 + 2.5 * z + 1.25 * number});
  });
}

TEST_CASE("DICOM volumes that continue each other are listed with their positions and a remedy") {
  const auto two = [](double second) {
    return Volumes(2, [second](Dataset& data, int number, int z) {
      put_kernel(data, number, z);
      put_at(data, {-10, -20, number == 0 ? 2.5 * z : second + 5 * z});
    });
  };
  check_refused(two(20).path(), ", or resample all to one distance of slices", "at 20 to 40 mm");
  CHECK(refusal(two(5).path()).find("resample") == std::string::npos);
}

TEST_CASE("DICOM images are separate volumes if their image types differ from the third value on") {
  check_volumes(2, {"image type 'M\\ND'"}, [](Dataset& data, int number, int z) {
    const std::string origin = z % 2 == 0 ? "ORIGINAL" : "DERIVED";
    data.text(0x00080008, "CS", origin + (number == 0 ? "\\PRIMARY\\M\\ND" : "\\PRIMARY\\P\\ND"));
  });
}

TEST_CASE("volumes of several times are separated, and chosen with --frame or --series") {
  const Volumes volumes(3, [](Dataset& data, int number, int z) {
    put_time(data, number, z);
    data.text(trigger_time, "DS", std::to_string(9 * number));
  });
  check_refused(volumes.path(),
                "1: 5 slices of 8 x 6, 'CT', temporal position 1, trigger time 0 ms, UID",
                "3: 5 slices of 8 x 6, 'CT', temporal position 3, trigger time 18 ms, UID");
  volumes.check_all(3);
  VolumeOptions options = of_frame(1);
  CHECK(read_info(volumes.path(), options).frames == 3);
  options.frame = 3;
  check_refused(volumes.path(), options, "there is no volume 3; choose one with --frame 0 to 2");
}

TEST_CASE("--frame counts volumes within the series chosen by --series") {
  const Volumes volumes(2, [](Dataset& data, int number, int) {
    data.text(echo_time, "DS", number == 0 ? "4.6" : "9.2");
  });
  for (int z = 0; z < depth; ++z)
    volumes.write("other" + std::to_string(z),
                  slice(z, "5." + std::to_string(z)).text(0x0020000e, "UI", "1.2.4").file());
  VolumeOptions options = of_frame(1);
  check_refused(volumes.path(), options, "several volumes; choose one ");
  options.series = "1.2.3";
  const auto reader = open_volume(volumes.path(), options);
  CHECK(reader->info().frames == 2);
  CHECK(read_all(*reader) == as_read(numbered_values(1)));
  options.series = "3";
  options.frame = 0;
  CHECK(read_samples(volumes.path(), options) == as_read(volume_values()));
}

TEST_CASE("echo times that differ only by rounding do not separate volumes") {
  check_volumes(2, {"echo time 4.6 ms"}, [](Dataset& data, int number, int z) {
    data.text(echo_time, "DS",
              std::string(number == 0 ? "4.6" : "9.2") + (z == 2 ? "00000001" : ""));
  });
}

TEST_CASE("volumes are separated by echo time and by time") {
  check_volumes(4, {"temporal position 2, echo time 6 ms"}, [](Dataset& data, int number, int) {
    data.text(temporal_position, "IS", std::to_string(1 + number / 2));
    data.text(echo_time, "DS", std::to_string(5 + number % 2));
  });
}

TEST_CASE("diffusion volumes are separated by b-value and by gradient direction") {
  const Volumes volumes(4, [](Dataset& data, int number, int) {
    data.real(b_value, {number == 0 ? 0.0 : 1000.0});
    if (number > 0)
      data.real(0x00189089,
                {number == 1 ? 1.0 : 0.0, number == 2 ? 1.0 : 0.0, number == 3 ? 1.0 : 0.0});
  });
  check_refused(volumes.path(), "b-value 1000 s/mm2, gradient '1\\0\\0'");
  CHECK(volumes.read_series("1") == as_read(numbered_values(0)));
  // By the text of the direction.
  CHECK(volumes.read_series("4") == as_read(numbered_values(1)));
}

TEST_CASE(
    "slices whose trigger times all differ are separated into volumes by the order of the times") {
  const Volumes volumes(2, [](Dataset& data, int number, int z) {
    data.text(trigger_time, "DS", std::to_string(100 * number + 7 * z % 5));
    data.text(instance_number, "IS", std::to_string(1 + number + 2 * z));
  });
  check_refused(volumes.path(), "1: 5 slices of 8 x 6, 'CT', number 1 by trigger time, UID",
                "2: 5 slices of 8 x 6, 'CT', number 2 by trigger time, UID");
  volumes.check_all(2);
  CHECK(noted(read_info(volumes.path(), with(&VolumeOptions::series, "2")),
              "distinguished only by their order: number 2 by trigger time"));
}

TEST_CASE("instance numbers separate volumes if no attribute separates the slices") {
  check_volumes(3, {"number 3 by instance number"}, [](Dataset& data, int number, int z) {
    data.text(instance_number, "IS", std::to_string(1 + 3 * z + number));
  });
}

TEST_CASE(
    "image types that differ in the first value separate volumes if no other attribute does") {
  check_volumes(2, {"image type 'DERIVED\\SECONDARY'"}, [](Dataset& data, int number, int z) {
    data.text(0x00080008, "CS", number == 0 ? "DERIVED\\SECONDARY" : "ORIGINAL\\PRIMARY");
    data.text(instance_number, "IS", std::to_string(z + 1));
  });
}

TEST_CASE("attributes that vary between slices do not separate volumes") {
  // Seven volumes of five slices, with fewer values than volumes.
  check_volumes(7, {"acquisition 7"}, [](Dataset& data, int number, int z) {
    data.text(inversion_time, "DS", std::to_string(100 + z));
    data.text(instance_number, "IS", std::to_string(z + 1));
    data.text(acquisition_number, "IS", std::to_string(number + 1));
  });
}

TEST_CASE("slices are not separated by order if positions have different numbers of slices") {
  const Volumes volumes(2, [](Dataset& data, int number, int z) {
    data.text(instance_number, "IS", std::to_string(1 + number + 2 * z));
  });
  fs::remove(volumes.path() / ("IM" + std::to_string(7 * 2 % 11) + "0"));
  check_refused(volumes.path(), "no attribute separates their volumes");
}

TEST_CASE("among several DICOM volumes, only the volume with a missing slice is refused") {
  const Volumes volumes(3, put_time);
  fs::remove(volumes.path() / ("IM" + std::to_string((7 * 2 + 3) % 11) + "1"));
  CHECK(volumes.read_series("1") == as_read(numbered_values(0)));
  CHECK(volumes.read_series("3") == as_read(numbered_values(2)));
  check_refused(volumes.path(), with(&VolumeOptions::series, "2"), "1 slice is missing between");
}

TEST_CASE("different slices at one position that no attribute separates are refused") {
  const Volumes volumes(2, [](Dataset& data, int, int) { data.drop(instance_number); });
  check_refused(volumes.path(),
                "two slices at 100 mm differ: ", "no attribute separates their volumes",
                "give a pattern of the files of one volume");
  CHECK(read_samples(volumes.path() / "IM*1") == as_read(numbered_values(1)));
}

TEST_CASE("copies of DICOM slices do not count as volumes of another time") {
  const Volumes volumes(2, put_time);
  Dataset copy = numbered_slice(0, 3);
  volumes.write("copy", copy.text(temporal_position, "IS", "1").file());
  volumes.check_all(2);
}

// ---- files of many frames ----

// Two times of all slices, side by side, in one file. has_times: with TemporalPositionIndex;
// otherwise only with DimensionIndexValues.
Dataset side_by_side(bool has_times) {
  return enhanced(2 * depth, [has_times](Dataset& group, int i) {
    const int z = i / 2, time = 1 - i % 2;
    const auto text = [](int number) {
      return number_bytes(static_cast<std::uint64_t>(number), 4, Order::little_endian);
    };
    Dataset content;
    if (has_times)
      content.bytes(0x00209128, "UL", text(time + 1));
    else
      content.bytes(0x00209157, "UL", text(z + 1) + text(time + 1));
    place_frame(group, z).sequence(0x00209111, {content});
    return numbered_slice_values(time, z);
  });
}

TEST_CASE_FIXTURE(Dicom, "volumes of several times in one DICOM file are separated and chosen") {
  for (const bool has_times : {true, false}) {
    const auto file = put(side_by_side(has_times));
    check_refused(file, has_times ? "2: 5 slices of 8 x 6, 'MR', temporal position 2, UID"
                                  : "2: 5 slices of 8 x 6, 'MR', number 2 by dimension index, UID");
    for (const int time : {0, 1})
      CHECK(read_samples(file, of_frame(time)) == as_read(numbered_values(time)));
  }
}

TEST_CASE_FIXTURE(Folder, "DICOM files that each hold all slices are separate volumes") {
  for (const int number : {0, 1}) {
    Dataset data = frames();
    put_at(data, position(0)).text(0x00180050, "DS", "2.5");
    data.text(0x00080018, "UI", "1.2.3.9." + std::to_string(number));
    data.text(instance_number, "IS", std::to_string(number + 1));
    write("v" + std::to_string(number), data.samples(numbered_values(number), 16, true).file());
  }
  for (const int number : {0, 1})
    CHECK(read_samples(path(), of_frame(number)) == as_read(numbered_values(number)));
}

TEST_CASE_FIXTURE(Dicom, "each time slot of nuclear medicine is a separate volume") {
  Dataset detector;
  put_at(detector, position(0));
  Dataset data = frames("NM");
  data.text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION");
  data.text(0x00180088, "DS", "2.5").sequence(0x00540022, {detector});
  std::vector<std::uint64_t> slots, slices;
  std::vector<std::int64_t> samples;
  for (int slot = 0; slot < 2; ++slot)
    for (int z = 0; z < depth; ++z) {
      slots.push_back(static_cast<std::uint64_t>(slot + 1));
      slices.push_back(static_cast<std::uint64_t>(z + 1));
      for (const std::int64_t value : slice_values(z)) samples.push_back(value + 5000 * slot);
    }
  data.text(0x00280008, "IS", "10").whole(0x00540070, slots).whole(0x00540080, slices);
  const auto file = put(data.samples(samples, 16, true));
  check_refused(file, "time slot 2");
  CHECK(read_samples(file, of_frame(1)) == as_read(numbered_values(1)));
}

TEST_CASE_FIXTURE(Workshop, "commands that the list of volumes advises succeed") {
  const Volumes volumes(2, put_kernel);
  const std::string folder = "'" + volumes.path().string() + "'";
  fails("extract " + folder + " --iso 0 -o v.stl", 1, {"--series N"});
  done("extract " + folder + " --iso 0 --series 2 -o v.stl");
  done("extract " + folder + " --iso 0 --frame 1 -o w.stl");
  CHECK(read("v.stl") == read("w.stl"));
}

}  // namespace

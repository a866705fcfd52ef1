// Volumes of any type, converted to 16 bits.
#include "extraction/narrowed_volume.hpp"

#include "volume_files.hpp"

namespace {

using namespace volume_files;
using discmc::meshing::narrowed;
using discmc::meshing::SampleBounds;

// The test volume as float, with some samples replaced.
std::string floats(const std::vector<float>& first) {
  std::string bytes = stored(SampleType::f32);
  std::memcpy(bytes.data(), first.data(), first.size() * sizeof(float));
  return bytes;
}

std::unique_ptr<VolumeReader> opened(const Folder& folder, SampleType type,
                                     const std::string& bytes) {
  return open_volume(folder.write("v.raw", bytes), {RawLayout{{5, 3, 4}, type}});
}

}  // namespace

TEST_CASE_FIXTURE(Folder,
                  "non-finite samples do not affect the bounds that narrow a volume to 16 bits") {
  const float nan = std::nanf(""), infinity = std::numeric_limits<float>::infinity();
  const auto bounds = sample_bounds(
      *opened(*this, SampleType::f32, floats({nan, infinity, -infinity, 1000, -2000})));
  CHECK(bounds.least == -2000);
  CHECK(bounds.greatest == 1000);
}

TEST_CASE_FIXTURE(Folder,
                  "narrowing to 16 bits keeps every voxel on or off, and samples in proportion") {
  for (const auto& each : discmc::command::sample_types) {
    const SampleType type = each.second;
    INFO(each.first);
    const std::string bytes = stored(type);
    const double iso = (sample_at(20, type) + sample_at(21, type)) / 2;
    const SampleBounds bounds = sample_bounds(*opened(*this, type, bytes));
    CHECK(bounds.least == doctest::Approx(sample_at(0, type)));
    const auto volume = narrowed(opened(*this, type, bytes), bounds, iso);
    CHECK(volume->info().type == SampleType::i16);
    const std::vector<double> samples = read_all(*volume);
    const double step = (samples.back() - samples.front()) / (voxels - 1);
    CHECK(samples.back() > 30000);
    for (int i = 0; i < voxels; ++i) {
      const double sample = samples[static_cast<std::size_t>(i)];
      CHECK((sample >= 0) == (i > 20));
      CHECK(std::fabs(sample - samples.front() - i * step) <= 2);
    }
  }
}

TEST_CASE_FIXTURE(Folder, "samples too close to iso for 16 bits stay on their side of iso") {
  const auto volume = narrowed(
      opened(*this, SampleType::f32, floats({1e30F, -1e30F, 0.0F, -1e-30F, std::nanf("")})),
      {-1e30, 1e30}, 0);
  const std::vector<double> samples = read_all(*volume);
  CHECK(samples[0] == 32767);
  CHECK(samples[1] == -32767);
  CHECK(samples[2] == 0);
  CHECK(samples[3] == -1);
  CHECK(samples[4] == -1);
}

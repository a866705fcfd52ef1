// Volumes written as NIfTI-2, and read back.
#include "volumes/formats/nifti/writer.hpp"

#include "volume_files.hpp"

namespace {

using namespace discmc::command;
using discmc::Space;

// A volume in memory; its samples are the bytes 0, 1, 2, ...
class Counted final : public VolumeReader {
 public:
  explicit Counted(VolumeInfo info) : info_(std::move(info)) {}
  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override {
    auto* bytes = static_cast<std::uint8_t*>(samples);
    for (std::uint64_t i = 0; i < info_.slice_bytes(); ++i) bytes[i] = next_++;
  }

 private:
  VolumeInfo info_;
  std::uint8_t next_ = 0;
};

VolumeInfo small_volume() {
  VolumeInfo info;
  info.dims = {3, 2, 4};
  info.type = SampleType::i16;
  info.spacing_mm = {0.1, 2, 3};
  return info;
}

std::unique_ptr<VolumeReader> written_and_opened(const volume_files::Folder& folder,
                                                 const VolumeInfo& info) {
  Counted volume(info);
  const auto file = folder.path() / "v.nii";
  std::ofstream out(file, std::ios::binary);
  std::uint32_t slices = 0;
  write_nifti(
      volume, [&slices](std::uint32_t done) { CHECK(done == ++slices); }, out);
  CHECK(slices == info.dims[2]);
  out.close();
  return open_volume(file);
}

}  // namespace

TEST_CASE("samples of every type are written to NIfTI unchanged") {
  const volume_files::Folder folder;
  for (const auto& each : sample_types) {
    const SampleType type = each.second;
    INFO(each.first);
    VolumeInfo info = small_volume();
    info.type = type;
    const auto volume = written_and_opened(folder, info);
    CHECK(volume->info().type == type);
    CHECK(volume->info().dims == info.dims);
    Counted expected(info);
    std::vector<std::uint8_t> samples(info.slice_bytes()), wanted(info.slice_bytes());
    for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
      volume->read_slice(samples.data());
      expected.read_slice(wanted.data());
      CHECK(samples == wanted);
    }
  }
}

TEST_CASE("a NIfTI file has the slope, the intercept and the spacing") {
  const volume_files::Folder folder;
  VolumeInfo info = small_volume();
  info.slope = 0.1;
  info.intercept = -1024.5;
  info.spacing_mm = {0.1, -2, 3};
  const auto volume = written_and_opened(folder, info);
  CHECK(volume->info().slope == 0.1);
  CHECK(volume->info().intercept == -1024.5);
  CHECK(volume->info().spacing_mm == info.spacing_mm);
}

TEST_CASE("a NIfTI file has the placement of the volume") {
  const volume_files::Folder folder;
  VolumeInfo info = small_volume();
  for (const Space space : {Space::ras, Space::lps}) {
    info.placement = VolumePlacement{space, {10, -20, 30}, {{{0, 0.1, 0}, {-2, 0, 0}, {0, 0, 3}}}};
    const auto volume = written_and_opened(folder, info);
    REQUIRE(volume->info().placement);
    CHECK(in_space(*volume->info().placement, space) == *info.placement);
  }
}

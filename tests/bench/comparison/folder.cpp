#include "command/described_volumes.hpp"
#include "volumes.hpp"
#include "volumes/volume.hpp"

namespace discmc::bench {

namespace {

template <class Sample>
std::vector<Sample> read_all(command::VolumeReader& reader) {
  const command::VolumeInfo& info = reader.info();
  const size_t slice = info.slice_bytes() / sizeof(Sample);
  std::vector<Sample> samples(slice * info.dims[2]);
  for (uint32_t z = 0; z < info.dims[2]; ++z) reader.read_slice(samples.data() + z * slice);
  return samples;
}

Samples read_samples(command::VolumeReader& reader) {
  return command::with_scanner_type(
      reader.info().type, [&](auto type) { return Samples(read_all<decltype(type)>(reader)); });
}

}  // namespace

std::vector<Volume> volumes_in(const std::filesystem::path& folder) {
  std::vector<Volume> volumes;
  for (const command::DescribedVolume& description : command::described_volumes(folder)) {
    const auto reader = command::open_volume(description.file);
    const auto& dims = reader->info().dims;
    const Samples samples = read_samples(*reader);
    for (const int32_t threshold : description.thresholds)
      volumes.push_back(
          {description.file.stem().stem().string() + " at " + std::to_string(threshold), dims[0],
           dims[1], dims[2], threshold, samples});
  }
  return volumes;
}

}  // namespace discmc::bench

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

}  // namespace

Volume read_volume(const std::filesystem::path& file) {
  const auto reader = command::open_volume(file);
  const auto& dims = reader->info().dims;
  return {file.stem().stem().string(),
          dims[0],
          dims[1],
          dims[2],
          0,
          command::with_scanner_type(reader->info().type, [&](auto type) {
            return Samples(read_all<decltype(type)>(*reader));
          })};
}

std::vector<Volume> volumes_in(const std::filesystem::path& folder) {
  std::vector<Volume> volumes;
  for (const command::DescribedVolume& description : command::described_volumes(folder)) {
    const Volume volume = read_volume(description.file);
    for (const int32_t threshold : description.thresholds) {
      volumes.push_back(volume);
      volumes.back().name += " at " + std::to_string(threshold);
      volumes.back().threshold = threshold;
    }
  }
  return volumes;
}

}  // namespace discmc::bench

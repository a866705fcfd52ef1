// HDF5, https://docs.hdfgroup.org/hdf5/: many arrays in a file, of which one is the volume.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <utility>

#include "dataset.hpp"
#include "name.hpp"
#include "text/control_character.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/told_place.hpp"

namespace discmc::command {
namespace {

class Hdf5Volume final : public VolumeReader {
 public:
  Hdf5Volume(std::filesystem::path name, VolumeInfo info, Hdf5Dataset dataset, std::uint64_t frame)
      : name_(std::move(name)),
        info_(std::move(info)),
        dataset_(std::move(dataset)),
        frame_(frame) {}

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    require_slice_left(name_, slice_, info_.dims[2]);
    if (!dataset_.read_slice(frame_, slice_, samples))
      fail(name_,
           "slice " + std::to_string(slice_) + " (the first is 0) of " +
               std::to_string(info_.dims[2]) + " cannot be read: it is damaged or not there",
           "copy or export the file again");
    ++slice_;
  }

  void skip_slice() override {
    require_slice_left(name_, slice_, info_.dims[2]);
    ++slice_;
  }

 private:
  std::filesystem::path name_;
  VolumeInfo info_;
  Hdf5Dataset dataset_;
  std::uint64_t frame_;
  std::uint32_t slice_ = 0;
};

// "/exchange/data (512 x 512 x 100)", with x first.
std::string listed(const Hdf5Description& dataset) {
  std::string text;
  for (auto size = dataset.sizes.rbegin(); size != dataset.sizes.rend(); ++size)
    text += (text.empty() ? "" : " x ") + std::to_string(*size);
  return without_control(dataset.path) + " (" + text + ")";
}

std::string list_of(const std::vector<Hdf5Description>& datasets) {
  constexpr std::size_t max_listed = 10;
  std::string text;
  for (std::size_t i = 0; i < std::min(datasets.size(), max_listed); ++i)
    text += (i > 0 ? ", " : "") + listed(datasets[i]);
  return text + (datasets.size() > max_listed ? ", ..." : "");
}

// Stored values mean nothing without the scale of each slice.
bool is_minc(const std::vector<Hdf5Description>& datasets) {
  return std::any_of(datasets.begin(), datasets.end(), [](const Hdf5Description& dataset) {
    return dataset.path.rfind("/minc-2.0/", 0) == 0;
  });
}

// The only one of three dimensions or more, or else of two.
std::string chosen_path(const std::filesystem::path& file,
                        const std::vector<Hdf5Description>& datasets) {
  std::vector<Hdf5Description> volumes;
  std::copy_if(datasets.begin(), datasets.end(), std::back_inserter(volumes),
               [](const Hdf5Description& dataset) { return dataset.sizes.size() >= 3; });
  if (volumes.empty()) volumes = datasets;
  if (volumes.empty())
    fail(file, "the file holds no array of numbers with two or more dimensions",
         "give one that holds a volume");
  if (volumes.size() > 1)
    fail(file, "the file holds " + std::to_string(volumes.size()) + " arrays: " + list_of(volumes),
         "choose one by its name behind that of the file, as in " + file.filename().string() + ":" +
             without_control(volumes.front().path));
  return volumes.front().path;
}

// Small files may claim large slices: what is unpacked of a byte has a limit.
void require_possible(const std::filesystem::path& file, const VolumeInfo& info) {
  constexpr std::uint64_t max_of_a_byte = 16384;
  std::error_code error;
  const std::uint64_t bytes = std::filesystem::file_size(file, error);
  if (!error && info.slice_bytes() > bytes * max_of_a_byte)
    fail(file,
         "a slice of " + std::to_string(info.slice_bytes()) + " bytes cannot be in a file of " +
             std::to_string(bytes),
         "export or copy the file again");
}

ToldPlace place_of(const Hdf5Dataset& dataset) {
  ToldPlace told;
  told.set_unit("um");
  if (const auto size = dataset.element_size_um())
    std::copy(size->rbegin(), size->rend(), told.spacing.begin());
  return told;
}

}  // namespace

std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options) {
  const Hdf5Name parts = hdf5_name(name);
  if (is_read_once(parts.file)) fail(name, "HDF5 is not read from a pipe", "store it in a file");
  const Hdf5Handle file = open_hdf5_file(parts.file);
  const auto datasets = hdf5_datasets(file);
  if (is_minc(datasets))
    fail(name, "this is MINC, which scales every slice in a way of its own",
         "convert it with mnc2nii");
  Hdf5Dataset dataset(name, file,
                      parts.dataset.empty() ? chosen_path(name, datasets) : parts.dataset);
  VolumeInfo info;
  info.type = *dataset.description().type;
  info.format = "HDF5, " + without_control(dataset.description().path) + ", " + dataset.storage();
  std::vector<std::int64_t> sizes = dataset.description().sizes;
  std::reverse(sizes.begin(), sizes.end());
  set_dims(info, name, sizes, options.frame);
  if (!dataset.is_virtual()) require_possible(dataset.file(), info);
  set_place(info, place_of(dataset), options);
  return std::make_unique<Hdf5Volume>(name, std::move(info), std::move(dataset),
                                      options.frame.value_or(0));
}

}  // namespace discmc::command

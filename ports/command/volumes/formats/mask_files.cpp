// A folder of masks, one per label, as TotalSegmentator writes them.
#include <algorithm>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "text/words.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/packing.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {
namespace {

// Returns the name without the ending of a single-file mask format. Returns nothing for other
// endings and hidden files.
std::optional<std::string> mask_name(const std::filesystem::path& file) {
  const std::filesystem::path bare = without_packing(file).filename();
  const std::string extension = lower(bare.extension().string());
  const bool is_mask = extension == ".nii" || extension == ".nrrd" || extension == ".mha";
  return is_mask && !is_system_name(file) ? std::optional(bare.stem().string()) : std::nullopt;
}

// Requires that a mask has a single label.
class Mask final : public VolumeFilter {
 public:
  Mask(std::filesystem::path file, std::unique_ptr<VolumeReader> labels, VolumeInfo info,
       const std::vector<std::string>& notes)
      : VolumeFilter(std::move(labels)), file_(std::move(file)) {
    own_info() = std::move(info);
    for (const std::string& each : notes) add_note(each);
  }

  void read_slice(void* samples) override {
    volume().read_slice(samples);
    with_whole_type(info().type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const begin = static_cast<const Sample*>(samples);
      std::for_each(begin, begin + info().slice_bytes() / sizeof(Sample), [this](Sample sample) {
        if (sample != 0 && label_ != LabelValue(sample)) set_label(sample);
      });
    });
  }

 private:
  void set_label(LabelValue label) {
    if (label_ != LabelValue(0))
      fail(file_,
           "the values " + label_.text() + " and " + label.text() +
               " are in the file, and each of several files must be the mask of one label",
           "give this file alone, or move it away");
    label_ = label;
  }

  std::filesystem::path file_;
  LabelValue label_{};  // 0: none so far
};

// A mask with another shape or place belongs to another scan.
void require_same_place(const std::filesystem::path& file, const VolumeInfo& info,
                        const std::filesystem::path& first_file, const VolumeInfo& first) {
  const std::string remedy = "extract them one by one, or leave out the masks of other scans";
  const std::string name = shown(first_file.filename().string());
  if (info.dims != first.dims)
    fail(file,
         "the mask has " + extents(info.dims) + " voxels, and " + name + " " + extents(first.dims),
         remedy);
  if (offset_mm(info, first) > 0) fail(file, "the mask lies elsewhere than " + name, remedy);
}

}  // namespace

bool is_mask_name(const std::filesystem::path& file) {
  return mask_name(file).has_value();
}

std::vector<std::filesystem::path> mask_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_mask_name(entry.path())) files.push_back(entry.path());
  return files;
}

std::unique_ptr<VolumeReader> open_masks(const std::filesystem::path& source,
                                         std::vector<std::filesystem::path> files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes) {
  sort_naturally(files);
  const std::uint32_t number = options.frame.value_or(0);
  if (number >= files.size())
    fail(source,
         "there is no volume " + std::to_string(number) + ": there are " +
             std::to_string(files.size()) + " files",
         "choose one with --frame 0 to " + std::to_string(files.size() - 1));
  VolumeOptions file_options;
  file_options.holds_labels = options.holds_labels;
  auto volume = open_volume(files[number], file_options);
  if (number > 0) {
    const auto first = open_volume(files[0], file_options);
    const AxesMatch match = matching_axes(first->info(), volume->info());
    if (!is_same(match)) volume = turned_to(match, std::move(volume), files[number]);
    require_same_place(files[number], volume->info(), files[0], first->info());
  }
  VolumeInfo info = volume->info();
  info.frames = files.size();
  info.labels.clear();
  std::map<std::string, std::filesystem::path> named;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = *mask_name(files[i]);
    const auto [other, is_new] = named.emplace(name, files[i]);
    if (!is_new)
      fail(source,
           "two files are the mask " + shown(name) + ": " +
               shown(other->second.filename().string()) + " and " +
               shown(files[i].filename().string()),
           "move one of them away");
    info.labels.push_back({name, {}, {}, static_cast<std::uint32_t>(i)});
  }
  info.format += ", " + std::to_string(files.size()) + " files";
  return std::make_unique<Mask>(files[number], std::move(volume), std::move(info), notes);
}

}  // namespace discmc::command

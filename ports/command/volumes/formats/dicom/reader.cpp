// DICOM: a file, or the files of a folder under any names.
#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>
#include <vector>

#include "files.hpp"
#include "image.hpp"
#include "order.hpp"
#include "pixels.hpp"
#include "segmentation.hpp"
#include "stack.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/packing.hpp"
#include "volumes/unpacked_volume.hpp"

namespace discmc::command {
namespace {

class DicomVolume final : public NumberedSlices {
 public:
  DicomVolume(const std::filesystem::path& source, VolumeInfo info, std::vector<DicomFrame> stack)
      : NumberedSlices(source, std::move(info)),
        stack_(std::move(stack)),
        is_stored_(have_one_scale(stack_)) {}

 private:
  void read(std::uint32_t slice, void* samples) override {
    const DicomFrame& frame = stack_[slice];
    if (is_stored_)
      pixels_.read(frame, samples);
    else
      read_values(frame, samples);
    if (pixels_.left_out() > 0)
      note(own_info(), "pixels of a file are left out, as many as those of " +
                           std::to_string(pixels_.left_out()) +
                           " further frames; NumberOfFrames does not count them");
  }

  // Converts samples if every slice has its own scale.
  void read_values(const DicomFrame& frame, void* values) {
    const SampleType type = frame.image->type;
    const std::size_t count = std::size_t{info().dims[0]} * info().dims[1];
    stored_.resize(count * sample_bytes(type));
    pixels_.read(frame, stored_.data());
    with_sample_type(type, [&](auto sample) {
      for (std::size_t i = 0; i < count; ++i) {
        std::memcpy(&sample, stored_.data() + i * sizeof sample, sizeof sample);
        const auto value =
            static_cast<float>(frame.slope * static_cast<double>(sample) + frame.intercept);
        std::memcpy(static_cast<unsigned char*>(values) + i * sizeof value, &value, sizeof value);
      }
    });
  }

  std::vector<DicomFrame> stack_;
  bool is_stored_;  ///< whether samples are read as stored
  DicomPixels pixels_;
  std::vector<unsigned char> stored_;
};

// Refuses an image that its file cannot hold.
void require_possible(const DicomImage& image) {
  const bool is_packed = !image.compression.empty();
  command::require_possible(image.file, "an image", picture_bytes(image), is_packed ? 16384 : 1);
}

struct FoundFrames {
  std::vector<DicomFrame> frames;
  std::vector<RejectReason> skipped;  ///< content of each file without slices
  bool is_directory = false;
};

FoundFrames find_frames(const std::vector<std::filesystem::path>& files) {
  FoundFrames found;
  for (const auto& file : files) {
    DicomContent content = dicom_content(file);
    found.is_directory = found.is_directory || content.is_directory;
    std::move(content.frames.begin(), content.frames.end(), std::back_inserter(found.frames));
    if (content.instead && !content.is_directory)
      found.skipped.push_back(std::move(content.instead));
  }
  return found;
}

// Colour images beside grey ones are screenshots, unless the user asks for a channel.
void choose_colours(FoundFrames& found, bool are_asked_for) {
  const auto is_asked_for = [&](const DicomFrame& frame) {
    return (frame.image->channels > 1) == are_asked_for;
  };
  const auto others = std::stable_partition(found.frames.begin(), found.frames.end(), is_asked_for);
  if (others == found.frames.begin() || others == found.frames.end()) return;
  found.skipped.insert(found.skipped.end(), static_cast<std::size_t>(found.frames.end() - others),
                       {are_asked_for ? "a grey image" : "a colour image"});
  found.frames.erase(others, found.frames.end());
}

bool have_same_pixels(const DicomFrame& a, const DicomFrame& b) {
  const std::size_t bytes = std::size_t{a.image->columns} * a.image->rows * a.image->channels *
                            sample_bytes(a.image->type);
  std::vector<unsigned char> of_a(bytes);
  std::vector<unsigned char> of_b(bytes);
  require_possible(*a.image);
  require_possible(*b.image);
  DicomPixels().read(a, of_a.data());
  DicomPixels().read(b, of_b.data());
  return of_a == of_b && a.slope == b.slope && a.intercept == b.intercept;
}

// Returns a list such as "a colour image (2); a video".
std::string list_of(const std::vector<RejectReason>& skipped) {
  constexpr std::size_t max_kinds = 8;
  std::map<std::string, std::size_t> kinds;
  for (const RejectReason& each : skipped) {
    const bool is_listed = kinds.size() < max_kinds || kinds.count(each.what) > 0;
    ++kinds[is_listed ? each.what : "others"];
  }
  std::string text;
  for (const auto& [what, count] : kinds)
    text += (text.empty() ? "" : "; ") + what +
            (count > 1 ? " (" + std::to_string(count) + ")" : std::string());
  return text;
}

[[noreturn]] void fail_empty(const std::filesystem::path& source, const FoundFrames& found,
                             std::size_t files) {
  if (found.skipped.empty())
    fail(source, "there is no image beside the DICOMDIR", "copy the whole folder");
  fail(source,
       (files == 1 ? "this is "
                   : "none of " + std::to_string(files) + " DICOM files holds an image to read: ") +
           list_of(found.skipped),
       found.skipped[0].remedy);
}

std::unique_ptr<VolumeReader> open_stack(const std::filesystem::path& source,
                                         const ChosenStack& chosen, const VolumeOptions& options,
                                         std::vector<std::string> notes) {
  const DicomStack& stack = *chosen.stack;
  for (const DicomFrame& frame : stack.frames) require_possible(*frame.image);
  if (!stack.order.empty())
    notes.push_back("slices in one place are distinguished only by their order: " + stack.order);
  VolumeInfo info;
  for (const std::string& each : notes) note(info, each);
  if (stack.image().segments)
    return open_segmentation(source, stack.frames, std::move(info), options);
  std::vector<DicomFrame> frames = stack.frames;
  order_stack(source, frames, have_same_pixels, options, info);
  info.frames = chosen.among;
  if (frames.size() == 1) note(info, "this is one slice; for a whole series, give its folder");
  set_channels(info, source, stack.image().channels, options.channel, stack.image().channel_names);
  return channel_of(source, std::move(info), options.channel, [&](VolumeInfo all) {
    return std::make_unique<DicomVolume>(source, std::move(all), std::move(frames));
  });
}

void require_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) return;
  const auto target = std::filesystem::read_symlink(file, error);
  if (error) fail(file, "there is no such file", "check the name");
  fail(file, "the link leads nowhere, to " + shown(target.string()),
       "copy the file that the link names");
}

bool is_packed(const std::filesystem::path& file) {
  return packing_of_name(file).has_value();
}

// Unpacks packed files into a folder, and returns the paths of all files.
std::vector<std::filesystem::path> unpacked_files(const std::filesystem::path& source,
                                                  std::vector<std::filesystem::path> files,
                                                  const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto base = std::filesystem::is_directory(source, ignored) ? source : source.parent_path();
  for (auto& file : files) {
    if (!is_packed(file)) continue;
    const auto unpacked = folder / without_packing(file).lexically_relative(base);
    ByteStream stream = open_content(file);
    unpack(stream, unpacked);
    file = unpacked;
  }
  return files;
}

}  // namespace

std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes) {
  for (const auto& file : files) require_file(file);
  const auto packed = std::find_if(files.begin(), files.end(), is_packed);
  if (packed != files.end())
    return unpacked_volume(source, name(*packing_of_name(*packed)), [&](const auto& folder) {
      return open_dicom(source, unpacked_files(source, files, folder), options, notes);
    });
  FoundFrames found = find_frames(files);
  if (found.is_directory && files.size() == 1) {
    const auto folder = std::filesystem::absolute(files[0]).parent_path();
    const auto beside = dicom_files(folder);
    if (beside.size() > 1) return open_dicom(source, beside, options, notes);
  }
  if (found.frames.empty()) fail_empty(source, found, files.size());
  choose_colours(found, options.channel.has_value());
  const DicomSorting sorting = {options.order == SliceOrder::position, options.merges_series};
  const std::vector<DicomStack> stacks = dicom_stacks(found.frames, sorting);
  std::vector<std::string> all_notes = notes;
  if (!found.skipped.empty())
    all_notes.push_back(std::to_string(found.skipped.size()) +
                        (found.skipped.size() == 1 ? " file" : " files") +
                        " without a volume's image are skipped: " + list_of(found.skipped));
  return open_stack(source, chosen_stack(source, stacks, options), options, std::move(all_notes));
}

}  // namespace discmc::command

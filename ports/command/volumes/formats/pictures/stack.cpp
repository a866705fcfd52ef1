#include "stack.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

using Files = std::vector<std::filesystem::path>;

// Whether files describe each other as a set, so that one of them reads all.
bool is_set(const std::filesystem::path& source, const std::filesystem::path& file,
            const Hyperstack& described, const Files& files) {
  const bool is_alone = std::all_of(described.files.begin(), described.files.end(),
                                    [&file](const auto& other) { return other == file; });
  if (is_alone) return false;
  if (std::set(files.begin(), files.end()) !=
      std::set(described.files.begin(), described.files.end()))
    fail(source,
         shown(file.filename().string()) + " is one of a set of " +
             std::to_string(described.files.size()) + " files",
         "give this file alone; it names the others");
  return true;
}

// ---- pictures of one kind ----

bool differ(double a, double b) {
  constexpr double rounding_share = 1e-3;
  return std::fabs(a - b) > rounding_share * std::fabs(a);
}

std::string text_of(const PictureHeader& header) {
  return std::to_string(header.width) + " x " + std::to_string(header.height) + " samples of " +
         std::string(name(header.type));
}

// Returns a property in which a later picture differs from the first; empty if none.
std::string difference(const PictureHeader& first, const PictureHeader& other) {
  if (other.channels != first.channels)
    return std::to_string(other.channels) + " channels instead of " +
           std::to_string(first.channels);
  if (other.palette != first.palette) return "another palette";
  if (other.is_inverted != first.is_inverted) return "black and white exchanged";
  if (other.runs_backwards != first.runs_backwards) return "rows in another direction";
  return {};
}

bool have_other_pixels(const PictureHeader& first, const PictureHeader& other) {
  if (!first.resolution || !other.resolution) return false;
  const Resolution &a = *first.resolution, &b = *other.resolution;
  return differ(a.pixels[0], b.pixels[0]) || differ(a.pixels[1], b.pixels[1]) ||
         differ(a.unit_mm, b.unit_mm);
}

// Compares pictures with the first one of a stack.
class Alike {
 public:
  Alike(const Stack& stack, const VolumeOptions& options) : stack_(stack), options_(options) {}

  void require(const PictureHeader& header, const Page& page) const {
    const PictureHeader& first = stack_.header;
    if (header.width != first.width || header.height != first.height || header.type != first.type)
      fail_page(page, text_of(header) + ", and " + first_file() + " has " + text_of(first),
                "give slices of one size and type");
    const std::string what = difference(first, header);
    if (!what.empty())
      fail_page(page, what + ", unlike " + first_file(), "store the slices in one way");
    if (have_other_pixels(first, header) && !options_.spacing_mm)
      fail_page(page, "another resolution than " + first_file(),
                "if its voxels have the same size, give --spacing X,Y,Z");
  }

  void require(const Hyperstack& described, const std::filesystem::path& file) const {
    const Hyperstack& first = stack_.described;
    if (described.channels.size != first.channels.size ||
        described.frames.size != first.frames.size)
      fail(file, "it holds other channels or volumes than " + first_file(),
           "give slices of one kind");
    if (described.slope != first.slope || described.intercept != first.intercept)
      fail(file, "its values have another scale than those of " + first_file(),
           "store the slices in one way");
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!options_.spacing_mm &&
          differ(described.spacing_mm[axis].value_or(1), first.spacing_mm[axis].value_or(1)))
        fail(file, "its voxels have another size than those of " + first_file(),
             "if the sizes are the same, give --spacing X,Y,Z");
  }

 private:
  std::string first_file() const { return stack_.files[stack_.pages[0].file].filename().string(); }

  [[noreturn]] void fail_page(const Page& page, const std::string& what,
                              const std::string& remedy) const {
    fail(stack_.files[page.file], "page " + std::to_string(page.number) + " has " + what, remedy);
  }

  const Stack& stack_;
  const VolumeOptions& options_;
};

// ---- the stack ----

class StackBuilder {
 public:
  StackBuilder(const std::filesystem::path& source, const VolumeOptions& options, VolumeInfo& info)
      : source_(source), options_(options), info_(info) {}

  Stack build(const Files& files) {
    for (const auto& file : files) {
      const auto opened = open_picture(file);
      const auto described = opened->hyperstacks(options_.axes);
      if (add(file, *opened, described, files)) break;
    }
    return std::move(stack_);
  }

 private:
  // Returns whether this file names all the others.
  bool add(const std::filesystem::path& file, PictureFile& opened,
           const std::vector<Hyperstack>& described, const Files& files) {
    const ChosenFrame chosen = chosen_frame(source_, described, options_.frame);
    const Hyperstack& stack = *chosen.stack;
    const bool is_whole = files.size() > 1 && is_set(source_, file, stack, files);
    const bool is_first = stack_.pages.empty();
    if (files.size() > 1 && !is_whole && stack.slices.size > 1 && options_.axes.empty())
      fail(source_,
           std::to_string(files.size()) + " files, of which " + shown(file.filename().string()) +
               " alone has " + std::to_string(stack.slices.size) + " slices",
           "name one file, or give --axes zyx if their slices are those of one volume");
    if (!is_first) Alike(stack_, options_).require(stack, file);
    add_pages(file, opened, stack, chosen.frame);
    if (is_first) {
      stack_.described = stack;
      info_.frames = chosen.frames;
    }
    for (const std::string& text : stack.notes) note(info_, text);
    return is_whole;
  }

  void add_pages(const std::filesystem::path& file, PictureFile& opened, const Hyperstack& stack,
                 std::uint64_t frame) {
    Headers headers(file, opened);
    const Page first_page = pages_of(file, stack, 0, frame)[0];
    const PictureHeader header = headers.header(stack.files[first_page.file], first_page.number);
    require_possible(
        file, "a picture",
        std::uint64_t{header.width} * header.height * header.channels * sample_bytes(header.type));
    require_size(file, stack, header);
    if (stack_.pages.empty()) choose_channel(stack, header);
    const auto first = static_cast<std::uint32_t>(stack_.files.size());
    stack_.files.insert(stack_.files.end(), stack.files.begin(), stack.files.end());
    for (Page page : pages_of(file, stack, options_.channel.value_or(0) / header.channels, frame)) {
      const PictureHeader page_header = headers.header(stack.files[page.file], page.number);
      page.file += first;
      stack_.pages.push_back(page);
      Alike(stack_, options_).require(page_header, page);
    }
  }

  // Headers of pages in a file, and in others that it names.
  class Headers {
   public:
    Headers(const std::filesystem::path& file, PictureFile& opened)
        : file_(file), opened_(opened) {}

    PictureHeader header(const std::filesystem::path& file, std::uint32_t page) {
      if (file == file_) return opened_.header(page);
      if (!other_ || file != other_file_) other_ = open_picture(file);
      other_file_ = file;
      return other_->header(page);
    }

   private:
    const std::filesystem::path& file_;
    PictureFile& opened_;
    std::filesystem::path other_file_;
    std::unique_ptr<PictureFile> other_;
  };

  static void require_size(const std::filesystem::path& file, const Hyperstack& stack,
                           const PictureHeader& header) {
    if (stack.plane_size &&
        *stack.plane_size != std::array<std::uint64_t, 2>{header.width, header.height})
      fail(file,
           "the description has planes of " + std::to_string((*stack.plane_size)[0]) + " x " +
               std::to_string((*stack.plane_size)[1]) + ", and the pages have " + text_of(header),
           "export the file again");
  }

  void choose_channel(const Hyperstack& stack, const PictureHeader& header) {
    const std::uint64_t channels = stack.channels.size * header.channels;
    if (stack.slices.size == 1 && stack.channels.size > 1 && !options_.channel)
      fail(source_,
           "the file holds " + std::to_string(channels) +
               " channels of one slice each, and one is read at a time",
           std::string("choose one with --channel N, the first is 0") + if_slices);
    const auto& names = header.channels == 1       ? stack.channel_names
                        : stack.channels.size == 1 ? header.channel_names
                                                   : std::vector<std::string>();
    set_channels(info_, source_, channels, options_.channel, names);
    stack_.channel = options_.channel.value_or(0) % header.channels;
    stack_.header = header;
  }

  const std::filesystem::path& source_;
  const VolumeOptions& options_;
  VolumeInfo& info_;
  Stack stack_;
};

}  // namespace

Stack stack_of(const std::filesystem::path& source, const Files& files,
               const VolumeOptions& options, VolumeInfo& info) {
  return StackBuilder(source, options, info).build(files);
}

}  // namespace discmc::command

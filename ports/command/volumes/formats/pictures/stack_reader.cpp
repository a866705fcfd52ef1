// A stack of pictures as a volume: a slice a picture, in the order of their names, or as the file
// describes its pages.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "picture_file.hpp"
#include "picture_names.hpp"
#include "skyscan.hpp"
#include "stack_names.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::command {

namespace {

using Files = std::vector<std::filesystem::path>;

// The pictures of a volume, and what is said of them.
struct Stack {
  Files files;
  std::vector<Page> pages;
  std::uint32_t channel = 0;  // of the pixels
  Hyperstack described;       // by the first file
  PictureHeader header;       // of the first picture
};

class PictureStack final : public VolumeReader {
 public:
  PictureStack(const std::filesystem::path& source, VolumeInfo info, Stack stack)
      : source_(source), info_(std::move(info)), stack_(std::move(stack)) {}

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    require_slice_left(source_, next_, stack_.pages.size());
    const Page page = stack_.pages[next_];
    if (!opened_ || page.file != opened_file_) opened_ = open_picture(stack_.files[page.file]);
    opened_file_ = page.file;
    const PictureHeader header = opened_->header(page.number);
    if (header.width != info_.dims[0] || header.height != info_.dims[1] ||
        header.type != info_.type || header.channels != stack_.header.channels)
      fail(stack_.files[page.file], "the file has changed while it was read",
           "leave it as it is, and read again");
    opened_->read(page.number, stack_.channel, static_cast<unsigned char*>(samples));
    ++next_;
  }

  void skip_slice() override {
    require_slice_left(source_, next_, stack_.pages.size());
    ++next_;
  }

 private:
  std::filesystem::path source_;
  VolumeInfo info_;
  Stack stack_;
  std::size_t next_ = 0;
  std::unique_ptr<PictureFile> opened_;
  std::uint32_t opened_file_ = 0;
};

// ---- files ----

// All of one kind.
void require_one_kind(const std::filesystem::path& source, const Files& files) {
  std::map<PictureKind, Files> kinds;
  for (const auto& file : files) kinds[kind_of_name(file)].push_back(file);
  if (kinds.size() < 2) return;
  std::string list;
  const Files* most = nullptr;
  for (const auto& [kind, of_kind] : kinds) {
    list += (list.empty() ? "" : " and ") + std::to_string(of_kind.size()) + ' ' +
            std::string(name(kind));
    if (most == nullptr || of_kind.size() > most->size()) most = &of_kind;
  }
  const std::filesystem::path any = "*" + most->front().extension().string();
  fail(
      source, list + " files are not one volume",
      "give a pattern of one kind, such as '" + (most->front().parent_path() / any).string() + "'");
}

// SkyScan's overview lies beside its slices.
void leave_out_overviews(Files& files, std::vector<std::string>& notes) {
  const auto overviews = std::stable_partition(
      files.begin(), files.end(), [](const auto& file) { return !is_overview_name(file); });
  if (overviews == files.begin()) return;
  for (auto file = overviews; file != files.end(); ++file)
    notes.push_back(shown(file->filename().string()) + " is an overview, left out");
  files.erase(overviews, files.end());
}

// Small files may claim large pictures: what is decoded of a byte has a limit.
void require_possible(const std::filesystem::path& file, const PictureHeader& header) {
  constexpr std::uint64_t max_of_a_byte = 16384;
  const std::uint64_t bytes =
      std::uint64_t{header.width} * header.height * header.channels * sample_bytes(header.type);
  const std::uint64_t file_bytes = ByteStream(file).left().value_or(0);
  if (bytes / max_of_a_byte > file_bytes)
    fail(file,
         "a picture of " + std::to_string(bytes) + " bytes cannot be in a file of " +
             std::to_string(file_bytes),
         "copy or export the file again");
}

// Files that describe each other as a set are read by one of them.
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
         "give it alone: it names the others");
  return true;
}

// ---- pictures that are alike ----

bool differ(double a, double b) {
  constexpr double of_rounding = 1e-3;
  return std::fabs(a - b) > of_rounding * std::fabs(a);
}

std::string text_of(const PictureHeader& header) {
  return std::to_string(header.width) + " x " + std::to_string(header.height) + " samples of " +
         std::string(name(header.type));
}

// What a later picture has that the first has not; empty where they are alike.
std::string difference(const PictureHeader& first, const PictureHeader& other) {
  if (other.channels != first.channels)
    return std::to_string(other.channels) + " channels, and not " + std::to_string(first.channels);
  if (other.palette != first.palette) return "another palette";
  if (other.is_inverted != first.is_inverted) return "black and white the other way round";
  if (other.runs_backwards != first.runs_backwards) return "its rows in another direction";
  return {};
}

bool have_other_pixels(const PictureHeader& first, const PictureHeader& other) {
  if (!first.resolution || !other.resolution) return false;
  const Resolution &a = *first.resolution, &b = *other.resolution;
  return differ(a.pixels[0], b.pixels[0]) || differ(a.pixels[1], b.pixels[1]) ||
         differ(a.unit_mm, b.unit_mm);
}

// Compares pictures with the first of a stack.
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
      fail_page(page, what + " as that of " + first_file(), "store the slices in one way");
    if (have_other_pixels(first, header) && !options_.spacing_mm)
      fail_page(page, "another resolution than " + first_file(),
                "if its voxels are as large, give --spacing X,Y,Z");
  }

  void require(const Hyperstack& described, const std::filesystem::path& file) const {
    const Hyperstack& first = stack_.described;
    if (described.channels.size != first.channels.size ||
        described.frames.size != first.frames.size)
      fail(file, "it holds other channels or volumes than " + first_file(),
           "give slices of one kind");
    if (described.slope != first.slope || described.intercept != first.intercept)
      fail(file, "its values are scaled otherwise than those of " + first_file(),
           "store the slices in one way");
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!options_.spacing_mm &&
          differ(described.spacing_mm[axis].value_or(1), first.spacing_mm[axis].value_or(1)))
        fail(file, "its voxels are larger or smaller than those of " + first_file(),
             "if they are as large, give --spacing X,Y,Z");
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

  Stack of(const Files& files) {
    for (const auto& file : files) {
      const auto opened = open_picture(file);
      const auto described = opened->hyperstacks();
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
    if (!is_first) Alike(stack_, options_).require(stack, file);
    add_pages(file, opened, stack, chosen.frame);
    if (is_first) {
      stack_.described = stack;
      info_.frames = chosen.frames;
    }
    for (const std::string& note : stack.notes)
      if (std::find(info_.notes.begin(), info_.notes.end(), note) == info_.notes.end())
        info_.notes.push_back(note);
    return is_whole;
  }

  void add_pages(const std::filesystem::path& file, PictureFile& opened, const Hyperstack& stack,
                 std::uint64_t frame) {
    Headers headers(file, opened);
    const Page any = pages_of(file, stack, 0, frame)[0];
    const PictureHeader header = headers.of(stack.files[any.file], any.number);
    require_possible(file, header);
    require_size(file, stack, header);
    if (stack_.pages.empty()) choose_channel(stack, header);
    const auto first = static_cast<std::uint32_t>(stack_.files.size());
    stack_.files.insert(stack_.files.end(), stack.files.begin(), stack.files.end());
    for (Page page : pages_of(file, stack, options_.channel.value_or(0) / header.channels, frame)) {
      const PictureHeader of_page = headers.of(stack.files[page.file], page.number);
      page.file += first;
      stack_.pages.push_back(page);
      Alike(stack_, options_).require(of_page, page);
    }
  }

  // Headers of pages of a file, and of others that it names.
  class Headers {
   public:
    Headers(const std::filesystem::path& file, PictureFile& opened)
        : file_(file), opened_(opened) {}

    PictureHeader of(const std::filesystem::path& file, std::uint32_t page) {
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
           "its description is of planes of " + std::to_string((*stack.plane_size)[0]) + " x " +
               std::to_string((*stack.plane_size)[1]) + ", and its pages have " + text_of(header),
           "export the file again");
  }

  void choose_channel(const Hyperstack& stack, const PictureHeader& header) {
    const auto& names = header.channels == 1       ? stack.channel_names
                        : stack.channels.size == 1 ? header.channel_names
                                                   : std::vector<std::string>();
    set_channels(info_, source_, stack.channels.size * header.channels, options_, names);
    stack_.channel = options_.channel.value_or(0) % header.channels;
    stack_.header = header;
  }

  const std::filesystem::path& source_;
  const VolumeOptions& options_;
  VolumeInfo& info_;
  Stack stack_;
};

// Where a file is a slice, names that are missing are slices that are missing.
void close_gaps(const std::filesystem::path& source, bool allow_gaps, Stack& stack,
                std::vector<std::string>& notes) {
  if (stack.files.size() != stack.pages.size() || stack.described.files.size() > 1) return;
  const std::vector<Gap> gaps = gaps_of_names(stack.files);
  if (gaps.empty()) return;
  notes.push_back(
      note_of_filling(source, gaps, stack.pages.size(), allow_gaps,
                      "export or copy the pictures again, or number their names without gaps"));
  fill_gaps(stack.pages, gaps);
}

// ---- spacing ----

std::string note_of_resolution(const Resolution& resolution) {
  std::ostringstream note;
  note.imbue(std::locale::classic());
  const double x = resolution.unit_mm / resolution.pixels[0];
  const double y = resolution.unit_mm / resolution.pixels[1];
  note << "its resolution, mostly that of a print, is not used; to use it, give --spacing " << x
       << ',' << y << ",Z";
  return note.str();
}

// The spacing that SkyScan's log gives, where it is of these slices.
std::optional<std::array<double, 3>> spacing_of_log(const Stack& stack,
                                                    std::vector<std::string>& notes) {
  const auto log = skyscan_log(stack.files[0]);
  if (!log) return std::nullopt;
  const std::string called = shown(log->file.filename().string());
  const std::array<std::uint32_t, 2> size = {stack.header.width, stack.header.height};
  const bool is_of_slices = log->size == std::array<std::uint32_t, 2>{} || log->size == size;
  notes.push_back(is_of_slices ? "spacing from " + called
                               : called + " is of slices of another size, and not used");
  return is_of_slices ? std::optional(log->spacing_mm) : std::nullopt;
}

// What is not described along some axis is taken as along another.
std::array<double, 3> completed(const std::array<std::optional<double>, 3>& described,
                                std::size_t slices, std::vector<std::string>& notes) {
  const double any = described[0].value_or(described[1].value_or(described[2].value_or(1)));
  if (!described[2] && slices > 1)
    notes.emplace_back("no distance of slices given, that of pixels taken");
  return {described[0].value_or(any), described[1].value_or(any), described[2].value_or(any)};
}

void set_told_spacing(VolumeInfo& info, const Stack& stack) {
  const auto& described = stack.described.spacing_mm;
  if (described[0] || described[1] || described[2])
    return set_spacing(info, completed(described, stack.pages.size(), info.notes));
  if (const auto spacing = spacing_of_log(stack, info.notes)) return set_spacing(info, *spacing);
  info.notes.emplace_back(no_spacing_note);
  if (stack.header.resolution && stack.header.resolution->unit_mm > 0)
    info.notes.push_back(note_of_resolution(*stack.header.resolution));
}

// Signs of axes that run backwards, and the origin.
void set_place(VolumeInfo& info, const Stack& stack) {
  for (std::size_t axis = 0; axis < 2; ++axis)
    if (stack.header.runs_backwards[axis]) {
      info.spacing_mm[axis] *= -1;
      info.notes.emplace_back(axis == 0 ? "its first column is the right one (Orientation)"
                                        : "its first row is the lowest (Orientation)");
    }
  VolumePlacement placement = along_coordinates(info.spacing_mm);
  for (std::size_t axis = 0; axis < 3; ++axis)
    placement.origin_mm[axis] = -stack.described.origin_voxel[axis] * info.spacing_mm[axis];
  set_placement(info, placement);
}

}  // namespace

std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source, Files files,
                                            const VolumeOptions& options) {
  VolumeInfo info;
  leave_out_overviews(files, info.notes);
  require_one_kind(source, files);
  sort_naturally(files);
  require_one_stack(source, files);
  Stack stack = StackBuilder(source, options, info).of(files);
  close_gaps(source, options.allow_gaps, stack, info.notes);
  info.type = stack.header.type;
  const std::uint64_t frames = info.frames;
  set_dims(
      info, source,
      {stack.header.width, stack.header.height, static_cast<std::int64_t>(stack.pages.size())});
  info.frames = frames;
  if (!options.spacing_mm) set_told_spacing(info, stack);
  set_place(info, stack);
  set_scale(info, source, stack.described.slope, stack.described.intercept);
  if (stack.header.is_inverted)
    info.notes.emplace_back("the low values are the bright ones, taken as stored");
  if (!stack.header.palette.empty())
    info.notes.emplace_back("the samples are numbers of colours in a palette, taken as stored");
  info.format = name(kind_of(stack.files[0]));
  return std::make_unique<PictureStack>(source, std::move(info), std::move(stack));
}

}  // namespace discmc::command

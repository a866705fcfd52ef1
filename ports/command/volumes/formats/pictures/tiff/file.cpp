// TIFF with libtiff, in any compression that it supports.
#include <tiffio.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "descriptions.hpp"
#include "page.hpp"
#include "samples.hpp"
#include "volumes/formats/pictures/picture_file.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

struct Close {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using OpenTiff = std::unique_ptr<TIFF, Close>;

OpenTiff opened(const std::filesystem::path& file) {
  // discmc reports errors itself.
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  OpenTiff tiff(TIFFOpen(file.c_str(), "r"));
  if (!tiff) fail(file, "this is not a TIFF file, or it is damaged", copy_or_export);
  return tiff;
}

class TiffFile final : public PictureFile {
 public:
  explicit TiffFile(const std::filesystem::path& file)
      : file_(file),
        file_bytes_(ByteStream(file).left().value_or(0)),
        tiff_(opened(file)),
        directories_(TIFFNumberOfDirectories(tiff_.get())),
        depth_(page_of(tiff_.get()).depth),
        samples_(file, file_bytes_) {
    // Limits the decoded size per byte, because small files may declare many slices.
    constexpr std::uint64_t max_of_a_byte = 16384;
    const std::uint64_t bytes = page_of(tiff_.get()).plane_bytes();
    if (depth_ > 1 && depth_ / max_of_a_byte > file_bytes_ / std::max<std::uint64_t>(1, bytes))
      fail(file, "pages of " + std::to_string(depth_) + " slices do not fit in the file",
           copy_or_export);
    constexpr std::uint64_t max_pages = std::uint64_t{1} << 31;
    if (pages() > max_pages) fail(file, "it has too many slices", copy_or_export);
  }

  std::vector<Hyperstack> hyperstacks(const std::string& axes) override {
    go_to(0);
    require_read_layout(file_, tiff_.get(), directories_);
    const std::string description = description_of(tiff_.get());
    std::vector<Hyperstack> stacks;
    if (is_ome(description))
      stacks = of_ome(description);
    else if (is_imagej(description))
      stacks = {of_imagej(description)};
    else
      stacks = of_tifffile();
    if (stacks.empty() && axes.empty())
      require_slices_of_scan_image(file_, tiff_.get(), directories_);
    if (stacks.empty()) stacks = {of_pages()};
    note_left_out(stacks[0]);
    if (!axes.empty())
      for (Hyperstack& stack : stacks) set_axis(stack, axis_of_pages(axes));
    return stacks;
  }

  PictureHeader header(std::uint32_t number) override {
    const TiffPage page = go_to(number);
    if (header_ && directory_of_header_ == TIFFCurrentDirectory(tiff_.get())) return *header_;
    require_read(file_, page);
    if (page.depth != depth_)
      fail(file_, "the pages have different depths", "export it as one stack");
    PictureHeader header;
    header.width = page.width;
    header.height = page.height;
    header.type = *sample_type(page);
    header.channels = page.samples;
    const bool is_of_colours =
        page.photometric == PHOTOMETRIC_RGB || page.photometric == PHOTOMETRIC_YCBCR;
    if (is_of_colours && page.samples == 3) header.channel_names = rgb_names;
    if (is_of_colours && page.samples == 4) header.channel_names = rgba_names;
    header.is_inverted = page.photometric == PHOTOMETRIC_MINISWHITE;
    greys_ = palette_of(tiff_.get(), page);
    if (!(header.type == SampleType::u8 && is_grey(greys_)))
      header.palette = std::exchange(greys_, {});
    header.runs_backwards = {
        page.orientation == ORIENTATION_TOPRIGHT || page.orientation == ORIENTATION_BOTRIGHT,
        page.orientation == ORIENTATION_BOTLEFT || page.orientation == ORIENTATION_BOTRIGHT};
    header.resolution = resolution(page);
    directory_of_header_ = TIFFCurrentDirectory(tiff_.get());
    return *(header_ = std::move(header));
  }

  void read(std::uint32_t number, std::uint32_t channel, unsigned char* samples) override {
    const TiffPage page = go_to(number);
    require_read(file_, page);
    if (is_behind(number))
      samples_.read_behind(tiff_.get(), page, place_behind(page, number), channel, samples);
    else
      samples_.read(tiff_.get(), page, number % depth_, channel, samples);
    if (!greys_.empty()) resolve_greys(greys_, samples, std::size_t{page.width} * page.height);
  }

 private:
  // ---- pages ----

  std::uint64_t pages() const { return std::uint64_t{directories_} * depth_; }

  // Whether a page has no directory, but follows the only page with one.
  bool is_behind(std::uint32_t number) const { return directories_ == 1 && number >= depth_; }

  std::uint64_t place_behind(const TiffPage& page, std::uint32_t number) {
    const PagesBehind behind = pages_behind(tiff_.get(), page, file_bytes_);
    if (number >= behind.count) fail_page(number);
    return behind.at + number * page.plane_bytes();
  }

  // Selects the directory of a page.
  TiffPage go_to(std::uint32_t number) {
    const std::uint32_t directory = is_behind(number) ? 0 : number / depth_;
    constexpr std::uint32_t near = 64;
    std::uint32_t current = TIFFCurrentDirectory(tiff_.get());
    if (directory < current || directory - current > near) {
      if (TIFFSetDirectory(tiff_.get(), static_cast<tdir_t>(directory)) == 0) fail_page(directory);
      current = directory;
    }
    for (; current < directory; ++current)
      if (TIFFReadDirectory(tiff_.get()) == 0) fail_page(directory);
    const TiffPage page = page_of(tiff_.get());
    if (page.photometric == PHOTOMETRIC_YCBCR && page.compression == COMPRESSION_JPEG)
      TIFFSetField(tiff_.get(), TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
    return page;
  }

  [[noreturn]] void fail_page(std::uint32_t page) const {
    fail(file_, "page " + std::to_string(page) + " (the first is 0) is damaged", copy_or_export);
  }

  static std::optional<Resolution> resolution(const TiffPage& page) {
    const std::array<double, 2>& pixels = page.resolution;
    if (!(pixels[0] > 0 && pixels[1] > 0)) return std::nullopt;
    if (page.resolution_unit == RESUNIT_INCH) return Resolution{pixels, mm_of_inch};
    if (page.resolution_unit == RESUNIT_CENTIMETER) return Resolution{pixels, mm_of_centimetre};
    return pixels == std::array<double, 2>{1, 1} ? std::nullopt
                                                 : std::optional(Resolution{pixels, 0});
  }

  // ---- volumes ----

  char axis_of_pages(const std::string& axes) const {
    if (axes.size() != 3 || axes.substr(1) != "yx")
      fail(file_, "the pages are rows and columns along one axis, not " + shown(axes),
           "give --axes zyx, cyx or tyx, or leave out --axes");
    return axes[0];
  }

  std::vector<Hyperstack> of_ome(const std::string& description) {
    auto stacks = ome_images(file_, description, page_of(tiff_.get()).samples,
                             [this](const std::filesystem::path& file) -> std::uint64_t {
                               return file == file_ ? directories_
                                                    : TIFFNumberOfDirectories(opened(file).get());
                             });
    note_not_described(stacks);
    return stacks;
  }

  // Undescribed pages are smaller copies and the like, not planes.
  void note_not_described(std::vector<Hyperstack>& stacks) {
    std::vector<bool> is_described(directories_);
    for (const Hyperstack& stack : stacks)
      for (const PageRun& run : stack.runs)
        if (stack.files[run.file] == file_)
          std::fill_n(is_described.begin() + static_cast<std::ptrdiff_t>(run.first_page), run.count,
                      true);
    const TiffPage first = go_to(0);
    std::uint32_t left_out = 0;
    for (std::uint32_t i = 0; i < directories_; ++i) {
      if (is_described[i]) continue;
      const TiffPage page = go_to(i);
      if (!page.is_mask && page.width == first.width && page.height == first.height)
        fail(file_, "the description lacks page " + std::to_string(i), copy_or_export);
      ++left_out;
    }
    if (left_out > 0)
      stacks[0].notes.push_back("pages that the description lacks: " + std::to_string(left_out));
  }

  Hyperstack of_imagej(const std::string& description) {
    const TiffPage page = page_of(tiff_.get());
    Hyperstack stack =
        imagej_stack({file_, directories_, page.samples, page.resolution}, description);
    if (planes(stack) != directories_) require_behind(page, planes(stack));
    return stack;
  }

  // If a description has more planes than there are directories, the planes follow the page
  // of the only directory.
  void require_behind(const TiffPage& page, std::uint64_t planes) {
    const std::uint64_t planes_behind =
        directories_ == 1 ? pages_behind(tiff_.get(), page, file_bytes_).count : 0;
    if (planes > planes_behind)
      fail(file_,
           "the description promises " + std::to_string(planes) + " planes, and the file holds " +
               std::to_string(std::max<std::uint64_t>(directories_, planes_behind)),
           copy_or_export);
  }

  // Returns the arrays of tifffile, one after another. Returns none if they are single planes, and
  // thus slices, or if pages do not match the description.
  std::vector<Hyperstack> of_tifffile() {
    std::vector<Hyperstack> stacks;
    std::uint64_t at = 0;
    bool are_planes = true;
    while (at < pages()) {
      const TiffPage page = go_to(static_cast<std::uint32_t>(at));
      const auto array = shaped_array(file_, description_of(tiff_.get()));
      auto stack = array ? planes_of(*array, sizes(page)) : std::nullopt;
      if (!stack || planes(*stack) % depth_ != 0) return {};
      const std::uint64_t count = planes(*stack);
      if (count > pages() - at) require_behind(page, count);
      stack->files = {file_};
      stack->runs = {{0, at, 0, count}};
      are_planes = are_planes && count == 1;
      at += count;
      stacks.push_back(*std::move(stack));
    }
    return are_planes ? std::vector<Hyperstack>() : stacks;
  }

  static std::vector<std::uint64_t> sizes(const TiffPage& page) {
    if (page.samples == 1) return {page.height, page.width};
    if (page.is_planar) return {page.samples, page.height, page.width};
    return {page.height, page.width, page.samples};
  }

  // Every page is a slice, except masks and smaller copies.
  Hyperstack of_pages() {
    std::optional<TiffPage> full;
    for (std::uint32_t i = 0; i < directories_ && !full; ++i) {
      const TiffPage page = go_to(i * depth_);
      if (!page.is_mask && !page.is_smaller_copy) full = page;
    }
    Hyperstack stack;
    stack.files = {file_};
    stack.slices.size = 0;
    for (std::uint32_t i = 0; i < directories_; ++i)
      if (!full || !is_left_out(*full, go_to(i * depth_))) add_slices(stack, i);
    const std::uint64_t left_out = directories_ - stack.slices.size / depth_;
    if (left_out > 0)
      stack.notes.push_back("pages that are smaller copies or masks are left out: " +
                            std::to_string(left_out));
    return stack;
  }

  static bool is_left_out(const TiffPage& full, const TiffPage& page) {
    const bool is_as_large = page.width == full.width && page.height == full.height;
    return page.is_mask || (page.is_smaller_copy && !is_as_large);
  }

  void add_slices(Hyperstack& stack, std::uint32_t directory) const {
    const std::uint64_t page = std::uint64_t{directory} * depth_;
    if (stack.runs.empty() || stack.runs.back().first_page + stack.runs.back().count != page)
      stack.runs.push_back({0, page, stack.slices.size, 0});
    stack.runs.back().count += depth_;
    stack.slices.size += depth_;
  }

  void note_left_out(Hyperstack& stack) {
    const TiffPage page = go_to(0);
    std::uint16_t count = 0;
    const void* offsets = nullptr;
    if (TIFFGetField(tiff_.get(), TIFFTAG_SUBIFD, &count, &offsets) == 1 && count > 0)
      stack.notes.push_back("further pictures of a page, usually smaller copies, are left out: " +
                            std::to_string(count));
    if (directories_ == 1 && planes(stack) == 1) note_behind(stack, page);
  }

  // Notes complete pages after the only described one.
  void note_behind(Hyperstack& stack, const TiffPage& page) {
    constexpr std::uint64_t max_metadata = 65536;
    const PagesBehind behind = pages_behind(tiff_.get(), page, file_bytes_);
    const std::uint64_t bytes = page.plane_bytes();
    if (behind.count > 1 && (behind.count - 1) * bytes > bytes + max_metadata)
      stack.notes.push_back("bytes after its only page are left out, as many as those of " +
                            std::to_string(behind.count - 1) + " pages");
  }

  std::filesystem::path file_;
  std::uint64_t file_bytes_;
  OpenTiff tiff_;
  std::uint32_t directories_;
  std::uint32_t depth_;  // common to all pages
  TiffSamples samples_;
  std::optional<PictureHeader> header_;  // of the last page
  std::uint32_t directory_of_header_ = 0;
  Palette greys_;  // of that page
};

}  // namespace

std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file) {
  return std::make_unique<TiffFile>(file);
}

}  // namespace discmc::command

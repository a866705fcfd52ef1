// A stack of pictures as a volume: a slice a picture, in the order of their names.
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "picture_file.hpp"
#include "picture_names.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/told_place.hpp"

namespace discmc::command {

void fail_colour(const std::filesystem::path& file, const std::string& what) {
  fail(file, "this is " + what + ", and a volume has one grey value a voxel",
       "convert it to grey, e.g. with ImageMagick: convert IN -colorspace gray OUT");
}

namespace {

std::unique_ptr<PictureFile> open_picture(const std::filesystem::path& file) {
  // For its refusal of what is no file.
  const ByteStream stream(file);
  return is_png_name(file) ? open_png(file) : open_tiff(file);
}

struct Slice {
  std::filesystem::path file;
  std::uint32_t page;
};

class PictureStack final : public VolumeReader {
 public:
  PictureStack(const std::filesystem::path& source, VolumeInfo info, std::vector<Slice> slices)
      : source_(source), info_(std::move(info)), slices_(std::move(slices)) {}

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    require_slice_left(source_, next_, slices_.size());
    const Slice& slice = slices_[next_];
    if (!opened_ || slice.page == 0) opened_ = open_picture(slice.file);
    const PictureHeader header = opened_->header(slice.page);
    if (header.width != info_.dims[0] || header.height != info_.dims[1] ||
        header.type != info_.type)
      fail(slice.file, "the file has changed while it was read",
           "leave it as it is, and read again");
    opened_->read(slice.page, static_cast<unsigned char*>(samples));
    ++next_;
  }

  void skip_slice() override {
    require_slice_left(source_, next_, slices_.size());
    if (slices_[next_].page == 0) opened_.reset();
    ++next_;
  }

 private:
  std::filesystem::path source_;
  VolumeInfo info_;
  std::vector<Slice> slices_;
  std::size_t next_ = 0;
  std::unique_ptr<PictureFile> opened_;
};

std::string text_of(const PictureHeader& header) {
  return std::to_string(header.width) + " x " + std::to_string(header.height) + " samples of " +
         std::string(name(header.type));
}

void require_alike(const PictureHeader& first, const PictureHeader& header,
                   const Slice& first_slice, const Slice& slice) {
  if (header.width != first.width || header.height != first.height || header.type != first.type)
    fail(slice.file,
         "page " + std::to_string(slice.page) + " has " + text_of(header) + ", and " +
             first_slice.file.filename().string() + " has " + text_of(first),
         "give slices of one size and type");
}

// Small files may claim large pictures: what is decoded of a byte has a limit.
void require_possible(const std::filesystem::path& file, const PictureHeader& header) {
  constexpr std::uint64_t max_of_a_byte = 16384;
  const std::uint64_t bytes =
      std::uint64_t{header.width} * header.height * sample_bytes(header.type);
  const std::uint64_t file_bytes = ByteStream(file).left().value_or(0);
  if (bytes / max_of_a_byte > file_bytes)
    fail(file,
         "a picture of " + std::to_string(bytes) + " bytes cannot be in a file of " +
             std::to_string(file_bytes),
         "copy or export the file again");
}

void require_one_kind(const std::filesystem::path& source,
                      const std::vector<std::filesystem::path>& files) {
  const auto png = std::count_if(files.begin(), files.end(), is_png_name);
  const auto others = static_cast<std::ptrdiff_t>(files.size()) - png;
  if (png > 0 && others > 0)
    fail(source,
         std::to_string(png) + " PNG and " + std::to_string(others) +
             " TIFF files are not one volume",
         "give a pattern of one kind, such as '*.png'");
}

// Where a file is a slice, names that are missing are slices that are missing.
void close_gaps(const std::filesystem::path& source,
                const std::vector<std::filesystem::path>& files, bool allow_gaps,
                std::vector<Slice>& slices, VolumeInfo& info) {
  if (files.size() != slices.size()) return;
  const std::vector<Gap> gaps = gaps_of_names(files);
  if (gaps.empty()) return;
  note(info,
       note_of_filling(source, gaps, slices.size(), allow_gaps,
                       "export or copy the pictures again, or number their names without gaps"));
  fill_gaps(slices, gaps);
}

}  // namespace

std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source,
                                            std::vector<std::filesystem::path> files,
                                            const VolumeOptions& options) {
  require_one_kind(source, files);
  sort_naturally(files);
  std::vector<Slice> slices;
  PictureHeader first;
  for (const auto& file : files) {
    const auto opened = open_picture(file);
    for (std::uint32_t page = 0; page < opened->pages(); ++page) {
      const PictureHeader header = opened->header(page);
      slices.push_back({file, page});
      if (slices.size() == 1) first = header;
      require_alike(first, header, slices[0], slices.back());
      if (page == 0) require_possible(file, header);
    }
  }
  VolumeInfo info;
  close_gaps(source, files, options.allow_gaps, slices, info);
  set_dims(info, source, {first.width, first.height, static_cast<std::int64_t>(slices.size())});
  info.type = first.type;
  ToldPlace told;
  told.set_unit("mm");
  if (first.spacing_mm)
    std::copy(first.spacing_mm->begin(), first.spacing_mm->end(), told.spacing.begin());
  set_place(info, told, options);
  if (first.is_inverted) note(info, "the low values are the bright ones, taken as stored");
  info.format = is_png_name(slices[0].file) ? "PNG" : "TIFF";
  return std::make_unique<PictureStack>(source, std::move(info), std::move(slices));
}

}  // namespace discmc::command

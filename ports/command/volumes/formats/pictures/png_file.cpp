// PNG with libpng, which reports errors by long jumps.
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <utility>
#include <vector>

#include "picture_file.hpp"
#include "sample_packing.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

class PngFile final : public SinglePicture {
 public:
  using SinglePicture::SinglePicture;
  ~PngFile() override { close(); }

  PictureHeader header(std::uint32_t) override {
    open();
    const std::vector<std::string>* const names[] = {nullptr, nullptr, &grey_alpha_names,
                                                     &rgb_names, &rgba_names};
    PictureHeader header;
    header.width = png_get_image_width(png_, info_);
    header.height = png_get_image_height(png_, info_);
    header.type = png_get_bit_depth(png_, info_) == 16 ? SampleType::u16 : SampleType::u8;
    header.channels = png_get_channels(png_, info_);
    if (header.channels > 1) header.channel_names = *names[header.channels];
    greys_ = palette();
    if (!is_grey(greys_)) header.palette = std::exchange(greys_, {});
    png_uint_32 x = 0, y = 0;
    int unit = 0;
    if (png_get_pHYs(png_, info_, &x, &y, &unit) != 0 && x > 0 && y > 0)
      header.resolution = {{1.0 * x, 1.0 * y}, unit == PNG_RESOLUTION_METER ? mm_of_metre : 0};
    png_uint_32 bytes = 0;
    png_bytep exif = nullptr;
    if (png_get_eXIf_1(png_, info_, &bytes, &exif) != 0)
      read_orientation(header, file(), {reinterpret_cast<const char*>(exif), bytes});
    return header;
  }

  void read(std::uint32_t, std::uint32_t channel, unsigned char* samples) override {
    const PictureHeader picture = header(0);
    const std::size_t bytes = sample_bytes(picture.type);
    const std::size_t pixels = std::size_t{picture.width} * picture.height;
    const bool is_direct = picture.channels == 1;
    if (!is_direct) pixels_.resize(pixels * picture.channels * bytes);
    unsigned char* const stored = is_direct ? samples : pixels_.data();
    std::vector<png_bytep> rows(picture.height);
    for (std::size_t y = 0; y < rows.size(); ++y)
      rows[y] = stored + y * picture.width * picture.channels * bytes;
    if (!read_rows(rows.data())) fail_damaged();
    if (!is_direct) copy_channel(stored, pixels, bytes, picture.channels, channel, samples);
    if (!greys_.empty()) resolve_greys(greys_, samples, pixels);
    close();
  }

 private:
  [[noreturn]] void fail_damaged() const {
    fail(file(), "the PNG file is damaged (" + damage_ + ")", copy_or_export);
  }

  static void keep_damage(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  Palette palette() const {
    png_colorp colours = nullptr;
    int count = 0;
    if (png_get_PLTE(png_, info_, &colours, &count) == 0 || png_get_channels(png_, info_) > 1)
      return {};
    Palette palette;
    for (int i = 0; i < count; ++i)
      palette.push_back({colours[i].red, colours[i].green, colours[i].blue});
    return palette;
  }

  // Reads up to the first row.
  void open() {
    close();
    stream_ = std::fopen(file().c_str(), "rb");
    if (stream_ == nullptr) fail(file(), "the file cannot be opened", "check its permissions");
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &damage_, keep_damage, ignore);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
    if (!read_header()) fail_damaged();
  }

  void close() {
    if (png_ != nullptr) png_destroy_read_struct(&png_, &info_, nullptr);
    if (stream_ != nullptr) std::fclose(std::exchange(stream_, nullptr));
  }

  // A function that may jump has no local objects.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, stream_);
    png_read_info(png_, info_);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_packing(png_);  // unpacks samples of 1, 2 and 4 bits to bytes, with equal values
    if (!is_native_big_endian()) png_set_swap(png_);
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::FILE* stream_ = nullptr;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string damage_;
  Palette greys_;
  std::vector<unsigned char> pixels_;  // of all channels
};

}  // namespace

std::unique_ptr<PictureFile> open_png(const std::filesystem::path& file) {
  return std::make_unique<PngFile>(file);
}

}  // namespace discmc::command

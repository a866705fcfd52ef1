// PNG, by libpng, whose errors come as long jumps.
#include <png.h>

#include <csetjmp>
#include <cstdio>
#include <utility>
#include <vector>

#include "picture_file.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

class PngFile final : public PictureFile {
 public:
  explicit PngFile(const std::filesystem::path& file) : file_(file) {}
  ~PngFile() override { close(); }

  std::uint32_t pages() override { return 1; }

  PictureHeader header(std::uint32_t) override {
    open();
    const int depth = png_get_bit_depth(png_, info_);
    const int colour = png_get_color_type(png_, info_);
    if (colour == PNG_COLOR_TYPE_PALETTE) fail_colour(file_, "an indexed picture");
    if (colour == PNG_COLOR_TYPE_GRAY_ALPHA) fail_colour(file_, "a picture with transparency");
    if (colour != PNG_COLOR_TYPE_GRAY) fail_colour(file_, "a colour picture");
    PictureHeader header;
    header.width = png_get_image_width(png_, info_);
    header.height = png_get_image_height(png_, info_);
    header.type = depth == 16 ? SampleType::u16 : SampleType::u8;
    return header;
  }

  void read(std::uint32_t, unsigned char* samples) override {
    const PictureHeader told = header(0);
    const std::size_t row_bytes = std::size_t{told.width} * sample_bytes(told.type);
    std::vector<png_bytep> rows(told.height);
    for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = samples + y * row_bytes;
    if (!read_rows(rows.data())) fail_damaged();
    close();
  }

 private:
  [[noreturn]] void fail_damaged() const {
    fail(file_, "the PNG file is damaged (" + damage_ + ")", "copy or export the file again");
  }

  static void keep_damage(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
  }
  static void ignore(png_structp, png_const_charp) {}

  // To the first row.
  void open() {
    close();
    stream_ = std::fopen(file_.c_str(), "rb");
    if (stream_ == nullptr) fail(file_, "the file cannot be opened", "check its permissions");
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, &damage_, keep_damage, ignore);
    info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
    if (info_ == nullptr) throw std::bad_alloc();
    if (!read_header()) fail_damaged();
  }

  void close() {
    if (png_ != nullptr) png_destroy_read_struct(&png_, &info_, nullptr);
    if (stream_ != nullptr) std::fclose(std::exchange(stream_, nullptr));
  }

  // What jumps has no local objects.
  bool read_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_init_io(png_, stream_);
    png_read_info(png_, info_);
    return true;
  }
  bool read_rows(png_bytepp rows) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_packing(png_);  // samples of 1, 2 and 4 bits as bytes, their values kept
    if (!is_native_big_endian()) png_set_swap(png_);
    png_read_image(png_, rows);
    png_read_end(png_, nullptr);
    return true;
  }

  std::filesystem::path file_;
  std::FILE* stream_ = nullptr;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::string damage_;
};

}  // namespace

std::unique_ptr<PictureFile> open_png(const std::filesystem::path& file) {
  return std::make_unique<PngFile>(file);
}

}  // namespace discmc::command

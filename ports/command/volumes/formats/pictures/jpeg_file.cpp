// JPEG with libjpeg, which reports errors by long jumps.
#include <cstddef>
#include <cstdio>
// jpeglib.h needs both headers above.
#include <jpeglib.h>

#include <jerror.h>

#include <csetjmp>
#include <cstdint>
#include <string_view>
#include <utility>

#include "picture_file.hpp"
#include "sample_packing.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// The message of libjpeg, and the target of its jump after an error.
struct Damage : jpeg_error_mgr {
  std::jmp_buf place;
  char text[JMSG_LENGTH_MAX];
};

extern "C" void give_up(j_common_ptr jpeg) {
  auto* const damage = static_cast<Damage*>(jpeg->err);
  damage->format_message(jpeg, damage->text);
  std::longjmp(damage->place, 1);
}

// A warning means that libjpeg has replaced data by grey.
extern "C" void stop_at_damage(j_common_ptr jpeg, int level) {
  if (level < 0 && jpeg->err->msg_code != JWRN_EXTRANEOUS_DATA) give_up(jpeg);
}

std::string_view exif_of(const jpeg_marker_struct* marker) {
  using namespace std::literals;
  constexpr std::string_view begin = "Exif\0\0"sv;
  for (; marker != nullptr; marker = marker->next) {
    const std::string_view data(reinterpret_cast<const char*>(marker->data), marker->data_length);
    if (data.substr(0, begin.size()) == begin) return data.substr(begin.size());
  }
  return {};
}

class JpegFile final : public SinglePicture {
 public:
  using SinglePicture::SinglePicture;
  ~JpegFile() override { close(); }

  PictureHeader header(std::uint32_t) override {
    open();
    PictureHeader header;
    header.width = jpeg_.image_width;
    header.height = jpeg_.image_height;
    if (jpeg_.num_components == 3) {
      header.channels = 3;
      header.channel_names = rgb_names;
    } else if (jpeg_.num_components != 1) {
      fail(file(), std::to_string(jpeg_.num_components) + " components per pixel are not supported",
           "convert it to PNG");
    }
    read_orientation(header, file(), exif_of(jpeg_.marker_list));
    constexpr double units_mm[] = {0, mm_of_inch, mm_of_centimetre};
    if (jpeg_.saw_JFIF_marker != 0 && jpeg_.density_unit < 3 && jpeg_.X_density > 0 &&
        jpeg_.Y_density > 0)
      header.resolution = {{1.0 * jpeg_.X_density, 1.0 * jpeg_.Y_density},
                           units_mm[jpeg_.density_unit]};
    return header;
  }

  void read(std::uint32_t, std::uint32_t channel, unsigned char* samples) override {
    const PictureHeader picture = header(0);
    row_.resize(std::size_t{picture.width} * picture.channels);
    if (!read_rows(picture, channel, samples)) fail_damaged();
    close();
  }

 private:
  [[noreturn]] void fail_damaged() const {
    fail(file(), "the JPEG file is damaged (" + std::string(damage_.text) + ")", copy_or_export);
  }

  void open() {
    close();
    stream_ = std::fopen(file().c_str(), "rb");
    if (stream_ == nullptr) fail(file(), "the file cannot be opened", "check its permissions");
    jpeg_.err = jpeg_std_error(&damage_);
    damage_.error_exit = give_up;
    damage_.emit_message = stop_at_damage;
    if (!read_header()) fail_damaged();
  }

  void close() {
    if (is_created_) jpeg_destroy_decompress(&jpeg_);
    is_created_ = false;
    if (stream_ != nullptr) std::fclose(std::exchange(stream_, nullptr));
  }

  // A function that may jump has no local objects.
  bool read_header() {
    if (setjmp(damage_.place) != 0) return false;
    jpeg_create_decompress(&jpeg_);
    is_created_ = true;
    jpeg_stdio_src(&jpeg_, stream_);
    jpeg_save_markers(&jpeg_, JPEG_APP0 + 1, 0xFFFF);
    jpeg_read_header(&jpeg_, TRUE);
    return true;
  }
  bool read_rows(const PictureHeader& picture, std::uint32_t channel, unsigned char* samples) {
    if (setjmp(damage_.place) != 0) return false;
    jpeg_.out_color_space = picture.channels == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
      unsigned char* const row = samples + std::size_t{picture.width} * jpeg_.output_scanline;
      JSAMPROW decoded = row_.data();
      jpeg_read_scanlines(&jpeg_, &decoded, 1);
      copy_channel(row_.data(), picture.width, 1, picture.channels, channel, row);
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
  }

  std::FILE* stream_ = nullptr;
  jpeg_decompress_struct jpeg_{};
  bool is_created_ = false;
  Damage damage_{};
  std::vector<unsigned char> row_;
};

}  // namespace

std::unique_ptr<PictureFile> open_jpeg(const std::filesystem::path& file) {
  return std::make_unique<JpegFile>(file);
}

}  // namespace discmc::command

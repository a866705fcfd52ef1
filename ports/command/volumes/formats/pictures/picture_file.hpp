// Pictures of grey values, as slices of a volume: PNG and TIFF files.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PICTURE_FILE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_PICTURES_PICTURE_FILE_HPP

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "volumes/sample_type.hpp"

namespace discmc::command {

/// What a picture is.
struct PictureHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  SampleType type = SampleType::u8;
  /// Whether low values are the bright ones.
  bool is_inverted = false;
  /// Units: millimetres; nothing where the file does not tell it.
  std::optional<std::array<double, 3>> spacing_mm = {};
};

/// A file of pictures. What it cannot be read as is thrown as VolumeError.
class PictureFile {
 public:
  PictureFile() = default;
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;
  virtual ~PictureFile() = default;

  /// The number of pictures.
  virtual std::uint32_t pages() = 0;
  virtual PictureHeader header(std::uint32_t page) = 0;
  /// Writes the samples, rows from the top, in native byte order. Size: of samples, as the header
  /// says.
  virtual void read(std::uint32_t page, unsigned char* samples) = 0;
};

std::unique_ptr<PictureFile> open_png(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file);

/// Throws the refusal of a picture that is not of grey values.
[[noreturn]] void fail_colour(const std::filesystem::path& file, const std::string& what);

}  // namespace discmc::command

#endif

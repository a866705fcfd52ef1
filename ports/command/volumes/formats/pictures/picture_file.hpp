// Pictures, as slices of a volume: PNG, TIFF, JPEG and BMP files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hyperstack.hpp"
#include "meshing.hpp"
#include "picture_names.hpp"
#include "sample_packing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// Pixels of a unit of length, mostly of a print.
struct Resolution {
  std::array<double, 2> pixels{};
  double unit_mm = 0;  ///< 0 if there is no unit
};
constexpr double mm_of_inch = 25.4, mm_of_centimetre = 10, mm_of_metre = 1000;

/// What a picture is.
struct PictureHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  SampleType type = SampleType::u8;
  /// Samples of a pixel: several of colours.
  std::uint32_t channels = 1;
  /// For people, or none.
  std::vector<std::string> channel_names = {};
  /// Whether low values are the bright ones.
  bool is_inverted = false;
  /// The colours whose numbers the samples are; none of grey values.
  Palette palette = {};
  /// Whether the first column is the right one, and the first row the lowest.
  std::array<bool, 2> runs_backwards = {};
  std::optional<Resolution> resolution = {};
};

/// A file of pictures. What it cannot be read as is thrown as VolumeError.
class PictureFile {
 public:
  PictureFile() = default;
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;
  virtual ~PictureFile() = default;

  /// The volumes in it, at least one. axes: what its pages are, as in VolumeOptions; otherwise as
  /// the file describes them.
  virtual std::vector<Hyperstack> hyperstacks(const std::string& axes) = 0;
  virtual PictureHeader header(std::uint32_t page) = 0;
  /// Writes the samples of a channel, rows as they are stored, in native byte order. Size: of
  /// samples, as in the header.
  virtual void read(std::uint32_t page, std::uint32_t channel, unsigned char* samples) = 0;
};

/// A file of one picture.
class SinglePicture : public PictureFile {
 public:
  explicit SinglePicture(std::filesystem::path file) : file_(std::move(file)) {}
  std::vector<Hyperstack> hyperstacks(const std::string&) final {
    Hyperstack stack;
    stack.files = {file_};
    stack.runs = {{0, 0, 0, 1}};
    return {stack};
  }

 protected:
  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

/// The kind of a file by its first bytes. Throws as ByteStream.
PictureKind kind_of(const std::filesystem::path& file);

/// Opens a picture by its first bytes.
std::unique_ptr<PictureFile> open_picture(const std::filesystem::path& file);

std::unique_ptr<PictureFile> open_png(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_jpeg(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_bmp(const std::filesystem::path& file);

/// The names of the channels of colours.
inline const std::vector<std::string> rgb_names = {"red", "green", "blue"};
inline const std::vector<std::string> rgba_names = {"red", "green", "blue", "alpha"};
inline const std::vector<std::string> grey_alpha_names = {"grey", "alpha"};

}  // namespace discmc::command

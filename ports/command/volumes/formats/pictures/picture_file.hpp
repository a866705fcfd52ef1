// Picture files as slices of a volume: PNG, TIFF, JPEG and BMP.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hyperstack.hpp"
#include "meshing.hpp"
#include "picture_names.hpp"
#include "sample_packing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// Pixels per unit of length, mostly for printing.
struct Resolution {
  std::array<double, 2> pixels{};
  double unit_mm = 0;  ///< 0 if there is no unit
};
constexpr double mm_of_inch = 25.4, mm_of_centimetre = 10, mm_of_metre = 1000;

/// The description of a picture.
struct PictureHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  SampleType type = SampleType::u8;
  /// Samples per pixel: several for colours.
  std::uint32_t channels = 1;
  /// Names for people, or empty.
  std::vector<std::string> channel_names = {};
  /// Whether low values are bright.
  bool is_inverted = false;
  /// The palette, if samples are indexes of colours; empty for grey values.
  Palette palette = {};
  /// Whether columns begin at the right, and rows at the bottom.
  std::array<bool, 2> runs_backwards = {};
  std::optional<Resolution> resolution = {};
};

/// Sets the directions by EXIF, an embedded TIFF file; empty if there is none. Throws if rows and
/// columns are exchanged.
void read_orientation(PictureHeader& header, const std::filesystem::path& file,
                      std::string_view exif);

/// A file of pictures. Throws VolumeError if it cannot be read.
class PictureFile {
 public:
  PictureFile() = default;
  PictureFile(const PictureFile&) = delete;
  PictureFile& operator=(const PictureFile&) = delete;
  virtual ~PictureFile() = default;

  /// Returns the volumes in the file, at least one. axes: the meaning of pages, as in
  /// VolumeOptions; empty: as the file describes them.
  virtual std::vector<Hyperstack> hyperstacks(const std::string& axes) = 0;
  virtual PictureHeader header(std::uint32_t page) = 0;
  /// Writes the samples of a channel in native byte order, with rows as stored. Size: of samples,
  /// as in the header.
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

/// Returns the kind of a file by its first bytes. Throws like ByteStream.
PictureKind kind_of(const std::filesystem::path& file);

/// Opens a picture of the kind that its first bytes indicate.
std::unique_ptr<PictureFile> open_picture(const std::filesystem::path& file);

std::unique_ptr<PictureFile> open_png(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_tiff(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_jpeg(const std::filesystem::path& file);
std::unique_ptr<PictureFile> open_bmp(const std::filesystem::path& file);

/// The names of colour channels.
inline const std::vector<std::string> rgb_names = {"red", "green", "blue"};
inline const std::vector<std::string> rgba_names = {"red", "green", "blue", "alpha"};
inline const std::vector<std::string> grey_alpha_names = {"grey", "alpha"};

}  // namespace discmc::command

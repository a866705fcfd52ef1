// The images of DICOM files, by their headers, and what files hold instead.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshing.hpp"
#include "pictures/srgb.hpp"
#include "samples/sample_type.hpp"
#include "surface/point.hpp"
#include "traits.hpp"

class DcmItem;

namespace discmc::command {

/// In the space of the patient. Units: millimetres.
using Vector = Point;

/// a + factor * b.
inline Vector sum(const Vector& a, double factor, const Vector& b) {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] + factor * b[i];
  return result;
}

inline double length(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// How slices lie in the picture of a mosaic: in rows, the first at the top left.
struct MosaicLayout {
  std::uint32_t across = 1;  ///< slices side by side, and as many rows of them
};

struct DicomSegment {
  std::string name;
  std::optional<Srgb> colour;
};

struct DicomSegments {
  /// Whether a frame holds one segment, as bits or as fractions, or the numbers of all segments.
  enum class Kind { bits, fractions, numbers };
  Kind kind = Kind::bits;
  /// The fraction of a whole voxel.
  std::uint32_t full = 1;
  /// Whether the file declares that no voxel is of two segments.
  bool are_disjoint = false;
  /// By their numbers.
  std::map<std::uint32_t, DicomSegment> all;
};

/// An image object: the whole of a file, with one frame or more.
struct DicomImage {
  std::filesystem::path file;
  std::string series;    ///< SeriesInstanceUID
  std::string instance;  ///< SOPInstanceUID
  std::string description;
  std::string modality;
  bool is_parametric_map = false;
  std::int32_t series_number = 0;
  /// The number of a file in its series.
  std::optional<std::int32_t> instance_number;
  /// The extents of a slice.
  std::uint32_t columns = 0;
  std::uint32_t rows = 0;
  /// The samples of a voxel, side by side: 3 of colours. Planar: those of a channel side by side.
  std::uint32_t channels = 1;
  bool is_planar = false;
  /// The type of a sample, as wide as it is stored.
  SampleType type = SampleType::u8;
  /// The bits of a whole number, and the place of the highest. Limit: those of the type.
  std::uint32_t bits = 8;
  std::uint32_t high_bit = 7;
  /// Whether a sample is one bit, eight of them in a byte; the type is then u8.
  bool is_of_bits = false;
  /// For a picture of several slices, each of which is then a frame.
  std::optional<MosaicLayout> mosaic;
  /// The segments of a segmentation.
  std::optional<DicomSegments> segments;
  /// Whether low values are bright: MONOCHROME1.
  bool is_inverted = false;
  /// The sample where nothing was scanned: PixelPaddingValue.
  std::optional<std::int32_t> padding;
  /// How the pixel data is compressed; empty if it is not.
  std::string compression;
  /// What the reader assumed, for the user.
  std::vector<std::string> notes;
};

/// Units: bytes of a picture as it is stored, decompressed; of a mosaic that is all of it.
std::uint64_t picture_bytes(const DicomImage& image);

/// Where a frame lies in the patient. Units: millimetres; directions of length 1.
struct DicomPlace {
  Vector position{};  ///< of the centre of the first voxel
  Vector along_row{};
  Vector along_column{};
  bool is_of_patient = true;  ///< otherwise in a space of the scanner, as of ultrasound
};

/// Returns the place by a position and the directions of a row and a column; nothing where one is
/// missing or no direction.
std::optional<DicomPlace> place_of(const std::optional<Vector>& position,
                                   const std::optional<std::array<double, 6>>& orientation);

/// The direction across a frame, right-handed with those in it.
Vector normal_of(const DicomPlace& place);

/// A slice of a volume.
struct DicomFrame {
  std::shared_ptr<const DicomImage> image;
  /// In the file, from 0.
  std::uint32_t number = 0;
  std::optional<DicomPlace> place;
  /// Distances of neighbouring voxels along a row and along a column, and the name of the element
  /// that has them. Units: millimetres, 0 if the file has none.
  std::array<double, 2> spacing_mm{};
  const char* spacing_name = nullptr;
  /// The declared distance of slices, which counts if there are no places, and the name of the
  /// element that has it. Units: millimetres, 0 if the file has none.
  double slice_spacing_mm = 0;
  const char* slice_spacing_name = nullptr;
  double slope = 1;
  double intercept = 0;
  DicomTraits traits;
  /// The number of the segment, if a segmentation has a frame for each; otherwise 0.
  std::uint32_t segment = 0;
};

/// What is in a file instead of slices, "a colour image", and what to do; nothing where slices are.
struct NoSlices {
  std::string what;
  std::string remedy = "give images of a CT, an MRI or the like, with one grey value per voxel";

  explicit operator bool() const { return !what.empty(); }
};

/// What a file holds.
struct DicomContent {
  std::vector<DicomFrame> frames;
  NoSlices instead;
  /// Whether the file is a DICOMDIR, which lists the files of its folder.
  bool is_directory = false;
};

/// Reads the header of a file, not its pixels. Any bytes have a content.
DicomContent dicom_content(const std::filesystem::path& file);

/// Names the format of a file by its first bytes if it is another than DICOM; otherwise nothing.
NoSlices foreign_content(const std::filesystem::path& file);

/// Names what a data set without an image is.
NoSlices without_image(DcmItem& dataset);

}  // namespace discmc::command

// The image in a DICOM file by its header, or the other content of the file.
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

/// A vector in the space of the patient. Units: millimetres.
using Vector = Point;

/// Returns a + factor * b.
inline Vector sum(const Vector& a, double factor, const Vector& b) {
  Vector result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = a[i] + factor * b[i];
  return result;
}

inline double length(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// The layout of slices in the picture of a mosaic: in rows, the first slice at the top left.
struct MosaicLayout {
  std::uint32_t across = 1;  ///< slices per row, and the number of rows
};

struct DicomSegment {
  std::string name;
  std::optional<Srgb> colour;
};

struct DicomSegments {
  /// Whether a frame holds one segment, as bits or as fractions, or the numbers of all segments.
  enum class Kind { bits, fractions, numbers };
  Kind kind = Kind::bits;
  /// The fraction that means a whole voxel.
  std::uint32_t full = 1;
  /// The segments by number.
  std::map<std::uint32_t, DicomSegment> all;
};

/// An image object: the whole file, with one frame or more.
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
  /// The samples of a voxel: 3 for colours. Planar: each channel is stored on its own.
  std::uint32_t channels = 1;
  bool is_planar = false;
  std::vector<std::string> channel_names = {"red", "green", "blue"};
  /// The type of a sample, as wide as it is stored.
  SampleType type = SampleType::u8;
  /// The number of bits of a whole number, and the position of its highest bit. Limit: within the
  /// type.
  std::uint32_t bits = 8;
  std::uint32_t high_bit = 7;
  /// Whether eight one-bit samples share a byte; the type is then u8.
  bool is_of_bits = false;
  /// The layout of a mosaic, whose slices become frames.
  std::optional<MosaicLayout> mosaic;
  /// The segments of a segmentation.
  std::optional<DicomSegments> segments;
  /// Whether low values are bright: MONOCHROME1.
  bool is_inverted = false;
  /// The values of samples that are indexes of a palette; empty if samples are values.
  std::vector<std::uint8_t> greys;
  /// PixelPaddingValue: the sample for places that were not scanned.
  std::optional<std::int32_t> padding;
  /// The compression of the pixel data; empty if there is none.
  std::string compression;
  /// Assumptions of the reader, for the user.
  std::vector<std::string> notes;
};

/// Returns the decompressed size of a stored picture; for a mosaic, of the whole mosaic. Units:
/// bytes.
std::uint64_t picture_bytes(const DicomImage& image);

/// The position of a frame in the patient. Units: millimetres; directions have length 1.
struct DicomPlace {
  Vector position{};  ///< centre of the first voxel
  Vector along_row{};
  Vector along_column{};
  bool is_of_patient = true;  ///< false: in a space of the scanner, as for ultrasound
};

/// Returns the place for a position and the directions of a row and a column, or nothing if an item
/// is missing or unusable.
std::optional<DicomPlace> place_of(const std::optional<Vector>& position,
                                   const std::optional<std::array<double, 6>>& orientation);

/// Returns the normal of a frame, right-handed with its directions.
Vector normal_of(const DicomPlace& place);

/// A slice of a volume.
struct DicomFrame {
  std::shared_ptr<const DicomImage> image;
  /// Index in the file, from 0.
  std::uint32_t number = 0;
  std::optional<DicomPlace> place;
  /// Distances between neighbouring voxels along a row and a column, and the name of the element
  /// that declares them. Units: millimetres, 0 if undeclared.
  std::array<double, 2> spacing_mm{};
  const char* spacing_name = nullptr;
  /// The declared distance between slices, used if there are no positions, and the name of its
  /// element. Units: millimetres, 0 if undeclared.
  double slice_spacing_mm = 0;
  const char* slice_spacing_name = nullptr;
  double slope = 1;
  double intercept = 0;
  DicomTraits traits;
  /// The segment number, if each frame is of one segment; otherwise 0.
  std::uint32_t segment = 0;
};

/// The content of a file without slices, such as "a colour image", and the remedy; empty for
/// slices.
struct RejectReason {
  std::string what;
  std::string remedy = "give images of a CT, an MRI or the like, with one grey value per voxel";

  explicit operator bool() const { return !what.empty(); }
};

/// The content of a file.
struct DicomContent {
  std::vector<DicomFrame> frames;
  RejectReason instead;
  /// Whether the file is a DICOMDIR, a list of files.
  bool is_directory = false;
};

/// Reads the header of a file, not its pixels. Accepts any bytes.
DicomContent dicom_content(const std::filesystem::path& file);

/// Names the format of a file that is not DICOM by its first bytes; otherwise returns nothing.
RejectReason foreign_content(const std::filesystem::path& file);

/// Names the content of a data set without an image.
RejectReason without_image(DcmItem& dataset);

// One file may describe the positions of all frames: doses, nuclear medicine, cone beams. A mosaic
// of Siemens holds all slices of a volume in one picture.

/// Whether functional groups have the positions, not the file as a whole.
bool have_own_positions(DcmItem& dataset);

/// Moves each frame to its position, if the file has one position for all. Adds assumptions to the
/// notes of the image. Returns why this is impossible, or nothing.
RejectReason place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

/// Whether a file holds a mosaic of Siemens, or the similar one of United Imaging.
bool is_mosaic(DcmItem& dataset);

/// Replaces the single frame of a mosaic by the frames of its slices, each at its position, and the
/// extents by a slice's. Returns why this is impossible, or nothing.
///
/// The slices fill rows of the smallest square that holds them all. The position in the file is
/// that of a picture as large as the mosaic, centred on the first slice. SliceNormalVector in the
/// CSA header is the direction to the next slice (nibabel's "Siemens mosaic format" and dcm2niix
/// agree).
RejectReason unfold_mosaic(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames);

}  // namespace discmc::command

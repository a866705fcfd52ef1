// Volumes from files and pipes, slice by slice: the formats of README.md, and headerless samples.
//
// A reader holds one small buffer, never the volume; of a file whose size does not bound a slice,
// the first slice. Any bytes given as a file end in a volume or
// in a VolumeError. Every VolumeError names the file, the value at fault and the remedy.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "label_table.hpp"
#include "sample_type.hpp"
#include "volume_placement.hpp"

namespace discmc::host {

/// What cannot be read, and why.
class VolumeError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a file says about its volume.
struct VolumeInfo {
  /// Width, height and number of slices. Units: voxels. Limit: 1 to 32766 in x and y, 1 to 2^30 - 1
  /// in z.
  std::array<std::uint32_t, 3> dims{};
  SampleType type = SampleType::u8;
  /// The extents before a part was taken, or the volume was shrunk. Units: voxels.
  std::optional<std::array<std::uint32_t, 3>> whole_dims;
  /// The number of volumes in the file, of which this is one: 3D volumes of a 4D one.
  std::uint64_t frames = 1;
  /// Distance between neighbouring voxels along x, y and z, negative where the axis runs backwards.
  /// An oblique left-handed volume has a negative z, so that no shape is ever mirrored, and the
  /// placement only turns and moves it.
  /// Units: millimetres. Limit: least_spacing_mm to most_spacing_mm either way.
  std::array<double, 3> spacing_mm{1, 1, 1};
  /// Where the volume lies; nothing where the file tells no more of it than the spacing.
  /// Limit: is_usable().
  std::optional<VolumePlacement> placement;
  /// value = slope * stored + intercept, in the file's declared units. Limit: slope > 0.
  double slope = 1;
  double intercept = 0;
  /// Whether the file says that values are Hounsfield units.
  bool is_in_hounsfield = false;
  /// The names and colours of labels that the file tells.
  LabelTable labels;
  /// The format and the way it is stored, for people: "NRRD, gzip".
  std::string format;
  /// What the file says and the reader dropped or took otherwise: a fourth dimension of size 1.
  std::vector<std::string> notes;

  /// Units: bytes of one slice.
  std::uint64_t slice_bytes() const {
    return std::uint64_t{dims[0]} * dims[1] * sample_bytes(type);
  }
};

/// The layout of a file that does not tell its own.
struct RawLayout {
  /// Units: voxels. Limit: as VolumeInfo.
  std::array<std::uint32_t, 3> dims{};
  SampleType type = SampleType::u8;
  bool big_endian = false;
  /// What stands before the samples. Units: bytes.
  std::uint64_t skipped_bytes = 0;
};

/// Voxels along an axis: from the first to the last, both of them too. The first voxel of a volume
/// is 0.
struct VoxelRange {
  std::uint32_t first = 0;
  std::optional<std::uint32_t> last = {};  ///< else the last one of the volume
};

/// A part of a volume, along x, y and z.
using Crop = std::array<VoxelRange, 3>;

/// What the voxel is that stands for a block of voxels.
enum class BlockValue { mean, most_frequent };

/// What is said of a volume beside its name.
struct VolumeOptions {
  /// The layout of headerless samples; nothing where the file has a header.
  std::optional<RawLayout> layout = {};
  /// Distances of voxels in place of those that the file tells; an axis that runs backwards keeps
  /// doing so. Units: millimetres. Limit: as VolumeInfo.
  std::optional<std::array<double, 3>> spacing_mm = {};
  /// Of DICOM: the UID of the series, or its number in the list that the refusal shows where there
  /// are several.
  std::string series = {};
  /// Whether slices that are missing in a folder are filled with the nearest ones, not refused.
  bool allow_gaps = false;
  /// Which of the volumes of a file, the first is 0. Without it, a file of several is refused.
  std::optional<std::uint32_t> frame = {};
  /// The part of the volume that is taken; otherwise all of it.
  std::optional<Crop> crop = {};
  /// Blocks of so many voxels along x, y and z become one voxel each, after the crop.
  /// Limit: 1 to 16.
  std::uint32_t shrink = 1;
  BlockValue block_value = BlockValue::mean;
};

/// One pass over a volume, first slice to last.
class VolumeReader {
 public:
  VolumeReader() = default;
  VolumeReader(const VolumeReader&) = delete;
  VolumeReader& operator=(const VolumeReader&) = delete;
  virtual ~VolumeReader() = default;

  /// Valid as long as the reader.
  virtual const VolumeInfo& info() const = 0;

  /// Writes the next slice, rows of x from y = 0, samples in native byte order.
  /// Size: info().slice_bytes(), owned by the caller.
  /// Throws VolumeError when the data ends early (the text says in which slice and how many bytes
  /// are missing), when compressed data is damaged, and after the last slice. What a failed call
  /// wrote has no meaning.
  virtual void read_slice(void* samples) = 0;
};

/// Whether the name is that of a volume, by its extension; headerless ones may have any name.
bool is_volume_name(const std::filesystem::path& file);

/// Whether the name is that of standard input ("-") or of a pipe: what can be opened once only.
bool is_read_once(const std::filesystem::path& file);

/// Whether bytes begin like a file of a format with a header, or of one that is packed; of volumes
/// that is, and streams never do. head: the first magic_bytes of them, fewer where there are no
/// more.
bool is_volume_head(std::string_view head);
constexpr std::size_t magic_bytes = 348;

/// Opens a volume: a file, a folder of DICOM or of pictures, files by a pattern with *, ? or [...],
/// a pipe, or standard input by the name "-". With a layout the file is taken as headerless
/// samples, inflated first when its name ends in .gz, and must hold the volume and nothing else;
/// without one the format follows from the name, or else from the first bytes, inflated first where
/// they are gzip. Throws VolumeError when the file cannot be opened, is in no known format, or
/// holds what the command does not take. Nothing is allocated that depends on the sizes a file
/// claims, and a file too short for its first slice is refused here.
std::unique_ptr<VolumeReader> open_volume(const std::filesystem::path& file,
                                          const VolumeOptions& options = {});

/// The iso value, less what decimal numbers may have lost when they were rounded on their way here:
/// what is not below this reaches iso.
double lowered_by_rounding(const VolumeInfo& info, double iso);

/// The threshold on stored samples that stands for an iso value in the file's declared units:
/// stored >= threshold exactly where value >= iso. Values that differ from iso by no more than the
/// rounding of the decimal numbers involved count as equal, so iso 0.9 at slope 0.3 is 3, not 4.
/// Saturates: INT32_MIN when every value reaches iso, INT32_MAX when none does (or iso is NaN).
/// Of samples that are not whole numbers it is the first whole one.
std::int32_t stored_threshold(const VolumeInfo& info, double iso);

}  // namespace discmc::host

#endif

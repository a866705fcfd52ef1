// A volume as it is read, wherever its slices come from.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_READER_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "label_description.hpp"
#include "sample_type.hpp"
#include "volume_placement.hpp"

namespace discmc::command {

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
  /// The number of samples that the file holds of a voxel, of which this is one: colours, stains.
  std::uint64_t channels = 1;
  /// Distance between neighbouring voxels along x, y and z, negative where the axis runs backwards.
  /// An oblique left-handed volume has a negative z, so that no shape is ever mirrored, and the
  /// placement only turns and moves it.
  /// Units: millimetres. Limit: min_spacing_mm to max_spacing_mm either way.
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

  /// Goes past the next slice, without reading it where the file allows. Throws as read_slice(), of
  /// what it comes by.
  virtual void skip_slice() {
    std::vector<std::uint8_t> dropped(info().slice_bytes());
    read_slice(dropped.data());
  }
};

/// The iso value, less what decimal numbers may have lost when they were rounded on their way here:
/// what is not below this reaches iso.
double lowered_by_rounding(const VolumeInfo& info, double iso);

/// The threshold on stored samples that stands for an iso value in the file's declared units:
/// stored >= threshold exactly where value >= iso. Values that differ from iso by no more than the
/// rounding of the decimal numbers involved count as equal, so iso 0.9 at slope 0.3 is 3, not 4.
/// Saturates: INT32_MIN when every value reaches iso, INT32_MAX when none does (or iso is NaN).
/// Of samples that are not whole numbers it is the first whole one.
std::int32_t stored_threshold(const VolumeInfo& info, double iso);

}  // namespace discmc::command

#endif

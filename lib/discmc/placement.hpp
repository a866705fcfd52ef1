// Where a volume lies in space: a standard application record, for whoever lays its surface over
// others.
#ifndef DISCMC_PLACEMENT_HPP
#define DISCMC_PLACEMENT_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// What the axes of space are. Of a patient, as medical formats have them.
enum class Frame : uint8_t {
  none,  ///< the scanner's own
  lps,   ///< towards the left, the back (posterior) and the head (superior), as in DICOM
  ras,   ///< towards the right, the front (anterior) and the head, as in NIfTI
};

/// From voxels to space: voxel (i, j, k) has its centre at origin + i axes[0] + j axes[1] +
/// k axes[2]; so a vertex (x, y, z), in half-steps, lies at origin + (x axes[0] + y axes[1] +
/// z axes[2]) / 2. It says where the volume is: the spacing in the header, which normals are made
/// with, stays what it is. Units: nanometres.
struct Placement {
  int32_t axes_nm[3][3] = {};  ///< of one voxel to the next along x, y, z: their x, y, z in space
  int64_t origin_nm[3] = {};   ///< the centre of voxel (0, 0, 0)
  Frame frame = Frame::none;

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind;
  static constexpr size_t record_bytes = 3 * 3 * 4 + 3 * 8 + 1;
};

/// The record of a placement, for write_record(): best before the first row. bytes: room for
/// Placement::record_bytes, which are written; Owner: the caller, until the record has been told.
ApplicationRecord record_of(const Placement& placement, uint8_t* bytes);

/// Reads the placement in a record. False, and nothing is written, where it holds none: the kind is
/// another, or the number of bytes, or the frame is not known.
[[nodiscard]] bool read_placement(const ApplicationRecord& record, Placement& placement);

// ---- Which slices of a volume a stream holds: a standard application record, for whoever joins
// the streams of slabs.

/// The own slices of a slab, without those of its neighbours that its extractor was given as well.
/// A stream that was joined of several slabs has a record for each range of theirs; one of a whole
/// volume has none. Units: slices.
struct SlabRange {
  uint32_t first = 0;
  uint32_t slices = 0;
  uint32_t depth = 0;  ///< of the volume; Limit: at least first + slices

  /// The slice after the last one.
  constexpr uint32_t end() const { return first + slices; }

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind + 1;
  static constexpr size_t record_bytes = 12;
};

/// The record of a slab, for write_record(), at any time in its scan. bytes: room for
/// SlabRange::record_bytes, which are written; Owner: the caller, until the record has been told.
ApplicationRecord record_of(const SlabRange& range, uint8_t* bytes);

/// Reads the range in a record. False, and nothing is written, where it holds none: the kind is
/// another, or the number of bytes, or the slices are none, or beyond the depth.
[[nodiscard]] bool read_slab_range(const ApplicationRecord& record, SlabRange& range);

}  // namespace discmc

#endif

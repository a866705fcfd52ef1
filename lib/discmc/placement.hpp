// Standard application records. A Placement is the position of a volume in space, for receivers
// that align the surface with other data. A SlabRange has the own slices of a slab, for receivers
// that join the streams of slabs.
//
//   uint8_t bytes[Placement::record_bytes];
//   status = encoder.write_record(record_of(placement, bytes));  // before the first row
//
//   if (read_placement(*event.application, placement)) ...       // in the sink of a receiver
#ifndef DISCMC_PLACEMENT_HPP
#define DISCMC_PLACEMENT_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// The directions in which the axes of space point.
enum class Space : uint8_t {
  scanner,  ///< the scanner's own
  lps,      ///< x to the left, y to the back, z to the head of the patient, as in DICOM
  ras,      ///< x to the right, y to the front, z to the head, as in NIfTI
};

/// The transform from voxels to space:
///
///   voxel (i, j, k)                  origin_nm + i axes_nm[0] + j axes_nm[1] + k axes_nm[2]
///   vertex (x, y, z) in half-steps   origin_nm + (x axes_nm[0] + y axes_nm[1] + z axes_nm[2]) / 2
///
/// Normals use the spacing of the stream's header instead. Units: nanometres.
struct Placement {
  int32_t axes_nm[3][3] = {};  ///< from one voxel to the next along x, y, z: three vectors in space
  int64_t origin_nm[3] = {};   ///< the centre of voxel (0, 0, 0)
  Space space = Space::scanner;

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind;
  static constexpr size_t record_bytes = 3 * 3 * 4 + 3 * 8 + 1;
};

/// Encodes a placement for write_record(), best before the first row: slice and row of the record
/// are 0. bytes: room for Placement::record_bytes, which it writes; Owner: the caller, until
/// write_record() has returned ok.
ApplicationRecord record_of(const Placement& placement, uint8_t* bytes);

/// Reads the placement in a record. Returns false, and writes nothing, if the kind, the number of
/// bytes or the space does not match.
[[nodiscard]] bool read_placement(const ApplicationRecord& record, Placement& placement);

// ---- The slices of a slab.

/// The own slices of a slab, without the context slices of its neighbours. A stream joined from
/// several slabs has a record for each of their ranges; the stream of a whole volume has none.
/// Units: slices.
struct SlabRange {
  uint32_t first = 0;
  uint32_t slices = 0;
  uint32_t depth = 0;  ///< of the volume; Limit: at least first + slices

  /// The slice after the last one.
  constexpr uint32_t end() const { return first + slices; }

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind + 1;
  static constexpr size_t record_bytes = 12;
};

/// Encodes a slab range for write_record(), at any time in its scan. Slice and row of the record
/// are 0; for an Encoder, set both if the first row has been pushed. bytes: room for
/// SlabRange::record_bytes, which it writes; Owner: the caller, until write_record() has returned
/// ok.
ApplicationRecord record_of(const SlabRange& range, uint8_t* bytes);

/// Reads the range in a record. Returns false, and writes nothing, if the kind or the number of
/// bytes does not match, or if the slices are none or beyond the depth.
[[nodiscard]] bool read_slab_range(const ApplicationRecord& record, SlabRange& range);

}  // namespace discmc

#endif

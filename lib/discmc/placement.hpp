// Standard application records. A Placement gives the position of a volume in space, so that a
// receiver can align the surface with other data. A SlabRange gives the slices of one slab, so that
// a receiver that joins slabs detects missing ones.
//
//   uint8_t bytes[Placement::record_bytes];
//   // after start() of encoder and extractor, before the first row:
//   status = encoder.write_record(record_of(placement, bytes));
//
//   if (read_placement(*event.application, placement)) ...       // in the sink of a receiver
#ifndef DISCMC_PLACEMENT_HPP
#define DISCMC_PLACEMENT_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// The coordinate system of a Placement: where its x, y and z axes point.
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
/// The normals of a stream are corrected for the spacing in its header. Their component n points
/// along voxel axis n, or against it if spacing_nm[n] of the header is negative. In space, the
/// normal (x, y, z) is x d[0] + y d[1] + z d[2]. Here d[n] is axes_nm[n] scaled to length 1,
/// negated if spacing_nm[n] is negative. Limit of this formula: the axes are perpendicular. Units:
/// nanometres.
struct Placement {
  int32_t axes_nm[3][3] = {};  ///< from one voxel to the next along x, y, z: three vectors in space
  int64_t origin_nm[3] = {};   ///< the centre of voxel (0, 0, 0)
  Space space = Space::scanner;

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind;
  static constexpr size_t record_bytes = 3 * 3 * 4 + 3 * 8 + 1;
};

/// Encodes a placement for write_record(). The record has slice 0 and row 0, so write it before the
/// first row, but after the start of the scan. bytes: a buffer of Placement::record_bytes bytes,
/// overwritten; Owner: the caller, until write_record() has returned ok.
ApplicationRecord record_of(const Placement& placement, uint8_t* bytes);

/// Reads the placement in a record. Returns false, and writes nothing, if the kind or the number of
/// bytes does not match, or if the space is unknown.
[[nodiscard]] bool read_placement(const ApplicationRecord& record, Placement& placement);

// ---- The slices of a slab.

/// The slices of a slab (Slab in limits.hpp) without its context slices. A stream joined from
/// several slabs has one record per slab; the stream of a whole volume needs none. Units: slices.
struct SlabRange {
  uint32_t first = 0;
  uint32_t slices = 0;
  uint32_t depth = 0;  ///< of the volume; Limit: at least first + slices

  /// The slice after the last one.
  constexpr uint32_t end() const { return first + slices; }

  static constexpr uint8_t record_kind = ApplicationRecord::first_standard_kind + 1;
  static constexpr size_t record_bytes = 12;
};

/// Encodes a slab range for write_record(), at any time in the scan. The record has slice 0 and row
/// 0. A SliceEncoder replaces both; for an Encoder, set both if rows have been pushed. bytes: a
/// buffer of SlabRange::record_bytes bytes, overwritten; Owner: the caller, until write_record()
/// has returned ok.
ApplicationRecord record_of(const SlabRange& range, uint8_t* bytes);

/// Reads the range in a record. Returns false, and writes nothing, if the kind or number of bytes
/// does not match, if `slices` is 0, or first + slices exceeds `depth`.
[[nodiscard]] bool read_slab_range(const ApplicationRecord& record, SlabRange& range);

}  // namespace discmc

#endif

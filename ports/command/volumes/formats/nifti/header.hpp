// The headers of NIfTI-1, NIfTI-2 and Analyze 7.5, and the names of labels behind them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "meshing.hpp"
#include "samples/sample_type.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

/// Offsets of the fields of NIfTI-2.
namespace nifti2 {
inline constexpr std::size_t magic = 4, datatype = 12, bitpix = 14, dim = 16, pixdim = 104,
                             vox_offset = 168, slope = 176, intercept = 184, qform_code = 344,
                             sform_code = 348, quaternion = 352, qoffset = 376, srow = 400,
                             units = 500;
inline constexpr std::size_t bytes = 540;
}  // namespace nifti2

/// Units of lengths. The other bits of the field are a unit of time.
enum class NiftiUnit { none = 0, metre = 1, millimetre = 2, micrometre = 3 };

/// The common fields of all versions, with the names of the standard.
struct NiftiHeader {
  std::string format;
  bool is_one_file = false;
  bool is_big_endian = false;
  int datatype = 0;
  std::array<std::int64_t, 8> dim{};
  std::array<double, 8> pixdim{};
  std::int64_t vox_offset = 0;
  double scl_slope = 0, scl_inter = 0;
  NiftiUnit unit = NiftiUnit::none;
  int qform_code = 0, sform_code = 0;
  std::array<double, 3> quatern{};  ///< b, c and d
  std::array<double, 3> qoffset{};
  std::array<std::array<double, 4>, 3> srow{};
  std::array<int, 3> originator{};  ///< SPM's origin in Analyze, a voxel counted from 1

  bool is_analyze() const { return format == "Analyze 7.5"; }
};

/// Reads a header of any version and byte order. Throws VolumeError.
NiftiHeader read_nifti_header(ByteStream& stream);

/// Returns the matrix of the qform, in the form of srow.
std::array<std::array<double, 4>, 3> qform_of(const NiftiHeader& header);

/// Returns nothing if no sample type has this number.
std::optional<SampleType> type_of_nifti(int datatype);
std::int16_t nifti_type_of(SampleType type);

/// Reads the extensions behind a header, up to `end`, and adds their labels. They are written by
/// Connectome Workbench, Caret, and TotalSegmentator, which uses Caret's XML. Other extensions, and
/// those that do not fit, are ignored. stream: directly behind the header; afterwards at most at
/// the end. Units: bytes of the stream.
void read_label_extensions(ByteStream& stream, std::uint64_t end, bool is_big_endian,
                           VolumeInfo& info);

}  // namespace discmc::command

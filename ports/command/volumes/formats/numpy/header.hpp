// The header of a file of NumPy.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "meshing.hpp"
#include "samples/sample_type.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

struct NumpyHeader {
  std::string type;  ///< NumPy's name: "<u2"
  ArrayShape shape;
};

/// Returns the volume of the array in a stream. format: for people.
std::unique_ptr<VolumeReader> numpy_volume(ByteStream stream, const std::string& format,
                                           const VolumeOptions& options);

/// Reads up to the first sample. Throws VolumeError.
NumpyHeader read_numpy_header(ByteStream& stream);

/// The sample type of a NumPy type with one number per sample. 16-bit floating point is read as 32
/// bits.
struct NumpyType {
  SampleType type = SampleType::u8;
  bool is_big_endian = false;
  bool is_half = false;
};
std::optional<NumpyType> numpy_type(std::string_view name);

}  // namespace discmc::command

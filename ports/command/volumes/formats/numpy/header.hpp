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
  std::string type;  ///< as NumPy has it: "<u2"
  ArrayShape shape;
};

/// The array that a stream holds. format: for people.
std::unique_ptr<VolumeReader> numpy_volume(ByteStream stream, const std::string& format,
                                           const VolumeOptions& options);

/// Reads up to the first sample. Throws VolumeError.
NumpyHeader read_numpy_header(ByteStream& stream);

/// The type of samples of which each is one number; floating point of 16 bits is read as that of
/// 32.
struct NumpyType {
  SampleType type = SampleType::u8;
  bool is_big_endian = false;
  bool is_half = false;
};
std::optional<NumpyType> numpy_type(std::string_view name);

}  // namespace discmc::command

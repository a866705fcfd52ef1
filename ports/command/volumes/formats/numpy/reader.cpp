// Arrays of NumPy, .npy: the file does not name its axes.
#include <utility>

#include "header.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {

std::unique_ptr<VolumeReader> numpy_volume(ByteStream stream, const std::string& format,
                                           const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const NumpyHeader header = read_numpy_header(stream);
  const auto type = numpy_type(header.type);
  if (!type) fail_type(file, header.type);
  VolumeInfo info;
  info.format = format;
  info.type = type->type;
  const ArrayLayout layout = take_array(info, file, header.shape, options);
  set_place(info, {}, options);
  bool big_endian = type->big_endian;
  if (type->is_half) {
    stream.decode([big_endian](auto in) { return floats_of_halves(std::move(in), big_endian); });
    big_endian = is_native_big_endian();
  }
  return array_volume(std::move(info), std::move(stream), layout, big_endian);
}

std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options) {
  return numpy_volume(std::move(stream), "NumPy", options);
}

}  // namespace discmc::command

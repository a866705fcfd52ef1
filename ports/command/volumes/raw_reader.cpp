#include <utility>

#include "volume_format.hpp"

namespace discmc::host {

std::unique_ptr<VolumeReader> open_raw(const std::filesystem::path& file, const RawLayout& layout) {
  ByteStream stream(file);
  VolumeInfo info;
  info.type = layout.type;
  info.format = "raw";
  set_dims(info, file, {layout.dims[0], layout.dims[1], layout.dims[2]});
  if (lower(file.extension().string()) == ".gz") {
    info.format += ", gzip";
    stream.start_inflate();
  }
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), layout.big_endian);
}

}  // namespace discmc::host

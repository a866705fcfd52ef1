// Headerless samples. The layout is the user's word, so the file must agree with it: what has a
// header would otherwise be read as voxels.
#include <utility>

#include "volume_format.hpp"

namespace discmc::host {
namespace {

void require_no_header(ByteStream& stream) {
  if (const auto format = format_of_magic(stream))
    fail(stream.file(), "this begins like " + std::string(*format) + ", not like samples",
         "leave out --dims and --type, or skip its header with --skip-bytes");
}

// As far as the length is known: of compressed samples and of pipes at their end.
void require_length(const ByteStream& stream, const VolumeInfo& info, const RawLayout& layout) {
  const auto left = stream.left();
  const std::uint64_t volume = info.slice_bytes() * info.dims[2];
  if (!left || *left == volume) return;
  std::string what = "the file has " + std::to_string(*left) + " bytes";
  if (layout.skipped_bytes > 0)
    what += " behind the " + std::to_string(layout.skipped_bytes) + " skipped";
  what += ", but a volume of " + extents(info.dims) + " " + std::string(name(info.type)) + " has " +
          std::to_string(volume);
  fail(stream.file(), what,
       *left < volume ? std::string("correct --dims and --type, or copy the file again")
                      : "correct --dims and --type, or skip a header with --skip-bytes " +
                            std::to_string(layout.skipped_bytes + *left - volume));
}

}  // namespace

std::unique_ptr<VolumeReader> open_raw(ByteStream stream, const RawLayout& layout) {
  VolumeInfo info;
  info.type = layout.type;
  info.format = "raw";
  set_dims(info, stream.file(), {layout.dims[0], layout.dims[1], layout.dims[2]}, {});
  if (lower(stream.file().extension().string()) == ".gz") {
    info.format += ", gzip";
    stream.decode(inflated);
  }
  if (layout.skipped_bytes == 0) require_no_header(stream);
  stream.skip(layout.skipped_bytes);
  require_length(stream, info, layout);
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), layout.big_endian,
                                       Behind::nothing);
}

}  // namespace discmc::host

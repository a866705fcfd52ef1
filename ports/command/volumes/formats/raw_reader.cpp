// Headerless samples. The user gives the layout, so the file must have exactly its size. Otherwise
// a header would be read as voxels.
#include <optional>
#include <string>
#include <utility>

#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/format_list.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

void require_no_header(ByteStream& stream) {
  const std::string_view head = stream.peek(magic_bytes);
  const VolumeFormat* const format = format_of_head(head);
  const auto packing = packing_of(head);
  if (format != nullptr || packing)
    fail(stream.file(),
         "this begins like " + std::string(format != nullptr ? format->name : name(*packing)) +
             ", not like samples",
         "leave out --dims and --type, or skip its header with --skip-bytes");
}

// Suggests another layout for the number of bytes in the file.
std::optional<std::string> proposal(const VolumeInfo& info, std::uint64_t bytes) {
  const std::uint64_t slice = info.slice_bytes();
  const std::uint64_t voxels = slice / sample_bytes(info.type) * info.dims[2];
  std::string types;
  for (const auto& [called, type] : sample_types)
    if (voxels * sample_bytes(type) == bytes)
      types += (types.empty() ? "" : " or ") + std::string(called);
  if (!types.empty()) return "give --type " + types + ", which fits the length";
  if (bytes == 0 || bytes % slice != 0) return std::nullopt;
  return "give --dims " + std::to_string(info.dims[0]) + ',' + std::to_string(info.dims[1]) + ',' +
         std::to_string(bytes / slice) + ", which fits the length";
}

// Checks the length if it is known. Compressed samples and pipes are checked at their end.
void require_length(const ByteStream& stream, const VolumeInfo& info, const RawLayout& layout) {
  const auto left = stream.left();
  const std::uint64_t volume = volume_bytes(info);
  if (!left || *left == volume) return;
  std::string what = "the file has " + std::to_string(*left) + " bytes";
  if (layout.skipped_bytes > 0)
    what += " after the " + std::to_string(layout.skipped_bytes) + " skipped";
  what += ", but a volume of " + extents(info.dims) + " " + std::string(name(info.type)) + " has " +
          std::to_string(volume);
  const std::string correct = proposal(info, *left).value_or("correct --dims and --type");
  fail(stream.file(), what,
       correct + (*left < volume ? ", or copy the file again"
                                 : ", or skip a header with --skip-bytes " +
                                       std::to_string(layout.skipped_bytes + *left - volume)));
}

NoteOfRest refusal_of_rest(const VolumeInfo& info) {
  return [bytes = volume_bytes(info)](ByteStream& stream) {
    if (!stream.peek(1).empty())
      fail(stream.file(),
           "the input is longer than the " + std::to_string(bytes) + " bytes of the volume",
           "correct --dims and --type, or skip a header with --skip-bytes");
    return std::string();
  };
}

}  // namespace

std::unique_ptr<VolumeReader> open_raw(ByteStream stream, const VolumeOptions& options) {
  const RawLayout& layout = *options.layout;
  VolumeInfo info;
  info.type = layout.type;
  info.format = "raw";
  set_dims(info, stream.file(), {layout.dims[0], layout.dims[1], layout.dims[2]});
  set_place(info, {}, options);
  if (const auto packing = packing_of_name(stream.file())) stream.unpack(*packing);
  if (layout.skipped_bytes == 0) require_no_header(stream);
  stream.skip(layout.skipped_bytes);
  require_length(stream, info, layout);
  NoteOfRest no_rest = refusal_of_rest(info);
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), layout.is_big_endian,
                                       std::nullopt, std::move(no_rest));
}

}  // namespace discmc::command

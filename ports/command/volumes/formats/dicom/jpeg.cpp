#include "decoders.hpp"

#include <limits>
#include <optional>

#include "toolkit.hpp"

#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

namespace discmc::command {
namespace {

struct Header {
  std::uint32_t components;
  PictureSize size;
};

bool is_frame_header(std::uint8_t marker) {
  constexpr std::uint8_t of_jpeg_ls = 0xf7, huffman_tables = 0xc4, reserved = 0xc8,
                         arithmetic_tables = 0xcc;
  return marker == of_jpeg_ls || (marker >= 0xc0 && marker <= 0xcf && marker != huffman_tables &&
                                  marker != reserved && marker != arithmetic_tables);
}

// Returns nothing if samples precede a header, or if no header is complete.
std::optional<Header> header(const std::vector<std::uint8_t>& bytes) {
  const auto number = [&bytes](std::size_t at) {
    return static_cast<std::uint32_t>(bytes[at] << 8 | bytes[at + 1]);
  };
  constexpr std::uint8_t start_of_samples = 0xda;
  constexpr std::size_t start_bytes = 2, frame_header_bytes = 10;
  for (std::size_t at = start_bytes;
       at + frame_header_bytes <= bytes.size() && bytes[at] == 0xff;) {
    const std::uint8_t marker = bytes[at + 1];
    if (marker == start_of_samples) break;
    if (is_frame_header(marker))
      return Header{bytes[at + 9], {number(at + 7), number(at + 5), (bytes[at + 4] + 7U) / 8}};
    // A marker may be preceded by fill bytes equal to its first byte.
    at += marker == 0xff ? 1 : 2 + number(at + 2);
  }
  return std::nullopt;
}

std::string text(PictureSize size) {
  return std::to_string(size.columns) + " x " + std::to_string(size.rows) + " samples of " +
         std::to_string(8 * size.sample_bytes) + " bits";
}

// DCMTK compares the size only for JPEG-LS, and leaves the rest of a smaller picture unset.
std::string mismatch(const std::vector<std::uint8_t>& bytes, PictureSize size) {
  const std::optional<Header> found = header(bytes);
  if (!found) return "the JPEG data has no header";
  if (found->components != 1)
    return "the JPEG picture has " + std::to_string(found->components) + " components; expected 1";
  const PictureSize its = found->size;
  if (its.columns != size.columns || its.rows != size.rows || its.sample_bytes != size.sample_bytes)
    return "the JPEG picture has " + text(its) + "; expected " + text(size);
  return {};
}

// Inserts the only fragment of a frame, after an empty table of offsets.
void insert(DcmPixelSequence& sequence, const std::vector<std::uint8_t>& bytes) {
  sequence.insert(new DcmPixelItem(DCM_PixelItemTag));
  auto* const fragment = new DcmPixelItem(DCM_PixelItemTag);
  fragment->putUint8Array(bytes.data(), bytes.size());
  sequence.insert(fragment);
}

}  // namespace

std::string decode_jpeg(const std::vector<std::uint8_t>& bytes, PictureSize size,
                        DcmDataset& dataset, unsigned char* samples) {
  const std::string fault = mismatch(bytes, size);
  if (!fault.empty()) return fault;
  const std::uint64_t count = std::uint64_t{size.columns} * size.rows * size.sample_bytes;
  if (count > std::numeric_limits<Uint32>::max())
    return "the JPEG picture has " + std::to_string(count) + " bytes; at most 4 GiB are supported";
  DcmPixelSequence sequence(DCM_PixelSequenceTag);
  insert(sequence, bytes);
  // Decodes the picture as the last frame, which extends to the last fragment.
  const Uint32 last = frame_count(dataset) - 1;
  Uint32 fragment = 1;
  OFString color_model;
  const OFCondition result =
      DcmCodecList::decodeFrame(DcmXfer(dataset.getOriginalXfer()), nullptr, &sequence, &dataset,
                                last, fragment, samples, static_cast<Uint32>(count), color_model);
  if (result.good()) return {};
  return std::string("the pixel data cannot be decoded (") + result.text() + ")";
}

}  // namespace discmc::command

#include "decoders.hpp"

#include <algorithm>

#include "toolkit.hpp"

#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

#include "volumes/byte_source.hpp"

namespace discmc::command {

DicomFragments::DicomFragments(DcmPixelSequence& sequence, std::uint32_t frames) {
  DcmObject* item = nullptr;
  while ((item = sequence.nextInContainer(item)) != nullptr)
    if (auto* const fragment = dynamic_cast<DcmPixelItem*>(item)) items_.push_back(fragment);
  const std::size_t count = items_.size() - std::min<std::size_t>(items_.size(), 1);
  if (count < frames) return;
  if (frames == 1)
    starts_ = {1, items_.size()};
  else if (count == frames)
    for (std::size_t i = 1; i <= items_.size(); ++i) starts_.push_back(i);
  else
    set_starts_by_table(frames);
  if (starts_.empty()) set_starts_by_jpeg(frames);
}

void DicomFragments::set_starts_by_table(std::uint32_t frames) {
  constexpr std::size_t header_bytes = 8, entry_bytes = 4;
  const std::uint8_t* const table = content(0);
  if (table == nullptr || items_[0]->getLength() != entry_bytes * frames) return;
  std::vector<std::uint64_t> offsets = {0};  // of items_, except the first
  for (std::size_t i = 1; i < items_.size(); ++i)
    offsets.push_back(offsets.back() + header_bytes + items_[i]->getLength());
  std::vector<std::size_t> starts;
  for (const std::uint8_t* at = table; at < table + entry_bytes * frames; at += entry_bytes) {
    const std::uint64_t offset = whole_of(at, entry_bytes, false);
    const auto place = std::lower_bound(offsets.begin(), offsets.end(), offset);
    if (place == offsets.end() || *place != offset) return;
    starts.push_back(1 + static_cast<std::size_t>(place - offsets.begin()));
  }
  starts.push_back(items_.size());
  starts_ = std::move(starts);
}

// The two bytes at the start of a JPEG picture appear nowhere else in its samples.
void DicomFragments::set_starts_by_jpeg(std::uint32_t frames) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 1; i < items_.size(); ++i) {
    const std::uint8_t* const bytes = content(i);
    if (bytes != nullptr && items_[i]->getLength() >= 2 && bytes[0] == 0xff && bytes[1] == 0xd8)
      starts.push_back(i);
    items_[i]->compact();
  }
  if (starts.size() < frames) return;
  left_out_ = starts.size() - frames;
  starts.push_back(items_.size());
  starts.resize(frames + std::size_t{1});
  starts_ = std::move(starts);
}

const std::uint8_t* DicomFragments::content(std::size_t fragment) {
  Uint8* bytes = nullptr;
  return items_[fragment]->getUint8Array(bytes).good() ? bytes : nullptr;
}

std::string DicomFragments::read(std::uint32_t frame, std::vector<std::uint8_t>& bytes) {
  if (frame + std::size_t{1} >= starts_.size())
    return "its part of the compressed pixel data is unknown";
  if (starts_[frame] >= starts_[frame + 1]) return "the offsets of frames are not in order";
  bytes.clear();
  for (std::size_t i = starts_[frame]; i < starts_[frame + 1]; ++i) {
    const std::size_t count = items_[i]->getLength();
    if (count == 0) return "fragment " + std::to_string(i) + " of the pixel data is empty";
    const std::uint8_t* const part = content(i);
    if (part == nullptr) return "the compressed pixel data ends early";
    bytes.insert(bytes.end(), part, part + count);
    // Releases the memory of the fragment.
    items_[i]->compact();
  }
  return {};
}

}  // namespace discmc::command

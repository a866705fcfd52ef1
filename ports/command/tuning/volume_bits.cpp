#include "volume_bits.hpp"

#include <bitset>
#include <numeric>
#include <optional>

#include "extraction/bit_source.hpp"
#include "extraction/mask_bits.hpp"

namespace discmc::command {
namespace {

template <class Iterator>
std::uint64_t count_on(Iterator begin, Iterator end) {
  return std::accumulate(begin, end, std::uint64_t{0}, [](std::uint64_t sum, std::uint8_t byte) {
    return sum + std::bitset<8>(byte).count();
  });
}

}  // namespace

VolumeBits::VolumeBits(VolumeReader& volume, const ExtractionOptions& options)
    : limits_{volume.info().dims[0], volume.info().dims[1], options.border},
      header_(stream_header(volume.info(), options)),
      // A scanner's converter has 8 or up to 16 bits, even if the file has more.
      sample_bytes_(command::sample_bytes(volume.info().type) == 1 ? 1 : 2),
      is_floating_(command::is_floating(volume.info().type)),
      row_bytes_(bit_row_bytes(limits_.width)) {
  const SlabSpans all = slab_spans({0, slices()}, slices(), options.filters_by_majority);
  BitSource source(volume.info(), limits_, all, options.filters_by_majority,
                   {{options.selection, {}}});
  bits_.reserve(row_bytes_ * limits_.height * slices());
  const std::size_t slice_bytes = row_bytes_ * limits_.height;
  const auto keep = [&](const std::uint8_t* row) {
    bits_.insert(bits_.end(), row, row + row_bytes_);
    if (bits_.size() % slice_bytes == 0)
      on_.push_back(on_.back() +
                    count_on(bits_.end() - static_cast<std::ptrdiff_t>(slice_bytes), bits_.end()));
  };
  std::optional<MaskBits> mask;
  if (options.mask != nullptr) mask.emplace(*options.mask);
  std::vector<std::uint8_t> slice(volume.info().slice_bytes());
  for (std::uint32_t z = 0; z < slices(); ++z) {
    volume.read_slice(slice.data());
    source.add_slice(slice.data(), mask ? mask->next_slice() : nullptr, keep);
    if (options.progress) options.progress(z + 1);
  }
  source.finish(keep);
  is_full_ = source.is_full(0);
}

}  // namespace discmc::command

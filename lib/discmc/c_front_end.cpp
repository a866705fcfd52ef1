// discmc.h in terms of the C++ library: what stands between a sensor and the extractor. A file of
// its own, so that firmware which needs none of it does not carry it.
#include <discmc/discmc.h>

#include <discmc/block_means.hpp>
#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/majority_filter.hpp>
#include <discmc/packed_samples.hpp>
#include <discmc/row_picker.hpp>
#include <discmc/row_ring.hpp>
#include <discmc/threshold_row.hpp>

namespace discmc {

namespace {

static_assert(fits<RowRing, discmc_row_ring> && fits<RowPicker, discmc_row_picker> &&
                  fits<BlockMeans<uint8_t>, discmc_block_means> &&
                  fits<BlockMeans<uint16_t>, discmc_block_means> &&
                  fits<BlockMeans<int16_t>, discmc_block_means> &&
                  fits<MajorityFilter, discmc_majority_filter>,
              "the sizes in discmc.h are enough and not much more");
static_assert(DISCMC_NEXT_END == static_cast<int>(RowRing::Next::end) &&
                  DISCMC_MONO12_PACKED == static_cast<int>(Packing::mono12_packed),
              "enumerations are in the same order");
static_assert(DISCMC_REST == PickedRange::rest &&
                  DISCMC_MAX_BLOCK_EXTENT == BlockMeans<uint8_t>::max_extent &&
                  DISCMC_ROW_RING_BYTES_FOR(37, 5) == RowRing::bytes_for(37, 5) &&
                  DISCMC_MAJORITY_FILTER_BYTES_FOR(33, 7) == MajorityFilter::bytes_for({33, 7}) &&
                  DISCMC_BLOCK_MEANS_BYTES_FOR(33, 7, 2, 1) ==
                      BlockMeans<uint8_t>::bytes_for({33, 7}, 2) &&
                  DISCMC_BLOCK_MEANS_BYTES_FOR(33, 7, 3, 2) ==
                      BlockMeans<int16_t>::bytes_for({33, 7}, 3),
              "constants are the same");

RowRing& cpp(discmc_row_ring* ring) {
  return *reinterpret_cast<RowRing*>(ring);
}
const RowRing& cpp(const discmc_row_ring* ring) {
  return *reinterpret_cast<const RowRing*>(ring);
}
RowPicker& cpp(discmc_row_picker* picker) {
  return *reinterpret_cast<RowPicker*>(picker);
}
const RowPicker& cpp(const discmc_row_picker* picker) {
  return *reinterpret_cast<const RowPicker*>(picker);
}
MajorityFilter& cpp(discmc_majority_filter* filter) {
  return *reinterpret_cast<MajorityFilter*>(filter);
}
template <class Sample>
BlockMeans<Sample>& means_of(discmc_block_means* means) {
  return *reinterpret_cast<BlockMeans<Sample>*>(means);
}

PickedRange cpp(const discmc_picked_range& from) {
  return {from.first, from.count, from.step};
}

}  // namespace

extern "C" {

uint64_t discmc_row_ring_bytes_for(uint32_t row_bytes, uint32_t rows) {
  return RowRing::bytes_for(row_bytes, rows);
}
discmc_status discmc_row_ring_start(discmc_row_ring* ring, uint32_t row_bytes, uint32_t rows,
                                    discmc_memory memory) {
  return c(cpp(ring).start(row_bytes, rows, cpp(memory)));
}
void* discmc_row_ring_free_row(const discmc_row_ring* ring, uint32_t ahead) {
  return cpp(ring).free_row(ahead);
}
void discmc_row_ring_fill(discmc_row_ring* ring) {
  cpp(ring).fill();
}
void discmc_row_ring_lose(discmc_row_ring* ring, uint32_t rows) {
  cpp(ring).lose(rows);
}
void discmc_row_ring_end(discmc_row_ring* ring) {
  cpp(ring).end();
}
uint32_t discmc_row_ring_came(const discmc_row_ring* ring) {
  return cpp(ring).came();
}
uint8_t discmc_row_ring_next(const discmc_row_ring* ring) {
  return static_cast<uint8_t>(cpp(ring).next());
}
void* discmc_row_ring_row(const discmc_row_ring* ring) {
  return cpp(ring).row();
}
void discmc_row_ring_pass(discmc_row_ring* ring) {
  cpp(ring).pass();
}
uint32_t discmc_row_ring_passed(const discmc_row_ring* ring) {
  return cpp(ring).passed();
}
uint32_t discmc_row_ring_lost(const discmc_row_ring* ring) {
  return cpp(ring).lost();
}

uint32_t discmc_packed_bytes(uint8_t packing, uint32_t count) {
  return packed_bytes(static_cast<Packing>(packing), count);
}
void discmc_unpack(uint8_t packing, const uint8_t* packed, uint32_t count, uint16_t* samples) {
  unpack(static_cast<Packing>(packing), packed, count, samples);
}

void discmc_threshold_row_u8(const uint8_t* samples, uint32_t count, int32_t threshold,
                             uint8_t* bits, uint32_t stride) {
  threshold_row(samples, count, threshold, bits, stride);
}
void discmc_threshold_row_u16(const uint16_t* samples, uint32_t count, int32_t threshold,
                              uint8_t* bits, uint32_t stride) {
  threshold_row(samples, count, threshold, bits, stride);
}
void discmc_threshold_row_i16(const int16_t* samples, uint32_t count, int32_t threshold,
                              uint8_t* bits, uint32_t stride) {
  threshold_row(samples, count, threshold, bits, stride);
}
void discmc_threshold_row_less_u8(const uint8_t* samples, const int16_t* offsets, uint32_t count,
                                  int32_t threshold, uint8_t* bits) {
  threshold_row_less(samples, offsets, count, threshold, bits);
}
void discmc_threshold_row_less_u16(const uint16_t* samples, const int16_t* offsets, uint32_t count,
                                   int32_t threshold, uint8_t* bits) {
  threshold_row_less(samples, offsets, count, threshold, bits);
}
void discmc_threshold_row_less_i16(const int16_t* samples, const int16_t* offsets, uint32_t count,
                                   int32_t threshold, uint8_t* bits) {
  threshold_row_less(samples, offsets, count, threshold, bits);
}

discmc_status discmc_row_picker_start(discmc_row_picker* picker, const discmc_limits* incoming,
                                      const discmc_picked_range* axes) {
  return c(cpp(picker).start(cpp(*incoming), cpp(axes[0]), cpp(axes[1]), cpp(axes[2])));
}
discmc_limits discmc_row_picker_limits(const discmc_row_picker* picker) {
  return c(cpp(picker).limits());
}
uint8_t discmc_row_picker_next(discmc_row_picker* picker) {
  return cpp(picker).next() ? 1 : 0;
}
uint8_t discmc_row_picker_is_done(const discmc_row_picker* picker) {
  return cpp(picker).is_done() ? 1 : 0;
}
uint32_t discmc_row_picker_first(const discmc_row_picker* picker) {
  return cpp(picker).first();
}
uint32_t discmc_row_picker_count(const discmc_row_picker* picker) {
  return cpp(picker).count();
}
uint32_t discmc_row_picker_step(const discmc_row_picker* picker) {
  return cpp(picker).step();
}
void discmc_row_picker_pick_bits(const discmc_row_picker* picker, const uint8_t* bits,
                                 uint8_t* picked) {
  cpp(picker).pick_bits(bits, picked);
}

uint64_t discmc_block_means_bytes_for(const discmc_limits* incoming, uint32_t extent,
                                      uint32_t sample_bytes) {
  return sample_bytes == 1 ? BlockMeans<uint8_t>::bytes_for(cpp(*incoming), extent)
                           : BlockMeans<uint16_t>::bytes_for(cpp(*incoming), extent);
}
discmc_status discmc_block_means_start_u8(discmc_block_means* means, const discmc_limits* incoming,
                                          uint32_t extent, discmc_memory memory) {
  return c(means_of<uint8_t>(means).start(cpp(*incoming), extent, cpp(memory)));
}
discmc_status discmc_block_means_start_u16(discmc_block_means* means, const discmc_limits* incoming,
                                           uint32_t extent, discmc_memory memory) {
  return c(means_of<uint16_t>(means).start(cpp(*incoming), extent, cpp(memory)));
}
discmc_status discmc_block_means_start_i16(discmc_block_means* means, const discmc_limits* incoming,
                                           uint32_t extent, discmc_memory memory) {
  return c(means_of<int16_t>(means).start(cpp(*incoming), extent, cpp(memory)));
}
discmc_limits discmc_block_means_limits(const discmc_block_means* means) {
  return c(reinterpret_cast<const BlockMeans<uint8_t>*>(means)->limits());
}
const uint8_t* discmc_block_means_push_u8(discmc_block_means* means, const uint8_t* samples) {
  return means_of<uint8_t>(means).push(samples);
}
const uint16_t* discmc_block_means_push_u16(discmc_block_means* means, const uint16_t* samples) {
  return means_of<uint16_t>(means).push(samples);
}
const int16_t* discmc_block_means_push_i16(discmc_block_means* means, const int16_t* samples) {
  return means_of<int16_t>(means).push(samples);
}
const uint8_t* discmc_block_means_drain_u8(discmc_block_means* means) {
  return means_of<uint8_t>(means).drain();
}
const uint16_t* discmc_block_means_drain_u16(discmc_block_means* means) {
  return means_of<uint16_t>(means).drain();
}
const int16_t* discmc_block_means_drain_i16(discmc_block_means* means) {
  return means_of<int16_t>(means).drain();
}

uint64_t discmc_majority_filter_bytes_for(const discmc_limits* limits) {
  return MajorityFilter::bytes_for(cpp(*limits));
}
discmc_status discmc_majority_filter_start(discmc_majority_filter* filter,
                                           const discmc_limits* limits, discmc_memory memory) {
  return c(cpp(filter).start(cpp(*limits), cpp(memory)));
}
const uint8_t* discmc_majority_filter_push(discmc_majority_filter* filter, const uint8_t* bits) {
  return cpp(filter).push(bits);
}
const uint8_t* discmc_majority_filter_drain(discmc_majority_filter* filter) {
  return cpp(filter).drain();
}

}  // extern "C"

}  // namespace discmc

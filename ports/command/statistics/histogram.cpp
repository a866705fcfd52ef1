#include "histogram.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace discmc::command {
namespace {

constexpr unsigned slot_bits = 17;
constexpr std::size_t slot_count = std::size_t{1} << slot_bits;
static_assert(slot_count >= 2 * Histogram::max_bins, "half of the slots stay free");

template <std::size_t size>
using Bits = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t,
                       std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

template <class Sample>
constexpr Bits<sizeof(Sample)> sign_bit =
    static_cast<Bits<sizeof(Sample)>>(Bits<sizeof(Sample)>{1} << (8 * sizeof(Sample) - 1));

// Keys have the order of the samples. Magnitudes of IEEE 754 numbers have the order of their bits.
template <class Sample>
std::uint64_t key_of(Sample sample) {
  using Key = Bits<sizeof(Sample)>;
  if constexpr (std::is_floating_point_v<Sample>) {
    if (sample == Sample{0}) sample = Sample{0};  // makes -0 equal to 0
    Key bits = 0;
    std::memcpy(&bits, &sample, sizeof bits);
    return (bits & sign_bit<Sample>) != 0 ? static_cast<Key>(~bits) : bits | sign_bit<Sample>;
  } else if constexpr (std::is_signed_v<Sample>) {
    return static_cast<Key>(static_cast<Key>(sample) ^ sign_bit<Sample>);
  } else {
    return sample;
  }
}

template <class Sample>
Sample sample_with(std::uint64_t key) {
  using Key = Bits<sizeof(Sample)>;
  auto bits = static_cast<Key>(key);
  if constexpr (std::is_floating_point_v<Sample>)
    bits = (bits & sign_bit<Sample>) != 0 ? bits ^ sign_bit<Sample> : static_cast<Key>(~bits);
  else if constexpr (std::is_signed_v<Sample>)
    bits = static_cast<Key>(bits ^ sign_bit<Sample>);
  Sample sample{};
  std::memcpy(&sample, &bits, sizeof sample);
  return sample;
}

}  // namespace

Histogram::Histogram(SampleType type)
    : type_(type), slots_(slot_count), min_key_(std::numeric_limits<std::uint64_t>::max()) {}

void Histogram::add(const void* samples, std::size_t count) {
  with_sample_type(type_,
                   [&](auto type) { add_all(static_cast<const decltype(type)*>(samples), count); });
}

template <class Sample>
void Histogram::add_all(const Sample* samples, std::size_t count) {
  double sum = 0;  // of one call, to keep rounding small
  for (std::size_t i = 0; i < count; ++i) {
    const Sample sample = samples[i];
    if constexpr (std::is_floating_point_v<Sample>) {
      if (!std::isfinite(sample)) {
        ++(std::isnan(sample) ? not_numbers_ : infinite_);
        continue;
      }
    }
    sum += static_cast<double>(sample);
    if constexpr (std::is_same_v<Sample, double>) small_sum_ += small_unit * sample;
    add_key(key_of(sample));
  }
  sum_ += sum;
}

void Histogram::add_key(std::uint64_t key) {
  min_key_ = std::min(min_key_, key);
  max_key_ = std::max(max_key_, key);
  ++finite_;
  Slot* slot = &slot_of(key >> dropped_bits_);
  if (slot->count == 0) {
    while (used_ == max_bins) drop_a_bit();
    slot = &slot_of(key >> dropped_bits_);
    if (slot->count == 0) ++used_;
    slot->key = key >> dropped_bits_;
  }
  ++slot->count;
}

Histogram::Slot& Histogram::slot_of(std::uint64_t key) {
  constexpr std::uint64_t golden_ratio = 0x9E3779B97F4A7C15;  // Knuth's multiplicative hashing
  std::uint64_t place = key * golden_ratio >> (64 - slot_bits);
  while (slots_[place].count != 0 && slots_[place].key != key) place = (place + 1) % slot_count;
  return slots_[place];
}

void Histogram::drop_a_bit() {
  std::vector<Slot> before(slot_count);
  before.swap(slots_);
  used_ = 0;
  ++dropped_bits_;
  for (const Slot& old : before) {
    if (old.count == 0) continue;
    Slot& slot = slot_of(old.key >> 1);
    if (slot.count == 0) ++used_;
    slot.key = old.key >> 1;
    slot.count += old.count;
  }
}

std::vector<Histogram::Bin> Histogram::bins() const {
  std::vector<Slot> used;
  std::copy_if(slots_.begin(), slots_.end(), std::back_inserter(used),
               [](const Slot& slot) { return slot.count != 0; });
  std::sort(used.begin(), used.end(), [](const Slot& a, const Slot& b) { return a.key < b.key; });
  std::vector<Bin> bins;
  bins.reserve(used.size());
  for (const Slot& slot : used) {
    const std::uint64_t key = std::max(slot.key << dropped_bits_, min_key_);
    bins.push_back({sample_of(key), slot.count, whole_of(key)});
  }
  return bins;
}

double Histogram::sample_of(std::uint64_t key) const {
  return with_sample_type(
      type_, [key](auto type) { return static_cast<double>(sample_with<decltype(type)>(key)); });
}

LabelValue Histogram::whole_of(std::uint64_t key) const {
  LabelValue value;
  if (finite_ > 0)
    with_whole_type(type_, [&](auto type) { value = sample_with<decltype(type)>(key); });
  return value;
}

double Histogram::least() const {
  return finite_ > 0 ? sample_of(min_key_) : 0;
}

double Histogram::greatest() const {
  return finite_ > 0 ? sample_of(max_key_) : 0;
}

double Histogram::mean() const {
  if (finite_ == 0) return 0;
  const auto count = static_cast<double>(finite_);
  return std::isfinite(sum_) ? sum_ / count : small_sum_ / count / small_unit;
}

}  // namespace discmc::command

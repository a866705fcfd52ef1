#include "filters.hpp"

#include <algorithm>
#include <string>
#include <type_traits>
#include <utility>

namespace discmc::command {
namespace {

// A layer, and the bits of its labels.
class LayerBits {
 public:
  LayerBits(std::uint32_t number, std::unique_ptr<VolumeReader> volume,
            const std::vector<LabelSet>& sets)
      : volume_(std::move(volume)), slice_(volume_->info().slice_bytes()) {
    for (std::size_t i = 0; i < sets.size(); ++i) {
      const auto found = sets[i].find(number);
      if (found == sets[i].end()) continue;
      const std::uint64_t bit = std::uint64_t{1} << i;
      if (found->second.empty()) bits_of_others_ |= bit;
      for (const LabelValue value : found->second) bits_[value].bits |= bit;
    }
    bits_.emplace(0, Bits{});
    for (auto& [value, each] : bits_)
      if (value != LabelValue(0)) each.bits |= bits_of_others_;
  }

  /// Appends the labels that no voxel had, such as ", 5, 7".
  void list_missing(std::string& text) const {
    for (const auto& [value, each] : bits_)
      if (!each.is_found && value != LabelValue(0)) text += ", " + value.text();
  }

  const VolumeInfo& info() const { return volume_->info(); }

  /// Adds the bits of the next slice to those of other layers.
  template <class Whole>
  void add_slice(Whole* bits) {
    volume_->read_slice(slice_.data());
    with_whole_type(info().type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const sample = reinterpret_cast<const Sample*>(slice_.data());
      std::uint64_t on = 0;
      for (std::size_t i = 0; i < slice_.size() / sizeof(Sample); ++i) {
        // Neighbours mostly have one label.
        if (i == 0 || sample[i] != sample[i - 1]) on = bits_of(sample[i]);
        bits[i] = static_cast<Whole>(bits[i] | on);
      }
    });
  }
  void skip_slice() { volume_->skip_slice(); }

 private:
  struct Bits {
    std::uint64_t bits = 0;
    bool is_found = false;
  };

  std::uint64_t bits_of(LabelValue value) {
    const auto found = bits_.find(value);
    if (found == bits_.end()) return bits_of_others_;
    found->second.is_found = true;
    return found->second.bits;
  }

  std::unique_ptr<VolumeReader> volume_;
  std::vector<std::uint8_t> slice_;
  std::map<LabelValue, Bits> bits_;
  std::uint64_t bits_of_others_ = 0;
};

SampleType type_for(std::size_t bits) {
  if (bits <= 8) return SampleType::u8;
  if (bits <= 16) return SampleType::u16;
  return bits <= 32 ? SampleType::u32 : SampleType::u64;
}

class LabelBits final : public VolumeReader {
 public:
  LabelBits(std::vector<LayerBits> layers, std::size_t sets)
      : layers_(std::move(layers)), info_(layers_[0].info()) {
    info_.type = type_for(sets);
  }

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    with_whole_type(info_.type, [&](auto typed) {
      using Bits = decltype(typed);
      if constexpr (std::is_unsigned_v<Bits>) {
        auto* const bits = static_cast<Bits*>(samples);
        std::fill_n(bits, info_.slice_bytes() / sizeof(Bits), Bits{0});
        for (LayerBits& layer : layers_) layer.add_slice(bits);
      }
    });
    if (++read_ < info_.dims[2]) return;
    std::string missing;
    for (const LayerBits& layer : layers_) layer.list_missing(missing);
    if (!missing.empty()) note(info_, "no voxel has label " + missing.substr(2));
  }

  void skip_slice() override {
    for (LayerBits& layer : layers_) layer.skip_slice();
  }

 private:
  std::vector<LayerBits> layers_;
  VolumeInfo info_;
  std::uint32_t read_ = 0;  // slices that were read, not skipped
};

}  // namespace

std::unique_ptr<VolumeReader> label_bits(
    std::map<std::uint32_t, std::unique_ptr<VolumeReader>> layers,
    const std::vector<LabelSet>& sets) {
  std::vector<LayerBits> all;
  all.reserve(layers.size());
  for (auto& layer : layers) all.emplace_back(layer.first, std::move(layer.second), sets);
  return std::make_unique<LabelBits>(std::move(all), sets.size());
}

}  // namespace discmc::command

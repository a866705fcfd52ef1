#include "filters.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

// Collects the slices of a layer of blocks, and returns the values of the blocks. Reused for each
// layer.
class Blocks {
 public:
  Blocks() = default;
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;
  virtual ~Blocks() = default;

  virtual void add_slice(const void* samples) = 0;
  virtual void move_values_to(void* samples) = 0;
  /// Returns the labels that no block has kept, such as ", 5, 7".
  virtual std::string lost() const { return {}; }
};

// The division of a slice into blocks.
struct Division {
  std::uint32_t extent;
  std::array<std::uint32_t, 2> voxels, blocks;

  // Returns the end of a block that begins at `first`.
  std::uint32_t end_of(std::uint32_t first, std::size_t axis) const {
    return std::min(first + extent, voxels[axis]);
  }
};

// The exact mean of whole numbers. Offsets from the least number are positive; their upper and
// lower 32 bits are added apart, so that the sums fit 64 bits.
template <class Sample, bool = std::is_floating_point_v<Sample>>
class Mean {
 public:
  void add(Sample sample) {
    const std::uint64_t above = static_cast<Unsigned>(static_cast<Unsigned>(sample) - min_sample);
    high_ += above >> 32;
    low_ += above & 0xFFFFFFFF;
    ++count_;
  }
  Sample value() const {
    const std::uint64_t rest = (high_ % count_) << 32;
    const std::uint64_t above = ((high_ / count_) << 32) + (rest + low_ + count_ / 2) / count_;
    return static_cast<Sample>(above + min_sample);
  }

 private:
  using Unsigned = std::make_unsigned_t<Sample>;
  static constexpr auto min_sample = static_cast<Unsigned>(std::numeric_limits<Sample>::min());
  std::uint64_t high_ = 0, low_ = 0, count_ = 0;
};

template <class Sample>
class Mean<Sample, true> {
 public:
  void add(Sample sample) {
    if (std::isnan(sample)) return;
    sum_ += static_cast<double>(sample);
    ++count_;
  }
  Sample value() const {
    if (count_ == 0) return std::numeric_limits<Sample>::quiet_NaN();
    return static_cast<Sample>(sum_ / static_cast<double>(count_));
  }

 private:
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

template <class Sample>
class Means final : public Blocks {
 public:
  explicit Means(const Division& division)
      : division_(division), means_(std::size_t{division.blocks[0]} * division.blocks[1]) {}

  void add_slice(const void* samples) override {
    const auto* sample = static_cast<const Sample*>(samples);
    for (std::uint32_t y = 0; y < division_.voxels[1]; ++y) {
      auto* mean = means_.data() + std::size_t{y / division_.extent} * division_.blocks[0];
      for (std::uint32_t x = 0; x < division_.voxels[0]; ++mean)
        for (const std::uint32_t end = division_.end_of(x, 0); x < end; ++x) mean->add(*sample++);
    }
  }
  void move_values_to(void* samples) override {
    auto* value = static_cast<Sample*>(samples);
    for (auto& mean : means_) *value++ = std::exchange(mean, {}).value();
  }

 private:
  Division division_;
  std::vector<Mean<Sample>> means_;
};

template <class Sample>
class MostFrequent final : public Blocks {
 public:
  explicit MostFrequent(const Division& division) : division_(division) {}

  // Grows with the slices that arrive, so a short file needs little memory.
  void add_slice(const void* samples) override {
    const auto* first = static_cast<const Sample*>(samples);
    slices_.insert(slices_.end(), first, first + slice_samples());
    if constexpr (!std::is_floating_point_v<Sample>)
      for (std::size_t i = 0; i < slice_samples(); ++i)
        if (i == 0 || first[i] != first[i - 1]) kept_.emplace(first[i], false);
  }
  void move_values_to(void* samples) override {
    auto* value = static_cast<Sample*>(samples);
    for (std::uint32_t y = 0; y < division_.voxels[1]; y += division_.extent)
      for (std::uint32_t x = 0; x < division_.voxels[0]; x += division_.extent) {
        collect(x, y);
        *value = most_frequent();
        if constexpr (!std::is_floating_point_v<Sample>) kept_[*value] = true;
        ++value;
      }
    slices_.clear();
  }

  std::string lost() const override {
    std::string text;
    for (const auto& [value, is_kept] : kept_)
      if (!is_kept) text += ", " + std::to_string(value);
    return text;
  }

 private:
  std::size_t slice_samples() const {
    return std::size_t{division_.voxels[0]} * division_.voxels[1];
  }

  void collect(std::uint32_t first_x, std::uint32_t first_y) {
    block_.clear();
    for (std::size_t slice = 0; slice < slices_.size(); slice += slice_samples())
      for (std::uint32_t y = first_y; y < division_.end_of(first_y, 1); ++y) {
        const Sample* const row = slices_.data() + slice + std::size_t{y} * division_.voxels[0];
        std::copy(row + first_x, row + division_.end_of(first_x, 0), std::back_inserter(block_));
      }
    if constexpr (std::is_floating_point_v<Sample>)
      block_.erase(std::remove_if(block_.begin(), block_.end(),
                                  [](Sample sample) { return std::isnan(sample); }),
                   block_.end());
  }

  Sample most_frequent() {
    if (block_.empty()) return std::numeric_limits<Sample>::quiet_NaN();
    const auto is_other = std::not_equal_to<>();
    if (std::adjacent_find(block_.begin(), block_.end(), is_other) == block_.end())
      return block_[0];
    sorted_ = block_;
    std::sort(sorted_.begin(), sorted_.end());
    Sample result = block_[0];
    std::ptrdiff_t max_count = 0;
    for (const Sample sample : block_) {
      const auto [begin, end] = std::equal_range(sorted_.begin(), sorted_.end(), sample);
      if (end - begin <= max_count) continue;
      max_count = end - begin;
      result = sample;
    }
    return result;
  }

  Division division_;
  std::vector<Sample> slices_;          // of the current layer
  std::vector<Sample> block_, sorted_;  // of the current block
  std::map<Sample, bool> kept_;         // whether some block has kept a label
};

std::unique_ptr<Blocks> blocks_of(SampleType type, const Division& division, BlockValue value) {
  return with_sample_type(type, [&](auto typed) -> std::unique_ptr<Blocks> {
    using Sample = decltype(typed);
    if (value == BlockValue::mean) return std::make_unique<Means<Sample>>(division);
    return std::make_unique<MostFrequent<Sample>>(division);
  });
}

class ShrunkVolume final : public VolumeFilter {
 public:
  /// info: of the shrunk volume.
  ShrunkVolume(std::unique_ptr<VolumeReader> volume, VolumeInfo info, std::uint32_t extent,
               std::unique_ptr<Blocks> blocks)
      : VolumeFilter(std::move(volume)),
        extent_(extent),
        blocks_(std::move(blocks)),
        slice_(this->info().slice_bytes()) {
    own_info() = std::move(info);
  }

  void read_slice(void* samples) override {
    const std::uint32_t layer = begin_layer();
    for (std::uint32_t z = 0; z < layer; ++z) {
      volume().read_slice(slice_.data());
      blocks_->add_slice(slice_.data());
    }
    blocks_->move_values_to(samples);
    const std::string lost = read_ < volume().info().dims[2] ? std::string() : blocks_->lost();
    if (!lost.empty())
      add_note("--shrink loses " + lost.substr(2) + ", the most frequent of no block");
  }

  void skip_slice() override {
    for (std::uint32_t left = begin_layer(); left > 0; --left) volume().skip_slice();
  }

 private:
  // Returns the number of slices in the next layer. At the end, one read too many makes the volume
  // throw.
  std::uint32_t begin_layer() {
    const std::uint32_t layer = std::clamp(volume().info().dims[2] - read_, 1U, extent_);
    read_ += layer;
    return layer;
  }

  std::uint32_t extent_;
  std::unique_ptr<Blocks> blocks_;
  std::vector<std::uint8_t> slice_;
  std::uint32_t read_ = 0;  // slices read from the volume
};

}  // namespace

std::unique_ptr<VolumeReader> shrunk(const std::filesystem::path& file,
                                     std::unique_ptr<VolumeReader> volume, std::uint32_t extent,
                                     BlockValue value) {
  VolumeInfo info = volume->info();
  const std::array<std::uint32_t, 3> voxels = info.dims;
  std::array<std::uint32_t, 3> blocks{};
  for (std::size_t axis = 0; axis < 3; ++axis) blocks[axis] = (voxels[axis] + extent - 1) / extent;
  const double middle = (extent - 1) / 2.0;
  set_part(info, file, blocks, {middle, middle, middle}, extent);
  const Division division{extent, {voxels[0], voxels[1]}, {blocks[0], blocks[1]}};
  auto layer = blocks_of(info.type, division, value);
  return std::make_unique<ShrunkVolume>(std::move(volume), std::move(info), extent,
                                        std::move(layer));
}

}  // namespace discmc::command

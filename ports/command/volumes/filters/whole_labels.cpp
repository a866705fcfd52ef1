#include "filters.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

class WholeLabels final : public VolumeFilter {
 public:
  WholeLabels(std::filesystem::path file, std::unique_ptr<VolumeReader> volume)
      : VolumeFilter(std::move(volume)), file_(std::move(file)), slice_(info().slice_bytes()) {
    own_info().type = SampleType::i64;
    own_info().slope = 1;
    own_info().intercept = 0;
  }

  void read_slice(void* samples) override {
    const VolumeInfo& source = volume().info();
    volume().read_slice(slice_.data());
    with_sample_type(source.type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const sample = reinterpret_cast<const Sample*>(slice_.data());
      auto* const label = static_cast<std::int64_t*>(samples);
      for (std::size_t i = 0; i < slice_.size() / sizeof(Sample); ++i)
        label[i] = i > 0 && sample[i] == sample[i - 1]
                       ? counted_again(label[i - 1])
                       : label_of(source.slope * static_cast<double>(sample[i]) + source.intercept);
    });
    end_slice();
  }

  void skip_slice() override {
    volume().skip_slice();
    end_slice();
  }

 private:
  // Returns the label again; neighbours mostly have one label.
  std::int64_t counted_again(std::int64_t label) {
    if (was_rounded_) ++rounded_;
    return label;
  }

  std::int64_t label_of(double value) {
    constexpr double noticed = 1e-9;  // smaller differences are rounding of slope and intercept
    was_rounded_ = false;
    if (std::isnan(value)) {
      ++not_numbers_;
      return 0;
    }
    const auto label = nearest_label(value);
    if (!label)
      fail(file_,
           "the value " + value_text(value) + " in slice " + std::to_string(slices_) +
               " is no label: labels are whole numbers, below 2^53 if scaled or floating point",
           "give --iso or --range");
    const double off = std::fabs(value - static_cast<double>(*label));
    was_rounded_ = off > noticed;
    if (!was_rounded_) return *label;
    ++rounded_;
    if (off > max_off_) {
      max_off_ = off;
      farthest_ = value;
    }
    return *label;
  }

  void end_slice() {
    if (++slices_ < info().dims[2]) return;
    if (rounded_ > 0)
      add_note(std::to_string(rounded_) +
               " values are rounded to whole numbers, as labels are; the farthest is " +
               value_text(farthest_));
    if (not_numbers_ > 0)
      add_note(std::to_string(not_numbers_) + " samples are not a number (NaN) and count as off");
  }

  std::filesystem::path file_;
  std::vector<std::uint8_t> slice_;
  std::uint32_t slices_ = 0;  // number of slices read
  std::uint64_t rounded_ = 0, not_numbers_ = 0;
  bool was_rounded_ = false;  // of the last value
  double max_off_ = 0, farthest_ = 0;
};

}  // namespace

std::optional<std::int64_t> nearest_label(double value) {
  constexpr double max_off = 0.01;
  constexpr double end = 0x1p53;
  const double whole = std::round(value);
  if (!(std::fabs(value - whole) <= max_off) || !(std::fabs(whole) < end)) return std::nullopt;
  return static_cast<std::int64_t>(whole);
}

std::unique_ptr<VolumeReader> whole_labels(const std::filesystem::path& file,
                                           std::unique_ptr<VolumeReader> volume) {
  const VolumeInfo& info = volume->info();
  if (!is_floating(info.type) && info.slope == 1 && info.intercept == 0) return volume;
  return std::make_unique<WholeLabels>(file, std::move(volume));
}

}  // namespace discmc::command

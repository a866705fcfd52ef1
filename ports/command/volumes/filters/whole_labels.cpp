#include "whole_labels.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "text/value_text.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::command {
namespace {

class WholeLabels final : public VolumeReader {
 public:
  WholeLabels(std::filesystem::path file, std::unique_ptr<VolumeReader> volume,
              std::shared_ptr<LabelReport> report)
      : file_(std::move(file)),
        volume_(std::move(volume)),
        info_(volume_->info()),
        report_(std::move(report)),
        slice_(info_.slice_bytes()) {
    info_.type = SampleType::i64;
    info_.slope = 1;
    info_.intercept = 0;
  }

  const VolumeInfo& info() const override { return info_; }

  void read_slice(void* samples) override {
    const VolumeInfo& of = volume_->info();
    volume_->read_slice(slice_.data());
    with_sample_type(of.type, [&](auto typed) {
      using Sample = decltype(typed);
      const auto* const sample = reinterpret_cast<const Sample*>(slice_.data());
      auto* const label = static_cast<std::int64_t*>(samples);
      for (std::size_t i = 0; i < slice_.size() / sizeof(Sample); ++i)
        label[i] = i > 0 && sample[i] == sample[i - 1]
                       ? again(label[i - 1])
                       : label_of(of.slope * static_cast<double>(sample[i]) + of.intercept);
    });
    ++next_;
  }

  void skip_slice() override {
    volume_->skip_slice();
    ++next_;
  }

 private:
  // Neighbours are mostly alike.
  std::int64_t again(std::int64_t label) {
    if (was_rounded_) ++report_->rounded;
    return label;
  }

  std::int64_t label_of(double value) {
    constexpr double noticed = 1e-9;  // less is the rounding of slope and intercept
    was_rounded_ = false;
    if (std::isnan(value)) {
      ++report_->not_numbers;
      return 0;
    }
    const auto label = nearest_label(value);
    if (!label)
      fail(file_,
           "the value " + value_text(value) + " in slice " + std::to_string(next_) +
               " is no label: labels are whole numbers, below 2^53 where they are scaled or "
               "floating point",
           "give --iso or --range");
    const double off = std::fabs(value - static_cast<double>(*label));
    was_rounded_ = off > noticed;
    if (!was_rounded_) return *label;
    ++report_->rounded;
    if (off > off_) {
      off_ = off;
      report_->farthest = value;
    }
    return *label;
  }

  std::filesystem::path file_;
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
  std::shared_ptr<LabelReport> report_;
  std::vector<std::uint8_t> slice_;
  std::uint32_t next_ = 0;  // slice
  bool was_rounded_ = false;
  double off_ = 0;  // most so far
};

}  // namespace

std::optional<std::int64_t> nearest_label(double value) {
  constexpr double most_off = 0.01;
  constexpr double end = 0x1p53;
  const double whole = std::round(value);
  if (!(std::fabs(value - whole) <= most_off) || !(std::fabs(whole) < end)) return std::nullopt;
  return static_cast<std::int64_t>(whole);
}

std::unique_ptr<VolumeReader> whole_labels(const std::filesystem::path& file,
                                           std::unique_ptr<VolumeReader> volume,
                                           std::shared_ptr<LabelReport> report) {
  const VolumeInfo& info = volume->info();
  if (!is_floating(info.type) && info.slope == 1 && info.intercept == 0) return volume;
  return std::make_unique<WholeLabels>(file, std::move(volume), std::move(report));
}

}  // namespace discmc::command

// A volume whose values are measured as it is read.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "meshing.hpp"
#include "samples/sample_bounds.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Units: those that the file declares.
struct ValueRange {
  double least;
  double greatest;
};

/// The volume as it is. It takes less than a nanosecond a sample, where a second pass would take
/// the whole file, and a pipe has none.
class MeasuredVolume final : public VolumeFilter {
 public:
  explicit MeasuredVolume(std::unique_ptr<VolumeReader> volume) : VolumeFilter(std::move(volume)) {}

  void read_slice(void* samples) override;

  /// The range of the finite values that were read so far, if there are any.
  std::optional<ValueRange> range() const;

  /// Whether there are two finite values and no other, as in a mask.
  bool has_two_values() const { return bounds_.least < bounds_.greatest && !bounds_.has_between; }

  /// The same with the infinite values; least > greatest where none is a number.
  ValueRange range_with_infinities() const;

 private:
  SampleBounds bounds_;
};

}  // namespace discmc::command

// A volume whose values are measured as it is read.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "meshing.hpp"
#include "samples/sample_bounds.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {

/// Units: the unit that the file declares.
struct ValueRange {
  double least;
  double greatest;
};

/// Measures the values of a volume and passes them on unchanged. This costs less than a nanosecond
/// per sample. A second pass would read the whole file again, and a pipe allows none.
class MeasuredVolume final : public VolumeFilter {
 public:
  explicit MeasuredVolume(std::unique_ptr<VolumeReader> volume) : VolumeFilter(std::move(volume)) {}

  void read_slice(void* samples) override;

  /// Returns the range of the finite values read so far, if there are any.
  std::optional<ValueRange> range() const;

  /// Whether there are exactly two finite values, as in a mask.
  bool has_two_values() const { return bounds_.least < bounds_.greatest && !bounds_.has_between; }

  /// Likewise includes infinite values; least > greatest if all values are NaN.
  ValueRange range_with_infinities() const;

 private:
  SampleBounds bounds_;
};

}  // namespace discmc::command

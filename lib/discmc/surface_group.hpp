// Several surfaces of one scan: every push goes to all extractors of the group.
//
//   static Extractor16 extractors[2];  // start() each with its own threshold, memory and sink
//   SurfaceGroup<Extractor16> surfaces(extractors, 2, limits.width);
//   result = surfaces.push(row, limits.width);  // as often as samples arrive
//   status = surfaces.resume();                 // after Status::suspended
//   status = surfaces.finish();                 // after the last slice
//
// Streams of slices need no group: a SliceEncoder encodes several surfaces itself.
#ifndef DISCMC_SURFACE_GROUP_HPP
#define DISCMC_SURFACE_GROUP_HPP

#include <stddef.h>

#include <discmc/row_input.hpp>

namespace discmc {

/// Pushes the samples of one scan to several extractors, for example with several thresholds. If
/// one sink is busy, all extractors wait. Construct another group for the next scan, as a group
/// counts the samples of the current row. For the same reason it is neither copied nor moved.
/// Scanner: an extractor type, such as Extractor16.
template <class Scanner>
class SurfaceGroup {
 public:
  /// scanners: `count` extractors, started or restored for slices of one size, between two rows;
  /// Owner: the caller, for as long as the scan lasts. width: voxels per row.
  SurfaceGroup(Scanner* scanners, uint32_t count, uint32_t width)
      : first_(scanners), end_(scanners + count), width_(width) {}
  SurfaceGroup(const SurfaceGroup&) = delete;
  SurfaceGroup& operator=(const SurfaceGroup&) = delete;

  /// As Extractor::push(), for all. Status::suspended: a sink is busy; all extractors have accepted
  /// the samples that the result counts.
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    PushResult result{resume(), 0};
    while (result.status == Status::ok && result.samples < count) {
      const uint32_t row_samples = samples_of_row(count - result.samples, column_, width_);
      const Sample* const next = samples + size_t{result.samples} * stride;
      result.status = for_each(
          [&](Scanner& scanner) { return scanner.push(next, row_samples, stride).status; });
      if (is_error(result.status)) break;
      result.samples += row_samples;
      column_ += row_samples;
      if (column_ == width_) column_ = 0;
    }
    return result;
  }

  /// As Extractor::push_bits(). bits: one row per extractor, one after another, each of
  /// (width + 7) / 8 bytes.
  PushResult push_bits(const uint8_t* bits) {
    const uint8_t* row = bits;
    return process_row([&](Scanner& scanner) {
      const uint8_t* const of_this = row;
      row += (width_ + 7) / 8;
      return scanner.push_bits(of_this).status;
    });
  }

  /// As Extractor::skip_row().
  PushResult skip_row(Substitute substitute) {
    return process_row([&](Scanner& scanner) { return scanner.skip_row(substitute).status; });
  }

  /// resume(), finish() and abandon() call the same function of every extractor. They return the
  /// first error, or Status::suspended if a sink is busy. After `suspended`, call resume() until it
  /// returns another status.
  [[nodiscard]] Status resume() {
    return for_each([](Scanner& scanner) { return scanner.resume(); });
  }
  [[nodiscard]] Status finish() {
    return for_each([](Scanner& scanner) { return scanner.finish(); });
  }
  [[nodiscard]] Status abandon() {
    return for_each([](Scanner& scanner) { return scanner.abandon(); });
  }

 private:
  static bool is_error(Status status) {
    return status != Status::ok && status != Status::suspended;
  }

  // All have the same position, so the first one reports an error before any has changed.
  template <class Call>
  Status for_each(Call call) {
    Status all = Status::ok;
    for (Scanner* scanner = first_; scanner != end_; ++scanner) {
      const Status status = call(*scanner);
      if (is_error(status)) return status;
      if (status == Status::suspended) all = Status::suspended;
    }
    return all;
  }
  template <class Call>
  PushResult process_row(Call call) {
    Status status = resume();
    if (status != Status::ok) return {status, 0};
    status = for_each(call);
    return {status, is_error(status) ? 0 : width_};
  }

  Scanner* first_;
  Scanner* end_;
  uint32_t width_;
  uint32_t column_ = 0;
};

}  // namespace discmc

#endif

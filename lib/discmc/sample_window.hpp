// Gradient normals in a second pass: you push the slices again, in order, and the window holds the
// last four of them.
//
//   window.start(limits, memory);
//   for each slice:
//     window.push(samples, width * height);                       // in pieces of any size
//     for the vertices that are due, lowest z first, while window.covers(vertex):
//       ... unit_normal(weighted(window.negative_gradient(vertex), axis_weights(spacing_nm))) ...
//   window.end();
//   and the remaining vertices, lowest z first
//
// Memory: four slices of samples in the window, and your list of the vertices of one layer.
#ifndef DISCMC_SAMPLE_WINDOW_HPP
#define DISCMC_SAMPLE_WINDOW_HPP

#include <discmc/row_input.hpp>
#include <discmc/status.hpp>
#include <discmc/trace/sample_rows.hpp>

namespace discmc {

/// The last four slices of a volume. Sample is uint8_t, uint16_t or int16_t. A window is neither
/// copied nor moved: two copies would write to the same memory.
template <class Sample>
class SampleWindow {
  static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");

 public:
  SampleWindow() = default;
  SampleWindow(const SampleWindow&) = delete;
  SampleWindow& operator=(const SampleWindow&) = delete;

  static constexpr uint32_t slices_held = 4;

  /// The bytes of memory for start(). Limit: valid limits.
  static constexpr uint64_t bytes_for(const Limits& limits) {
    return detail::trace::SampleRows<Sample>::bytes_for(limits, slices_held * limits.height) +
           Arena::alignment - 1;
  }

  /// Begins a pass. limits: only width and height matter, but all must be valid. memory: at least
  /// bytes_for(limits), at any alignment; Owner: the caller, while the window is in use. Errors:
  /// bad_limits, too_little_memory.
  [[nodiscard]] Status start(const Limits& limits, Memory memory) {
    if (!limits.is_valid()) return Status::bad_limits;
    Arena arena(memory);
    detail::trace::SampleRows<Sample> rows;
    rows.start(arena, limits, slices_held * limits.height);
    if (arena.is_exhausted()) return Status::too_little_memory;
    rows_ = rows;
    width_ = limits.width;
    is_ended_ = false;
    return Status::ok;
  }

  /// Accepts samples of consecutive voxels: x first, then y, then z. A call may begin and end
  /// anywhere. samples: `count` samples that are `stride` samples apart; Owner: the caller; free
  /// again when the call returns. Errors: not_started; finished, after end(). Cost: a copy.
  [[nodiscard]] Status push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    if (width_ == 0) return Status::not_started;
    if (is_ended_) return Status::finished;
    for (uint32_t done = 0; done < count;) {
      const uint32_t row_samples = samples_of_row(count - done, rows_.column(), width_);
      rows_.append(samples + size_t{done} * stride, row_samples, stride);
      if (rows_.is_row_complete()) rows_.next_row();
      done += row_samples;
    }
    return Status::ok;
  }

  /// Ends the input: no slice follows.
  void end() { is_ended_ = true; }

  /// Whether the window holds the samples for negative_gradient(vertex): the slices around the
  /// vertex, and one more on either side, as far as there are any. False until they have arrived,
  /// and again when they have left the window.
  bool covers(const Vertex& vertex) const {
    const int64_t below = vertex.z < 4 ? 0 : vertex.z / 2 - 1;
    const int64_t above = (int64_t{vertex.z} + 1) / 2 + 1;
    const int64_t slices = rows_.slices();
    const bool is_within_slice = rows_.rows() > 0 || rows_.column() > 0;
    const int64_t first_held = slices - slices_held + (is_within_slice ? 1 : 0);
    return (vertex.z < 0 || below >= first_held) && (is_ended_ || above < slices);
  }

  /// Returns the direction in which the samples fall at a vertex: from on to off. Zero if the
  /// samples are level, and for vertices outside the volume. weighted() and unit_normal() of
  /// normal.hpp turn the result into a normal. vertex.z counts from the first slice that was
  /// pushed.
  ///
  /// The result is the sum of central differences at the voxels around the vertex. A midpoint of a
  /// cell edge has two, a centre of a cell eight. At the outermost voxels of the volume the
  /// differences are one-sided. Units: sample values per voxel, times 4 at a midpoint and 16 at a
  /// centre; below 2^21. Limit: covers(vertex). Cost: 12 or 48 samples.
  LongVector negative_gradient(const Vertex& vertex) const {
    return rows_.negative_gradient(vertex);
  }

 private:
  detail::trace::SampleRows<Sample> rows_;
  uint32_t width_ = 0;
  bool is_ended_ = false;
};

}  // namespace discmc

#endif

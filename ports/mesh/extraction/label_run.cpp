#include "label_run.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "moved_surface.hpp"
#include "own_filter.hpp"
#include "selection.hpp"

namespace discmc::meshing {
namespace {

// Turns on the bits of a row from `begin` to before `end`.
void set_bits(std::uint8_t* row, std::uint32_t begin, std::uint32_t end) {
  const auto bits_from = [](std::uint32_t x) {
    return static_cast<std::uint8_t>(0xFFU << (x % 8));
  };
  const std::uint32_t last = end - 1;
  const auto bits_to_last = static_cast<std::uint8_t>(0xFFU >> (7 - last % 8));
  if (begin / 8 == last / 8) {
    row[begin / 8] = static_cast<std::uint8_t>(row[begin / 8] | (bits_from(begin) & bits_to_last));
    return;
  }
  row[begin / 8] = static_cast<std::uint8_t>(row[begin / 8] | bits_from(begin));
  std::fill(row + begin / 8 + 1, row + last / 8, std::uint8_t{0xFF});
  row[last / 8] = static_cast<std::uint8_t>(row[last / 8] | bits_to_last);
}

// Sends rows to a scan, through a filter if there is one.
class RowSender {
 public:
  RowSender(const Limits& limits, bool filters_by_majority, HostScan& scan) : scan_(scan) {
    if (filters_by_majority) filter_.emplace(limits);
  }

  void push(const std::uint8_t* row) {
    if (filter_) row = filter_->filter.push(row);
    if (row != nullptr) scan_.push(row);
  }
  void finish() {
    while (const std::uint8_t* row = filter_ ? filter_->filter.drain() : nullptr) scan_.push(row);
    scan_.finish();
  }

 private:
  HostScan& scan_;
  std::optional<OwnFilter> filter_;
};

}  // namespace

void LabelRun::add(std::uint32_t y, std::uint32_t begin, std::uint32_t end) {
  const auto narrow = [](std::uint32_t number) { return static_cast<std::uint16_t>(number); };
  stretches_.push_back({slice_, narrow(y), narrow(begin), narrow(end)});
  has_voxels_ = true;
}

void LabelRun::end_slice() {
  slices_without_voxels_ = has_voxels_ ? 0 : slices_without_voxels_ + 1;
  has_voxels_ = false;
  ++slice_;
}

void LabelRun::extract(const Limits& limits, bool filters_by_majority, HostScan& scan,
                       JoinedSurface& surface) const {
  // The surface ends before the faces of the box, except those in faces of the volume. A filter may
  // add voxels beside those of the label.
  const std::uint32_t margin = filters_by_majority ? 2 : 1;
  std::array<std::uint32_t, 3> low{limits.width, limits.height, first_}, high{};
  for (const Stretch& each : stretches_) {
    low = {std::min<std::uint32_t>(low[0], each.begin), std::min<std::uint32_t>(low[1], each.y),
           first_};
    high = {std::max<std::uint32_t>(high[0], each.end), std::max(high[1], each.y + 1U),
            each.slice + 1};
  }
  const std::array<std::uint32_t, 3> ends{limits.width, limits.height, slice_};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] -= std::min(low[axis], margin);
    high[axis] = std::min(high[axis] + margin, ends[axis]);
  }

  const Limits box_limits{high[0] - low[0], high[1] - low[1], limits.border};
  MovedSurface moved(surface, low);
  scan.start(box_limits, make_sink(moved), make_region_receiver(moved), high[2] - low[2]);
  RowSender rows(box_limits, filters_by_majority, scan);
  const std::size_t row_bytes = bit_row_bytes(box_limits.width);
  std::vector<std::uint8_t> bits(row_bytes * box_limits.height);
  auto next = stretches_.begin();
  for (std::uint32_t z = low[2]; z < high[2]; ++z) {
    std::fill(bits.begin(), bits.end(), std::uint8_t{0});
    for (; next != stretches_.end() && next->slice == z; ++next)
      set_bits(bits.data() + (next->y - low[1]) * row_bytes, next->begin - low[0],
               next->end - low[0]);
    for (std::uint32_t y = 0; y < box_limits.height; ++y) rows.push(bits.data() + y * row_bytes);
  }
  rows.finish();
  surface.finish();
}

}  // namespace discmc::meshing

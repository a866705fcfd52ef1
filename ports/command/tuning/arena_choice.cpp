#include "arena_choice.hpp"

#include <algorithm>

namespace discmc::command {
namespace {

constexpr std::uint64_t step = 256;
constexpr std::uint32_t max_slots = detail::sizing::max_slots<std::uint16_t>;

// With this many unused slots no loose fragment is ever sent (docs/memory.md).
constexpr std::uint32_t spare_slots = 1168;

std::uint64_t rounded_up(std::uint64_t bytes, std::uint64_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

std::uint64_t bytes_of_slots(const Limits& limits, std::uint32_t slots) {
  return Extractor16::bytes_for(limits, {std::min(slots, max_slots), 0});
}

}  // namespace

std::uint64_t max_arena_bytes(const Limits& limits) {
  return bytes_of_slots(limits, max_slots);
}

std::optional<Trial> min_without_loose_pieces(const VolumeBits& volume, const Trial& plenty,
                                              const std::function<void()>& done) {
  const auto has_none = [&](std::uint64_t steps, Trial& trial) {
    trial = try_regions(volume, steps * step);
    done();
    return trial.loose_pieces == 0;
  };
  const std::uint32_t used = plenty.peaks.slots;
  const Limits& limits = volume.limits();
  std::uint64_t end = rounded_up(bytes_of_slots(limits, used + spare_slots), step) / step;
  std::uint64_t begin = bytes_of_slots(limits, std::max(used, 1U) - 1) / step;
  Trial trial;
  if (!has_none(end, trial)) return std::nullopt;
  Trial least = trial;
  begin = std::max(begin, rounded_up(Extractor16::minimum_bytes(limits), step) / step - 1);
  while (end - begin > 1) {
    const std::uint64_t middle = begin + (end - begin) / 2;
    const bool is_enough = has_none(middle, trial);
    (is_enough ? end : begin) = middle;
    if (is_enough) least = trial;
  }
  return least;
}

std::vector<std::uint64_t> arena_sizes(const Limits& limits, std::uint64_t end) {
  const std::uint64_t least = Extractor16::minimum_bytes(limits);
  const std::uint64_t unit = least < 4096 ? step : 1024;
  std::vector<std::uint64_t> sizes;
  std::uint64_t size = least;
  // In quarters of the minimum: 4, 5, 6, 8, 12, 16, 24 and so on.
  for (std::uint64_t quarters = 5; size < end;) {
    if (sizes.empty() || size > sizes.back()) sizes.push_back(size);
    size = rounded_up(least * quarters / 4, unit);
    quarters = quarters == 5 ? 6 : quarters % 3 == 0 ? quarters / 3 * 4 : quarters / 2 * 3;
  }
  return sizes;
}

}  // namespace discmc::command

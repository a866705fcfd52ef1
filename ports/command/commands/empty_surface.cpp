#include "empty_surface.hpp"

#include <cmath>
#include <optional>

#include "extraction/narrowed_volume.hpp"
#include "progress.hpp"
#include "statistics/value_text.hpp"
#include "volume_input.hpp"

namespace discmc::host {
namespace {

struct Range {
  double least;
  double greatest;
};

std::optional<Range> range_of(const std::string& path, const VolumeArguments& arguments) {
  if (is_read_once(path)) return std::nullopt;
  const auto volume = open_volume(path, volume_options(arguments));
  const VolumeInfo& info = volume->info();
  const Progress progress("measuring");
  const SampleBounds bounds = sample_bounds(*volume);
  return Range{info.slope * bounds.least + info.intercept,
               info.slope * bounds.greatest + info.intercept};
}

std::string end_text(double value) {
  return std::isfinite(value) ? value_text(value) : std::string();
}

// As in "no voxel reaches 300".
std::string condition(const Selection& selection) {
  if (!selection.has_upper_end()) return "reaches " + value_text(selection.low);
  if (selection.is_one_value()) return "is " + value_text(selection.low);
  return "is in " + end_text(selection.low) + ".." + end_text(selection.high);
}

std::string reason(const VolumeArguments& arguments, const Selection& selection,
                   const std::optional<Range>& range) {
  const bool is_reached =
      !range || (selection.low <= range->greatest && selection.high >= range->least);
  if (is_reached && !arguments.mask.empty())
    return "no voxel that " + condition(selection) + " is left by --mask";
  if (is_reached && arguments.median > 0)
    return "no voxel that " + condition(selection) + " is left by --median";
  const bool is_open = arguments.border == Border::open;
  if (is_open && range && selection.low <= range->least && range->greatest <= selection.high)
    return "every voxel " + condition(selection) + ", and an open border has no surface";
  return (is_open && !range ? "no or every voxel " : "no voxel ") + condition(selection);
}

}  // namespace

std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const Selection& selection) {
  const auto range = range_of(path, arguments);
  std::string text =
      (path == "-" ? "standard input" : path) + ": " + reason(arguments, selection, range);
  if (range)
    text += ": the values are " + value_text(range->least) + " to " + value_text(range->greatest);
  return text + "; discmc info shows more of the values";
}

void fail_empty(const std::string& path, const VolumeArguments& arguments,
                const Selection& selection) {
  throw VolumeError(why_empty(path, arguments, selection) +
                    ", --allow-empty takes an empty surface");
}

}  // namespace discmc::host


#include <algorithm>
#include <cmath>
#include <iomanip>
#include <string>
#include <vector>

#include "statistics/threshold_rule.hpp"
#include "summary.hpp"
#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/filters/filters.hpp"

namespace discmc::command {
namespace {

// ---- histogram ----

// An interval of values from `low` up to, but without, `high`; the last line includes `high`.
struct Line {
  double low;
  double high;
  std::uint64_t count;
  std::string value = {};  // if it is the only value
};

// Prints all digits of 64-bit whole numbers.
std::string text_of(const VolumeStatistics& statistics, const ValueCount& each) {
  return statistics.are_whole ? each.whole.text() : value_text(each.value);
}

std::vector<Line> lines_of_values(const VolumeStatistics& statistics) {
  std::vector<Line> lines;
  for (const ValueCount& each : statistics.counts)
    lines.push_back({each.value, each.value, each.count, text_of(statistics, each)});
  return lines;
}

// Returns the smallest step of 1, 2 or 5 times a power of ten that is at least min_step.
double round_step(double min_step) {
  const double power = std::pow(10, std::floor(std::log10(min_step)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= min_step) return factor * power;
  return 10 * power;
}

std::vector<Line> lines_of_intervals(const VolumeStatistics& statistics, int max_lines) {
  double low = percentile(statistics, 0.5);
  double high = percentile(statistics, 99.5);
  if (low == high) {
    low = statistics.least;
    high = statistics.greatest;
  }
  const double step = round_step(high / max_lines - low / max_lines);
  constexpr double max_steps = 1e15;  // double still distinguishes them
  if (!(std::fabs(low) / step < max_steps))
    return {{statistics.least, statistics.greatest, statistics.numbers}};
  const double begin = std::floor(low / step);
  const auto count = static_cast<std::size_t>(std::floor(high / step) - begin) + 1;
  std::vector<Line> lines;
  for (std::size_t i = 0; i < count; ++i) {
    const double place = begin + static_cast<double>(i);
    lines.push_back({place * step, (place + 1) * step, 0});
  }
  auto line = lines.begin();
  for (const ValueCount& each : statistics.counts) {
    while (line + 1 != lines.end() && each.value >= line->high) ++line;
    line->count += each.count;
  }
  lines.front().low = statistics.least;
  lines.back().high = statistics.greatest;
  return lines;
}

void print_histogram(const VolumeStatistics& statistics, std::ostream& out) {
  constexpr int max_lines = 16;
  constexpr double bar = 34;  // 80 columns in all
  const bool has_few_values = statistics.is_exact && statistics.counts.size() <= max_lines;
  const std::vector<Line> lines =
      has_few_values ? lines_of_values(statistics) : lines_of_intervals(statistics, max_lines);
  std::uint64_t max_count = 0;
  for (const Line& line : lines) max_count = std::max(max_count, line.count);
  for (const Line& line : lines) {
    // Bars grow with the square root, so that rare values stay visible.
    const double share =
        std::sqrt(static_cast<double>(line.count) / static_cast<double>(max_count));
    const bool is_one = !line.value.empty();
    out << "histogram " << std::setw(10) << (is_one ? line.value : value_text(line.low)) << ' '
        << std::setw(10) << (is_one ? line.value : value_text(line.high)) << ' ' << std::setw(11)
        << line.count;
    const auto length = static_cast<std::size_t>(std::ceil(share * bar));
    if (length > 0) out << ' ' << std::string(length, '#');
    out << '\n';
  }
}

// ---- options for extract ----

// Returns the labels of a segmentation, without its background.
std::vector<std::string> labels(const VolumeStatistics& statistics) {
  constexpr std::size_t max_shown = 64;
  std::vector<std::string> labels;
  if (!statistics.is_exact || statistics.infinite > 0 || statistics.counts.size() > max_shown)
    return {};
  for (const ValueCount& each : statistics.counts) {
    const auto label = nearest_label(each.value);
    if (!label && !statistics.are_whole) return {};
    const std::string text = statistics.are_whole ? each.whole.text() : std::to_string(*label);
    if (text != "0") labels.push_back(text);
  }
  return labels;
}

void propose_labels(const std::vector<std::string>& labels, std::ostream& out) {
  if (labels.empty()) return;
  out << "proposal --labels all: the values are few and whole, as labels are; a mesh per label\n"
      << "proposal --label N: one of";
  for (const std::string& label : labels) out << ' ' << label;
  out << '\n';
}

void propose_thresholds(bool is_in_hounsfield, const VolumeStatistics& statistics,
                        std::ostream& out) {
  const auto padding = padding_value(statistics);
  if (const auto iso = otsu_threshold(statistics))
    out << "proposal --iso=" << value_text(*iso) << " otsu: divides the values into two groups"
        << (padding ? ", without the padding " + value_text(*padding) : "") << '\n';
  if (is_in_hounsfield && divides(bone_threshold, statistics))
    out << "proposal --iso=" << value_text(bone_threshold)
        << " bone: in Hounsfield units; soft tissue has less\n";
  if (is_in_hounsfield && divides(skin_threshold, statistics))
    out << "proposal --iso=" << value_text(skin_threshold)
        << " skin: in Hounsfield units; air has less\n";
}

// Prints the most likely option first.
void print_proposals(const VolumeInfo& info, const VolumeStatistics& statistics,
                     std::ostream& out) {
  const bool is_hounsfield = is_in_hounsfield(info, statistics);
  if (!is_hounsfield) propose_labels(labels(statistics), out);
  propose_thresholds(is_hounsfield, statistics, out);
}

// Example: "label 1 liver", "label 2,3 layer 0 kidney".
void print_label(const LabelDescription& label, bool has_layers, std::ostream& out) {
  out << "label ";
  for (std::size_t i = 0; i < label.values.size(); ++i)
    out << (i > 0 ? "," : "") << label.values[i].text();
  if (label.values.empty()) out << "nonzero";
  if (has_layers) out << " layer " << label.layer;
  out << ' ' << without_control(label.name) << '\n';
}

}  // namespace

void print_volume_info(const VolumeInfo& info, std::ostream& out) {
  out << "format " << info.format << '\n'
      << "type " << name(info.type) << '\n'
      << "slope " << value_text(info.slope) << '\n'
      << "intercept " << value_text(info.intercept) << '\n'
      << "frames " << info.frames << '\n'
      << "channels " << info.channels << '\n'
      << "dimensions " << info.dims[0] << ' ' << info.dims[1] << ' ' << info.dims[2] << '\n'
      << "extent";
  for (std::size_t axis = 0; axis < 3; ++axis)
    out << ' ' << value_text(info.dims[axis] * info.distances_mm()[axis]);
  out << '\n';
  print_place(info.spacing_mm, info.placement, out);
  for (const LabelDescription& label : info.labels) print_label(label, info.frames > 1, out);
}

void print_volume_statistics(const VolumeInfo& info, const VolumeStatistics& statistics,
                             std::ostream& out) {
  out << "voxels " << std::uint64_t{info.dims[0]} * info.dims[1] * info.dims[2] << '\n'
      << "not_numbers " << statistics.not_numbers << '\n'
      << "infinite " << statistics.infinite << '\n';
  if (statistics.numbers == 0) {
    out << "note no value is finite; check the file\n";
    return;
  }
  const std::vector<ValueCount> ends = {{statistics.least, 0, statistics.min_whole},
                                        {statistics.greatest, 0, statistics.max_whole}};
  out << "range " << text_of(statistics, ends[0]) << ' ' << text_of(statistics, ends[1]) << '\n'
      << "mean " << value_text(statistics.mean) << '\n';
  for (const int percent : {1, 5, 25, 50, 75, 95, 99})
    out << "percentile_" << percent << ' ' << value_text(percentile(statistics, percent)) << '\n';
  print_histogram(statistics, out);
  print_proposals(info, statistics, out);
}

}  // namespace discmc::command

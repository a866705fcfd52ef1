#include "segmentation.hpp"

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "pictures/srgb.hpp"
#include "text/message.hpp"
#include "volume_input.hpp"
#include "volumes/label_table.hpp"

namespace discmc::command {
namespace {

VolumeOptions options_of(const VolumeArguments& arguments) {
  VolumeOptions options = arguments.options;
  options.block_value = BlockValue::most_frequent;
  options.holds_labels = true;
  return options;
}

std::vector<std::uint32_t> layers_of(const VolumeInfo& info, const VolumeArguments& arguments) {
  if (arguments.options.frame) return {*arguments.options.frame};
  std::set<std::uint32_t> layers;
  for (const LabelDescription& label : info.labels) layers.insert(label.layer);
  if (info.frames == 1) layers = {0};
  return {layers.begin(), layers.end()};
}

// A table from the user replaces the labels of the file.
LabelTable table_of(const VolumeInfo& info, const VolumeArguments& arguments) {
  if (arguments.label_table.empty()) return info.labels;
  LabelTable table = read_label_table(arguments.label_table);
  for (LabelDescription& label : table) label.layer = arguments.options.frame.value_or(0);
  return table;
}

}  // namespace

Segmentation::Segmentation(const std::string& path, const VolumeArguments& arguments)
    : path_(path),
      options_(options_of(arguments)),
      first_(noted(path, open_layer(path, options_))),
      info_(first_->info()),
      names_(table_of(info_, arguments), layers_of(info_, arguments)) {
  if (info_.frames > names_.layers().size() && !arguments.options.frame)
    print_message(path, std::to_string(info_.frames - names_.layers().size()) + " of " +
                            std::to_string(info_.frames) +
                            " layers have no label in the header and are left out");
}

std::unique_ptr<VolumeReader> Segmentation::open(std::uint32_t layer) {
  if (first_ && layer == options_.frame.value_or(0)) return std::move(first_);
  require_second_pass(path_, "each layer of a segmentation is read separately");
  VolumeOptions options = options_;
  options.frame = layer;
  return open_noted(path_, options);
}

std::unique_ptr<VolumeReader> open_labels(Segmentation& segmentation, const std::string& path,
                                          std::vector<NamedSelection>& selections) {
  if (selections.size() > max_label_sets)
    throw std::invalid_argument("--label is given " + std::to_string(selections.size()) +
                                " times; give it " + std::to_string(max_label_sets) +
                                " times at most, or a list to --labels");
  std::vector<LabelSet> sets;
  std::map<std::uint32_t, std::unique_ptr<VolumeReader>> layers;
  for (NamedSelection& each : selections) {
    NamedLabels labels;
    try {
      labels = segmentation.names().together(each.given);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(display_name(path) + ": " + error.what());
    }
    each.name = labels.name;
    each.colour = labels.colour;
    const std::vector<LabelValue>& values = labels.set.begin()->second;
    if (!each.colour && selections.size() > 1)
      each.colour = label_colour(values.empty() ? 1 : values[0].rounded());
    each.selection = {values.empty() ? 1 : values[0].rounded()};
    each.selection.bits = std::uint64_t{1} << sets.size();
    for (const auto& [layer, unused] : labels.set) layers.emplace(layer, nullptr);
    sets.push_back(std::move(labels.set));
  }
  for (auto& [layer, volume] : layers) volume = segmentation.open(layer);
  return noted(path, label_bits(std::move(layers), sets));
}

}  // namespace discmc::command

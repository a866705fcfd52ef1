#include "label_names.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

NamedLabels labels_of(const LabelDescription& description) {
  return {{{description.layer, description.values}},
          without_control(description.name),
          description.colour};
}

// Returns the name in lower case, with blanks for underscores.
std::string plain(std::string_view name) {
  std::string result = lower(name);
  std::replace(result.begin(), result.end(), '_', ' ');
  return result;
}

}  // namespace

LabelNames::LabelNames(LabelTable table, std::vector<std::uint32_t> layers)
    : table_(std::move(table)), layers_(std::move(layers)) {
  const auto is_left = [this](const LabelDescription& each) {
    return std::find(layers_.begin(), layers_.end(), each.layer) == layers_.end();
  };
  table_.erase(std::remove_if(table_.begin(), table_.end(), is_left), table_.end());
  for (std::size_t i = 0; i < table_.size(); ++i) {
    const LabelDescription& each = table_[i];
    longest_name_ = std::max(longest_name_, each.name.size());
    if (each.values.empty()) masks_[each.layer].push_back(i);
    if (each.values.size() == 1) of_value_[each.values[0]].push_back(i);
  }
}

std::string LabelNames::list_of_names() const {
  constexpr std::size_t max_shown = 12;
  if (table_.empty()) return "the labels have no names; give numbers, or --label-table FILE";
  std::string text = "there are ";
  for (std::size_t i = 0; i < std::min(max_shown, table_.size()); ++i)
    text += (i > 0 ? ", " : "") + shown(table_[i].name);
  return table_.size() <= max_shown ? text
                                    : text + " and " + std::to_string(table_.size() - max_shown) +
                                          " more; list all with discmc info";
}

std::optional<NamedLabels> LabelNames::by_number(std::string_view text) const {
  const auto value = label_value(text);
  if (!value) return std::nullopt;
  std::vector<const LabelDescription*> found;
  if (const auto places = of_value_.find(*value); places != of_value_.end())
    for (const std::size_t place : places->second) found.push_back(&table_[place]);
  const bool is_in_one_layer = std::all_of(
      found.begin(), found.end(),
      [&found](const LabelDescription* each) { return each->layer == found[0]->layer; });
  if (!is_in_one_layer)
    throw std::invalid_argument("label " + value->text() + " is " + shown(found[0]->name) +
                                " and, in another layer, " + shown(found.back()->name) +
                                "; give a name, or the layer with --frame N");
  if (found.empty() && layers_.size() > 1)
    throw std::invalid_argument("no label has the number " + value->text() + ": " +
                                list_of_names());
  return named(found.empty() ? layers_[0] : found[0]->layer, *value);
}

std::optional<NamedLabels> LabelNames::by_name(std::string_view text) const {
  for (const bool is_exact : {true, false}) {
    const LabelDescription* found = nullptr;
    for (const LabelDescription& each : table_) {
      if (is_exact ? each.name != text : plain(each.name) != plain(text)) continue;
      if (found != nullptr)
        throw std::invalid_argument("several labels are called " + shown(text) +
                                    "; give their numbers, or the layer with --frame N");
      found = &each;
    }
    if (found != nullptr) return labels_of(*found);
  }
  return std::nullopt;
}

std::vector<NamedLabels> LabelNames::each(const std::string& list) const {
  std::vector<NamedLabels> labels;
  for (std::size_t begin = 0; begin <= list.size();) {
    // Takes the longest text that is a label, because names may contain commas.
    std::optional<NamedLabels> found;
    std::size_t end = list.size();
    if (end - begin > longest_name_) end = std::min(end, list.find(',', begin + longest_name_));
    for (;;) {
      const std::string_view piece = std::string_view(list).substr(begin, end - begin);
      found = by_number(piece);
      if (!found) found = by_name(piece);
      const std::size_t comma = found ? std::string::npos : piece.rfind(',');
      if (comma == std::string_view::npos) break;
      end = begin + comma;
    }
    if (!found)
      throw std::invalid_argument("no label is called " + shown(list.substr(begin, end - begin)) +
                                  ": " + list_of_names());
    labels.push_back(*std::move(found));
    begin = end + 1;
  }
  return labels;
}

NamedLabels LabelNames::together(const std::string& list) const {
  const std::vector<NamedLabels> labels = each(list);
  NamedLabels combined = labels[0];
  if (labels.size() == 1) return combined;
  combined.name = without_control(list);
  for (std::size_t i = 1; i < labels.size(); ++i)
    for (const auto& [layer, values] : labels[i].set) {
      const auto [entry, is_new] = combined.set.emplace(layer, values);
      if (is_new || entry->second.empty()) continue;
      if (values.empty())
        entry->second.clear();
      else
        entry->second.insert(entry->second.end(), values.begin(), values.end());
    }
  return combined;
}

std::vector<NamedLabels> LabelNames::regions() const {
  std::vector<NamedLabels> regions;
  for (const LabelDescription& each : table_)
    if (each.values.size() > 1) regions.push_back(labels_of(each));
  return regions;
}

NamedLabels LabelNames::named(std::uint32_t layer, LabelValue value) const {
  std::vector<std::size_t> found;
  if (const auto masks = masks_.find(layer); masks != masks_.end()) found = masks->second;
  if (const auto places = of_value_.find(value); places != of_value_.end())
    for (const std::size_t place : places->second)
      if (table_[place].layer == layer) found.push_back(place);
  NamedLabels result{{{layer, {value}}}, value.text(), {}};
  if (found.size() != 1) return result;
  result.name = without_control(table_[found[0]].name);
  result.colour = table_[found[0]].colour;
  return result;
}

}  // namespace discmc::command

#include "label_table.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "volume_error.hpp"

namespace discmc::command {
namespace {

using Json = nlohmann::ordered_json;

std::optional<LabelValue> number_in(const Json& value) {
  if (value.is_number_unsigned()) return LabelValue(value.get<std::uint64_t>());
  if (value.is_number_integer()) return LabelValue(value.get<std::int64_t>());
  return std::nullopt;
}

std::optional<LabelDescription> label_in(const std::string& key, const Json& value) {
  LabelDescription label{key};
  if (value.is_string()) {
    label.name = value.get<std::string>();
    const auto number = label_value(key);
    if (!number || label.name.empty()) return std::nullopt;
    label.values = {*number};
    return label;
  }
  const Json numbers = value.is_array() ? value : Json::array({value});
  for (const Json& each : numbers) {
    const auto number = number_in(each);
    if (!number) return std::nullopt;
    label.values.push_back(*number);
  }
  if (label.name.empty() || label.values.empty()) return std::nullopt;
  return label;
}

}  // namespace

LabelTable read_label_json(const std::string& file) {
  std::ifstream in(file);
  const Json json = Json::parse(in, nullptr, false);
  const std::string remedy = R"(give a file with {"labels": {"liver": 1}}, as dataset.json is)";
  if (json.is_discarded() || !json.is_object()) fail(file, "the file is not JSON", remedy);
  const auto labels = json.find("labels");
  if (labels == json.end() || !labels->is_object() || labels->empty())
    fail(file, "there is no object \"labels\" with labels", remedy);
  LabelTable table;
  for (const auto& [key, value] : labels->items()) {
    auto label = label_in(key, value);
    if (!label)
      fail(file, "label " + shown(key) + " is " + shown(value.dump()),
           "give one or more whole numbers");
    table.push_back(*std::move(label));
  }
  return table;
}

}  // namespace discmc::command

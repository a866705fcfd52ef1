#include "volume_options.hpp"

#include <limits>
#include <optional>
#include <string>

#include "text/number_text.hpp"
#include "volumes/label_table.hpp"

namespace discmc::command {
namespace {

bool is_rounded(const std::string& text) {
  const auto whole = label_value(text);
  return whole && whole->is_rounded();
}

// Returns the first whole number of a threshold or range that double would round, or an empty
// string.
std::string rounded_part(const std::string& text) {
  const std::size_t dots = text.find("..");
  for (const std::string& part :
       {text.substr(0, dots), dots == std::string::npos ? std::string() : text.substr(dots + 2)})
    if (is_rounded(part)) return part;
  return "";
}

// Returns nothing if double would round the number.
std::optional<double> exact_number(const std::string& text) {
  return is_rounded(text) ? std::nullopt : finite_number(text);
}

std::optional<NamedSelection> threshold(const std::string& text) {
  for (const auto& [called, rule] : threshold_rules)
    if (called == text) {
      NamedSelection surface{{}, text};
      surface.rule = rule;
      return surface;
    }
  const auto low = exact_number(text);
  return low ? std::optional(NamedSelection{{*low}, text}) : std::nullopt;
}

// A missing end is infinite.
std::optional<NamedSelection> range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos || text.size() == 2) return std::nullopt;
  const std::string low = text.substr(0, dots);
  const std::string high = text.substr(dots + 2);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto lowest = low.empty() ? -infinity : exact_number(low);
  const auto highest = high.empty() ? infinity : exact_number(high);
  if (!lowest || !highest || *lowest > *highest) return std::nullopt;
  return NamedSelection{{*lowest, *highest}, text};
}

std::optional<NamedSelection> label(const std::string& text) {
  if (text.empty()) return std::nullopt;
  NamedSelection surface{{}, text};
  surface.is_label = true;
  return surface;
}

using Parse = std::optional<NamedSelection> (*)(const std::string&);

CLI::Option* add_selection_option(CLI::App& app, const std::string& name, Parse parse,
                                  const std::string& form, const std::string& wanted,
                                  std::vector<NamedSelection>& selections,
                                  const std::string& description) {
  return app
      .add_option_function<std::vector<std::string>>(
          name,
          [&selections, parse](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) selections.push_back(*parse(text));
          },
          description)
      ->check(CLI::Validator(
          [parse, wanted](std::string& text) {
            if (parse(text)) return std::string();
            const std::string part = rounded_part(text);
            if (part.empty()) return "invalid value '" + text + "'; expected " + wanted;
            return "'" + part +
                   "' has more than the 53 bits of a threshold; if it is a label, give --label " +
                   part;
          },
          ""))
      ->expected(1)
      ->option_text(form);
}

}  // namespace

void add_selection_options(CLI::App& app, std::vector<NamedSelection>& selections) {
  app.option_defaults()->group(surface_group);
  CLI::Option* iso =
      add_selection_option(app, "--iso", threshold, "ISO|auto|otsu|bone|skin",
                           "a finite number, auto, otsu, bone or skin", selections,
                           "the threshold, in the units of the file: a voxel is on if its value is "
                           ">= ISO; otsu: divides the values into the two groups that differ most; "
                           "bone, skin: 300 and -300, for CT; auto: bone for CT, otherwise otsu");
  CLI::Option* between =
      add_selection_option(app, "--range", range, "LOW..HIGH", "LOW..HIGH, LOW.. or ..HIGH",
                           selections, "instead of --iso: a voxel is on if LOW <= value <= HIGH");
  CLI::Option* label_option =
      add_selection_option(app, "--label", label, "N|NAME,...", "a number or name", selections,
                           "instead of --iso: a voxel is on if it has the label with this number "
                           "or name. A list makes one surface: 5,6 or 'left lung,right lung'");
  iso->excludes(between)->excludes(label_option);
  between->excludes(label_option);
}

}  // namespace discmc::command

#include "length_unit.hpp"

#include <algorithm>
#include <initializer_list>
#include <string>

#include "text/words.hpp"

namespace discmc::command {
namespace {

struct Unit {
  double millimetres;
  std::initializer_list<std::string_view> names;
};

// Words have British spelling and are singular here. Micro has two characters in Unicode, one
// in Latin-1, and an escape in files of ImageJ.
const Unit length_units[] = {
    {1000, {"m", "metre"}},
    {100, {"dm", "decimetre"}},
    {10, {"cm", "centimetre"}},
    {1, {"mm", "millimetre"}},
    {1e-3, {"um", "\u00b5m", "\u03bcm", "\xb5m", "\\u00b5m", "micron", "micrometre"}},
    {1e-6, {"nm", "nanometre"}},
    {1e-7, {"\u00c5", "\u212b", "\xc5", "angstrom"}},
    {1e-9, {"pm", "picometre"}},
    {25.4, {"in", "inch", "\""}},
};

// "Micrometers" as "micrometre".
std::string in_british_singular(std::string_view name) {
  std::string word = lower(trimmed(name));
  if (word == "inches") return "inch";
  if (word.size() > 3 && word.back() == 's') word.pop_back();
  const std::size_t at = word.size() - std::min<std::size_t>(word.size(), 5);
  if (word.substr(at) == "meter") word.replace(at, 5, "metre");
  return word;
}

}  // namespace

std::optional<double> millimetres_in(std::string_view unit) {
  const std::string name = in_british_singular(unit);
  for (const Unit& each : length_units)
    if (std::find(each.names.begin(), each.names.end(), name) != each.names.end())
      return each.millimetres;
  return std::nullopt;
}

}  // namespace discmc::command

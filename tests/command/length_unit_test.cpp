// Units of length as spelled in files.
#include "volumes/declared_place.hpp"

#include "test.hpp"

using discmc::command::millimetres_in;

TEST_CASE("every spelling of a length unit gives the same number of millimetres") {
  const std::vector<std::pair<double, std::vector<std::string>>> units = {
      {1000, {"m", "M", "metre", "meters", "Metres"}},
      {100, {"dm", "decimeter"}},
      {10, {"cm", "CM", "centimetre", "Centimeters"}},
      {1, {"mm", " mm ", "MM", "millimeter", "millimetres"}},
      {1e-3,
       {"um", "\u00b5m", "\u03bcm", "\xb5m", "\\u00B5m", "micron", "Microns", "micrometer",
        "micrometres"}},
      {1e-6, {"nm", "nanometer"}},
      {1e-7, {"angstrom", "Angstroms", "\u00c5"}},
      {1e-9, {"pm", "picometers"}},
      {25.4, {"in", "inch", "Inches"}},
  };
  for (const auto& [millimetres, names] : units)
    for (const std::string& name : names) {
      INFO(name);
      CHECK(millimetres_in(name) == millimetres);
    }
}

TEST_CASE("names that are no length unit are rejected") {
  for (const std::string name : {"", "pixel", "s", "mms", "meter per second", "ms", "mi", "meter2"})
    CHECK_FALSE(millimetres_in(name));
}

#include "header_bytes.hpp"

#include <cmath>
#include <locale>
#include <sstream>

namespace discmc::command {

double decimal(float value) {
  for (int digits = 6; digits <= 9 && std::isfinite(value); ++digits) {
    std::stringstream text;
    text.imbue(std::locale::classic());
    text.precision(digits);
    text << value;
    double result = 0;
    if (text >> result && static_cast<float>(result) == value) return result;
  }
  return static_cast<double>(value);
}

}  // namespace discmc::command

#include "declared_values.hpp"

#include <cmath>

#include "text/words.hpp"

namespace discmc::command {

DeclaredValues declared_values(const std::function<std::optional<double>(const char*)>& number,
                               const std::string& sign) {
  DeclaredValues values;
  values.slope = number("scale_factor").value_or(1);
  values.intercept = number("add_offset").value_or(0);
  values.fill = number("_FillValue");
  if (!values.fill) values.fill = number("missing_value");
  if (lower(sign) == "true") values.is_unsigned = true;
  if (lower(sign) == "false") values.is_unsigned = false;
  return values;
}

std::optional<double> set_values(VolumeInfo& info, const std::string& file,
                                 const DeclaredValues& values) {
  std::optional<double> fill = values.fill;
  if (values.is_unsigned && !is_floating(info.type)) {
    const std::string bits(name(info.type).substr(1));
    info.type = *sample_type_called((*values.is_unsigned ? "u" : "i") + bits);
    const double all = std::ldexp(1, static_cast<int>(8 * sample_bytes(info.type)));
    if (fill && *values.is_unsigned && *fill < 0) *fill += all;
    if (fill && !*values.is_unsigned && *fill >= all / 2) *fill -= all;
  }
  set_scale(info, file, values.slope, values.intercept);
  return fill;
}

}  // namespace discmc::command

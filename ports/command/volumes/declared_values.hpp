// What the samples of an array stand for, as NetCDF and xarray declare it in attributes.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "volume_info.hpp"

namespace discmc::command {

struct DeclaredValues {
  double slope = 1, intercept = 0;
  std::optional<double> fill{};       ///< samples that are none
  std::optional<bool> is_unsigned{};  ///< of whole numbers; nothing: as they are stored
};

/// number: called with the name of an attribute, returns it if it is one number. sign: the text of
/// the attribute _Unsigned.
DeclaredValues declared_values(const std::function<std::optional<double>(const char*)>& number,
                               const std::string& sign);

/// Sets the type and the scale. Returns the fill value, as a sample of this type. Limit: the type
/// is that of the stored samples.
std::optional<double> set_values(VolumeInfo& info, const std::string& file,
                                 const DeclaredValues& values);

}  // namespace discmc::command

// The scale and fill value of an array, declared by the attributes of NetCDF and xarray.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "volume_info.hpp"

namespace discmc::command {

struct DeclaredValues {
  double slope = 1, intercept = 0;
  std::optional<double> fill{};       ///< marks samples without a value
  std::optional<bool> is_unsigned{};  ///< of whole numbers; nothing: as stored
};

/// number: returns the attribute of a name, if it is one number. sign: the text of the attribute
/// _Unsigned.
DeclaredValues declared_values(const std::function<std::optional<double>(const char*)>& number,
                               const std::string& sign);

/// Sets the type and the scale. Returns the fill value as a sample of this type. Limit: info has
/// the type of the stored samples.
std::optional<double> set_values(VolumeInfo& info, const std::string& file,
                                 const DeclaredValues& values);

}  // namespace discmc::command

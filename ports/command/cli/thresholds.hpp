// Thresholds that a command is to find by itself: --iso auto, otsu, bone, skin.
#pragma once

#include <string>
#include <vector>

#include "arguments.hpp"

namespace discmc::command {

/// The surfaces that are asked for of the volume, each with its threshold. What a rule finds is
/// printed. A rule needs a pass over the volume, unless the file states Hounsfield units and the
/// rule needs no more. Throws where a rule does not fit the values, and as require_second_pass().
std::vector<NamedSelection> with_thresholds(const std::string& path,
                                            const VolumeArguments& arguments);

}  // namespace discmc::command

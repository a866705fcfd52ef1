// The names and colours of the labels of a segmentation.
#ifndef DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP
#define DISCMC_COMMAND_VOLUMES_LABEL_DESCRIPTION_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "pictures/srgb.hpp"

namespace discmc::command {

struct LabelDescription {
  std::string name;
  std::optional<Srgb> colour;
};

/// What is known of labels, by their values.
using LabelTable = std::map<std::int64_t, LabelDescription>;

}  // namespace discmc::command

#endif

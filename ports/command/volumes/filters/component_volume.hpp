// One of several volumes whose samples lie side by side.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_COMPONENT_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_COMPONENT_VOLUME_HPP

#include <cstdint>
#include <memory>

#include "volumes/volume_reader.hpp"

namespace discmc::command {

/// Every `count`-th sample of a row, from sample `first` on. all: rows of all samples; `info.dims`
/// times count of them. info: of the component.
std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count);

}  // namespace discmc::command

#endif

// One of several volumes whose samples lie side by side.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_COMPONENT_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_COMPONENT_VOLUME_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "volumes/volume_reader.hpp"

namespace discmc::command {

/// Every `count`-th sample of a row, from sample `first` on. all: rows of all samples; `info.dims`
/// times count of them. info: of the component.
std::unique_ptr<VolumeReader> component(std::unique_ptr<VolumeReader> all, VolumeInfo info,
                                        std::uint32_t first, std::uint32_t count);

/// Returns the description of `all` by that of a component. remedy: of rows that are then too long,
/// for the VolumeError.
VolumeInfo of_all_components(const std::string& file, VolumeInfo info, std::uint64_t count,
                             const std::string& remedy = "crop the volume");

/// Returns the channel of a volume whose channels are samples side by side. open: opens what holds
/// all of them, by its description.
std::unique_ptr<VolumeReader> channel_of(
    const std::string& file, VolumeInfo info, std::optional<std::uint32_t> channel,
    const std::function<std::unique_ptr<VolumeReader>(VolumeInfo all)>& open);

}  // namespace discmc::command

#endif

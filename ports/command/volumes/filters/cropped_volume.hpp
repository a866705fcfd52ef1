// A part of a volume as a volume of its own, which lies where the part does.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_CROPPED_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_CROPPED_VOLUME_HPP

#include <filesystem>
#include <memory>

#include "volumes/volume.hpp"

namespace discmc::command {

/// Slices before the part are skipped, and those behind it are not read. Damage there is not found,
/// and a program that writes into a pipe finds it closed. Holds one slice of the volume. Throws a
/// VolumeError where the part is not within the volume. file: for errors.
std::unique_ptr<VolumeReader> cropped(const std::filesystem::path& file,
                                      std::unique_ptr<VolumeReader> volume, const Crop& crop);

}  // namespace discmc::command

#endif

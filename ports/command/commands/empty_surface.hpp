// What is said where a threshold leaves no surface, or takes the whole volume.
#ifndef DISCMC_COMMAND_COMMANDS_EMPTY_SURFACE_HPP
#define DISCMC_COMMAND_COMMANDS_EMPTY_SURFACE_HPP

#include <string>

#include "arguments.hpp"
#include "statistics/measured_volume.hpp"

namespace discmc::host {

/// Says why the surface of the volume is empty, with the range of the values. volume: has been
/// read.
std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const Selection& selection, const MeasuredVolume& volume);

/// Throws a VolumeError that says so, where there is --allow-empty.
[[noreturn]] void fail_empty(const std::string& path, const VolumeArguments& arguments,
                             const Selection& selection, const MeasuredVolume& volume);

/// Says that the surface is a box, and why, with the range of the values. volume: has been read,
/// and every voxel of it is on.
void note_full(const std::string& path, const Selection& selection, const MeasuredVolume& volume);

}  // namespace discmc::host

#endif

// What is said where a threshold leaves no surface.
#ifndef DISCMC_COMMAND_COMMANDS_EMPTY_SURFACE_HPP
#define DISCMC_COMMAND_COMMANDS_EMPTY_SURFACE_HPP

#include <string>

#include "arguments.hpp"

namespace discmc::host {

/// Says why the surface of the volume is empty, with the range of the values; for these the volume
/// is read again, if it can be.
std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const Selection& selection);

/// Throws a VolumeError that says so, where there is --allow-empty.
[[noreturn]] void fail_empty(const std::string& path, const VolumeArguments& arguments,
                             const Selection& selection);

}  // namespace discmc::host

#endif

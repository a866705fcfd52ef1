// The messages for a surface that is empty, or is the box of the whole volume.
#pragma once

#include <string>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "statistics/measured_volume.hpp"

namespace discmc::command {

/// Returns why the surface of the volume is empty, with the range of the values. volume: has been
/// read. is_full: whether every voxel is known to be on.
std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const NamedSelection& surface, const MeasuredVolume& volume,
                      bool is_full = false);

/// Throws the message of why_empty(), with --allow-empty as a remedy.
[[noreturn]] void fail_empty(const std::string& path, const VolumeArguments& arguments,
                             const NamedSelection& surface, const MeasuredVolume& volume,
                             bool is_full = false);

/// Throws as fail_empty() if the surface is empty without --allow-empty, and prints a note if it is
/// the box of the volume. extraction: of the volume, which has been read.
void check_surface(const std::string& path, const VolumeArguments& arguments,
                   const NamedSelection& surface, const MeasuredVolume& volume,
                   const Extraction& extraction);

}  // namespace discmc::command

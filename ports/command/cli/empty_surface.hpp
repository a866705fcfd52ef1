// The messages for a surface that is empty, or that is the box of the whole volume.
#pragma once

#include <string>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "statistics/measured_volume.hpp"

namespace discmc::command {

/// Returns why the surface of the volume is empty, with the range of the values. volume: read to
/// its end. is_full: whether every voxel is certain to be on.
std::string why_empty(const std::string& path, const VolumeArguments& arguments,
                      const NamedSelection& surface, const MeasuredVolume& volume,
                      bool is_full = false);

/// Throws the message of why_empty(), with --allow-empty as a remedy.
[[noreturn]] void fail_empty(const std::string& path, const VolumeArguments& arguments,
                             const NamedSelection& surface, const MeasuredVolume& volume,
                             bool is_full = false);

/// Throws like fail_empty() if the surface is empty without --allow-empty. Prints a note if the
/// surface is the box of the volume. extraction: of the volume, read to its end.
void check_surface(const std::string& path, const VolumeArguments& arguments,
                   const NamedSelection& surface, const MeasuredVolume& volume,
                   const Extraction& extraction);

}  // namespace discmc::command

// Writes volumes as NIfTI-2 files.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>

#include "volumes/volume.hpp"

namespace discmc::command {

/// Writes the volume as one file, with its scale and place. A volume without a space gets the
/// scanner's. volume: not yet read; this function reads all of it. progress: called with the number
/// of slices written.
void write_nifti(VolumeReader& volume, const std::function<void(std::uint32_t)>& progress,
                 std::ostream& out);

/// Returns the size of this file. Units: bytes.
std::uint64_t nifti_bytes(const VolumeInfo& info);

}  // namespace discmc::command

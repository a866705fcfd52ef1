// Volumes as NIfTI-2 files.
#pragma once

#include <cstdint>
#include <functional>
#include <ostream>

#include "volumes/volume.hpp"

namespace discmc::command {

/// Writes the volume as one file, with its scale and where it lies. A volume without a frame
/// lies in that of the format. volume: not yet read; is at the end. progress: called with the
/// number of slices that are written.
void write_nifti(VolumeReader& volume, const std::function<void(std::uint32_t)>& progress,
                 std::ostream& out);

/// How many bytes that are.
std::uint64_t nifti_bytes(const VolumeInfo& info);

}  // namespace discmc::command

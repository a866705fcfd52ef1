// The names of labels in the extensions of a NIfTI header.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NIFTI_LABEL_EXTENSION_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NIFTI_LABEL_EXTENSION_HPP

#include <cstdint>

#include "volumes/volume_info.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

/// Reads the extensions behind a header, up to `end`, and adds their labels: those of Connectome
/// Workbench and Caret, whose XML TotalSegmentator writes as well. What is of no use is left, and
/// so is an extension that does not fit. stream: right behind the header; is then anywhere up to
/// the end. Units: bytes of the stream.
void read_label_extensions(ByteStream& stream, std::uint64_t end, bool is_big_endian,
                           VolumeInfo& info);

}  // namespace discmc::command

#endif

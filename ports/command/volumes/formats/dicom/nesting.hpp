// How deep the sequences of a DICOM file are nested.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_NESTING_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_NESTING_HPP

#include <cstdint>
#include <filesystem>

namespace discmc::command {

/// Whether no item of a sequence is within more than `most` others. DCMTK reads every level with a
/// call in the one around it, without a limit of its own. A small file could use up the stack. By
/// the bytes of items alone, without regard to what is around them.
bool is_nested_within(std::uint32_t most, const std::filesystem::path& file);

}  // namespace discmc::command

#endif

// Which of several DICOM volumes is meant.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_CHOICE_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_CHOICE_HPP

#include <cstdint>
#include <filesystem>
#include <vector>

#include "stack.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// A stack, and of how many that the choice of the series leaves.
struct ChosenStack {
  const DicomStack* stack = nullptr;
  std::uint64_t among = 1;
};

/// Returns the stack of the series, given by its UID or by its place in the list, from 1; the only
/// stack also without it. The frame chooses one of several in a series; the first is 0. Throws
/// VolumeError, with the list, where none is meant or several are.
ChosenStack chosen_stack(const std::filesystem::path& source, const std::vector<DicomStack>& stacks,
                         const VolumeOptions& options);

}  // namespace discmc::command

#endif

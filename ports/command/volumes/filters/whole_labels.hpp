// A volume of labels in whole numbers, whatever they are stored as.
#ifndef DISCMC_COMMAND_VOLUMES_FILTERS_WHOLE_LABELS_HPP
#define DISCMC_COMMAND_VOLUMES_FILTERS_WHOLE_LABELS_HPP

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "volumes/volume.hpp"

namespace discmc::command {

/// The label of a value: the whole number within 0.01 of it. Nothing
/// if there is none, or from 2^53 on, where double rounds some.
std::optional<std::int64_t> nearest_label(double value);

/// The volume with its values as samples: slope 1, intercept 0. Whole numbers stay as they are, up
/// to all 64 bits. Others become i64, each its nearest_label(), and NaN becomes 0. Notes after the
/// last slice count the rounded values and those that are no numbers. Throws VolumeError in
/// read_slice() where a value is of no label. file: for errors.
std::unique_ptr<VolumeReader> whole_labels(const std::filesystem::path& file,
                                           std::unique_ptr<VolumeReader> volume);

}  // namespace discmc::command

#endif

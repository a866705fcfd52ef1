// The volume of a command: opened as its arguments say, and how its surface is taken.
#ifndef DISCMC_COMMAND_COMMANDS_VOLUME_INPUT_HPP
#define DISCMC_COMMAND_COMMANDS_VOLUME_INPUT_HPP

#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "progress.hpp"
#include "volumes/volume.hpp"

namespace discmc::host {

/// Nothing where the file has a header.
std::optional<RawLayout> raw_layout(const LayoutArguments& arguments);

/// Opens the volume, and says what of its file is dropped.
std::unique_ptr<VolumeReader> open_noted_volume(const std::string& path,
                                                const VolumeArguments& arguments);

/// At the first threshold. progress: has to live as long as the options are in use.
ExtractionOptions extraction_options(const VolumeInfo& info, const VolumeArguments& arguments,
                                     Progress& progress);

}  // namespace discmc::host

#endif

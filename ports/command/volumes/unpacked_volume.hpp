// Volumes whose readers take files alone, out of something that is packed.
#ifndef DISCMC_COMMAND_VOLUMES_UNPACKED_VOLUME_HPP
#define DISCMC_COMMAND_VOLUMES_UNPACKED_VOLUME_HPP

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>

#include "volume_reader.hpp"
#include "volume_stream.hpp"

namespace discmc::command {

/// The volume of files that `open` unpacks into a folder for temporary files and opens. They are
/// removed when it is closed, and bear the name of what was packed in errors. packing: for people,
/// behind the format.
std::unique_ptr<VolumeReader> unpacked_volume(
    const std::filesystem::path& packed, std::string_view packing,
    const std::function<std::unique_ptr<VolumeReader>(const std::filesystem::path& folder)>& open);

/// Writes what is left of a stream into a file, for which folders are made.
void unpack(ByteStream& stream, const std::filesystem::path& file);

}  // namespace discmc::command

#endif

// Files that are packed as a whole, whatever is in them: a.nii.gz, a.nrrd.zst.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "byte_source.hpp"

namespace discmc::command {

enum class Packing : std::uint8_t { gzip, bzip2, xz, zstd, lz4 };

std::string_view name(Packing packing);

/// Returns how a file is packed, by its first bytes. Limit: head has packing_magic_bytes, fewer
/// where there are no more.
std::optional<Packing> packing_of(std::string_view head);
constexpr std::size_t packing_magic_bytes = 6;

/// The endings of names, with that of a file that is not packed.
constexpr std::string_view packed_endings[] = {"", ".gz", ".bz2", ".xz", ".zst", ".lz4"};

/// Returns how a file is packed, by its name.
std::optional<Packing> packing_of_name(const std::filesystem::path& file);

/// Returns the name without the ending of a packed file: a.nii of a.nii.gz.
std::filesystem::path without_packing(const std::filesystem::path& file);

/// The content of what is packed. file: for the VolumeError thrown where discmc was built without
/// what unpacks it.
std::unique_ptr<ByteSource> unpacked(std::unique_ptr<ByteSource> in, Packing packing,
                                     const std::filesystem::path& file);

}  // namespace discmc::command

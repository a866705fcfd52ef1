// Files that are packed as a whole: a.nii.gz, a.nrrd.zst.
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

/// Returns the packing of a file by its first bytes. Limit: packing_magic_bytes bytes, fewer in a
/// shorter file.
std::optional<Packing> packing_of(std::string_view head);
constexpr std::size_t packing_magic_bytes = 6;

/// The endings of packed names; the first is for files that are not packed.
constexpr std::string_view packed_endings[] = {"", ".gz", ".bz2", ".xz", ".zst", ".lz4"};

/// Returns the packing of a file by its name.
std::optional<Packing> packing_of_name(const std::filesystem::path& file);

/// Returns the name without the ending of the packing: a.nii for a.nii.gz.
std::filesystem::path without_packing(const std::filesystem::path& file);

/// Unpacks a source. file: for the VolumeError in builds without the packing.
std::unique_ptr<ByteSource> unpacked(std::unique_ptr<ByteSource> in, Packing packing,
                                     const std::filesystem::path& file);

}  // namespace discmc::command

// Finds DICOM files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace discmc::command {

/// Units: bytes from the beginning of a file that identify it as DICOM.
constexpr std::size_t dicom_head_bytes = 256;

/// Whether the first bytes are DICOM: they have the magic number, or begin directly with elements,
/// as some programs write them.
bool is_dicom_head(std::string_view head);

/// Whether the name is usual for DICOM files.
bool has_dicom_name(const std::filesystem::path& file);

/// Returns the files of a folder and its subfolders, ordered by name. Omits hidden files, whose
/// names begin with a dot.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// Likewise returns only DICOM files, including packed ones.
std::vector<std::filesystem::path> dicom_files(const std::filesystem::path& folder);

/// Likewise returns only links without a target.
std::vector<std::filesystem::path> dead_links(const std::filesystem::path& folder);

/// Whether sequences are nested at most this deep. DCMTK reads each level by recursion without
/// a limit, so a small file could exhaust the stack. This counts the bytes of items, without regard
/// to their context.
bool is_nested_within(std::uint32_t max_depth, const std::filesystem::path& file);

}  // namespace discmc::command

// Which files are DICOM.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

namespace discmc::command {

/// Units: bytes from the beginning of a file that identify it as DICOM.
constexpr std::size_t dicom_head_bytes = 256;

/// Whether a file that begins so is DICOM: with its magic, or with elements at once, as some write
/// it.
bool is_dicom_head(std::string_view head);

/// Whether a file is named as DICOM files are.
bool has_dicom_name(const std::filesystem::path& file);

/// Returns the files of a folder and of all folders in it, by their names. Hidden files, whose
/// names begin with a dot, are left out.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);

/// The same of DICOM files, packed ones too.
std::vector<std::filesystem::path> dicom_files(const std::filesystem::path& folder);

/// The same of links that lead nowhere.
std::vector<std::filesystem::path> dead_links(const std::filesystem::path& folder);

/// Whether no item of a sequence is within more than `most` others. DCMTK reads every level with a
/// call in the one around it, without a limit of its own. A small file could use up the stack. By
/// the bytes of items alone, without regard to what is around them.
bool is_nested_within(std::uint32_t most, const std::filesystem::path& file);

}  // namespace discmc::command

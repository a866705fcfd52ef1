// What SkyScan's reconstruction program, NRecon, writes beside its slices.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace discmc::command {

/// Whether the name is that of an overview, no slice: x_rec_spr.bmp.
bool is_overview_name(const std::filesystem::path& file);

/// A log of a reconstruction.
struct SkyScanLog {
  std::filesystem::path file;
  std::array<double, 3> spacing_mm{};
  /// Width and height of the slices; 0 if the log lacks them.
  std::array<std::uint32_t, 2> size{};
};

/// Returns the log of a stack, by one of its slices: beside it, and called as it begins. Nothing
/// if there is none with a pixel size.
std::optional<SkyScanLog> skyscan_log(const std::filesystem::path& slice);

}  // namespace discmc::command

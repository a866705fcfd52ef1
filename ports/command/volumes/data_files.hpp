// Volumes whose samples are in several files, most often one file per slice.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

#include "volume_stream.hpp"

namespace discmc::command {

/// Files beside a header, in the order of their samples.
struct DataFiles {
  std::uint64_t count = 0;
  std::function<std::filesystem::path(std::uint64_t)> path;
};

/// Whether a header names several files: a LIST, or a pattern with a number.
bool names_several_files(std::string_view text);

/// Returns the files that a header names: in the lines that follow, or by a pattern and a range
/// such as "slice%03d.raw 1 4 1". field: the name of the field, for the VolumeError if the text is
/// neither.
DataFiles data_files(ByteStream& header, std::string_view field, std::string_view text);

/// Joins the samples of all files, each with an equal share of the volumes. open: returns a file at
/// its first sample. A file with more samples than its share is refused. If something before the
/// samples was skipped, the surplus is noted instead.
ByteStream joined(const std::filesystem::path& header, const DataFiles& files, VolumeInfo& info,
                  std::function<ByteStream(const std::filesystem::path&)> open);

}  // namespace discmc::command

// Archives of ZIP, made in memory.
#pragma once

#include <archive.h>
#include <archive_entry.h>

#include "volume_files.hpp"

namespace volume_files {

/// Names and contents.
using Members = std::vector<std::pair<std::string, std::string>>;

inline std::string zip(const Members& members) {
  std::string bytes(1 << 20, '\0');
  std::size_t used = 0;
  archive* const writer = archive_write_new();
  archive_write_set_format_zip(writer);
  archive_write_open_memory(writer, bytes.data(), bytes.size(), &used);
  for (const auto& [name, content] : members) {
    archive_entry* const entry = archive_entry_new();
    archive_entry_set_pathname(entry, name.c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    REQUIRE(archive_write_header(writer, entry) == ARCHIVE_OK);
    archive_write_data(writer, content.data(), content.size());
    archive_entry_free(entry);
  }
  archive_write_free(writer);
  bytes.resize(used);
  return bytes;
}

/// The files of a folder and its folders, by name.
inline Members members_of(const fs::path& folder, const std::string& prefix) {
  Members members;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      members.emplace_back(prefix + fs::relative(entry.path(), folder).string(),
                           contents(entry.path()));
  std::sort(members.begin(), members.end());
  return members;
}

}  // namespace volume_files

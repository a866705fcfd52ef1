#include "files.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

#include "text/words.hpp"
#include "volumes/packing.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

using Path = std::filesystem::path;

// Those of macOS beside files of the same names, and of git annex, hold no images of their own.
bool is_hidden(const Path& file) {
  return file.filename().native().rfind('.', 0) == 0;
}

// Calls with every entry of a folder and of the folders in it, but for hidden ones.
template <class Call>
void for_each_entry(const Path& folder, Call call) {
  using Iterator = std::filesystem::recursive_directory_iterator;
  std::error_code error;
  for (Iterator entry(folder, std::filesystem::directory_options::skip_permission_denied, error);
       !error && entry != Iterator(); entry.increment(error)) {
    if (is_hidden(entry->path()))
      entry.disable_recursion_pending();
    else
      call(*entry);
  }
  if (error)
    fail(folder, "the folder cannot be listed (" + error.message() + ")", "check its permissions");
}

bool is_dicom(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(dicom_magic_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
  if (packing_of_name(file) && packing_of(head))
    return has_dicom_name(without_packing(file)) ||
           has_dicom_magic(open_content(file).peek(dicom_magic_bytes));
  return has_dicom_magic(head) || has_dicom_name(file);
}

}  // namespace

bool has_dicom_magic(std::string_view head) {
  return head.size() >= dicom_magic_bytes && head.substr(dicom_magic_bytes - 4, 4) == "DICM";
}

bool has_dicom_name(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".dcm" || extension == ".ima";
}

std::vector<Path> dicom_files(const Path& folder) {
  std::vector<Path> files;
  for_each_entry(folder, [&](const std::filesystem::directory_entry& entry) {
    std::error_code unknown;
    if (entry.is_regular_file(unknown) && is_dicom(entry.path())) files.push_back(entry.path());
  });
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Path> dead_links(const Path& folder) {
  std::vector<Path> links;
  for_each_entry(folder, [&](const std::filesystem::directory_entry& entry) {
    std::error_code unknown;
    if (entry.is_symlink(unknown) && !entry.exists(unknown)) links.push_back(entry.path());
  });
  std::sort(links.begin(), links.end());
  return links;
}

}  // namespace discmc::command

#include "files.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <system_error>

#include "text/words.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

bool is_dicom(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string head(dicom_magic_bytes, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(in.gcount()));
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

std::vector<std::filesystem::path> dicom_files(const std::filesystem::path& folder) {
  using Iterator = std::filesystem::recursive_directory_iterator;
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (Iterator entry(folder, std::filesystem::directory_options::skip_permission_denied, error);
       !error && entry != Iterator(); entry.increment(error)) {
    std::error_code unknown;
    if (entry->is_regular_file(unknown) && is_dicom(entry->path())) files.push_back(entry->path());
  }
  if (error)
    fail(folder, "the folder cannot be listed (" + error.message() + ")", "check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace discmc::command

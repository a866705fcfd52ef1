#include "sources.hpp"

#include <cstdlib>
#include <system_error>

namespace discmc::command {
namespace {

// A text of the library. get(text, bytes): writes as much as there is room for, and returns how
// long the text is.
template <class Get>
std::string text_of(Get get) {
  const ssize_t length = get(nullptr, 0);
  if (length <= 0) return {};
  std::string text(static_cast<std::size_t>(length), '\0');
  get(text.data(), text.size() + 1);
  return text;
}

// Where the library looks for a source.
bool is_there(const std::filesystem::path& source, const std::filesystem::path& folder) {
  const auto exists = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
  };
  const char* const prefix = std::getenv("HDF5_VDS_PREFIX");
  return exists(source) || exists(folder / source) || exists(folder / source.filename()) ||
         (prefix != nullptr && exists(std::filesystem::path(prefix) / source));
}

}  // namespace

std::filesystem::path file_of(const Hdf5Handle& dataset) {
  return text_of(
      [&](char* text, std::size_t bytes) { return H5Fget_name(dataset.id(), text, bytes); });
}

std::optional<std::string> missing_source(const Hdf5Handle& dataset) {
  const Hdf5Handle creation(H5Dget_create_plist(dataset.id()), H5Pclose);
  if (H5Pget_layout(creation.id()) != H5D_VIRTUAL) return std::nullopt;
  const std::filesystem::path folder = file_of(dataset).parent_path();
  std::size_t count = 0;
  H5Pget_virtual_count(creation.id(), &count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string source = text_of([&](char* text, std::size_t bytes) {
      return H5Pget_virtual_filename(creation.id(), i, text, bytes);
    });
    const bool is_pattern = source.find('%') != std::string::npos;
    if (source != "." && !is_pattern && !is_there(source, folder)) return source;
  }
  return std::nullopt;
}

}  // namespace discmc::command

#include "dataset.hpp"

#include <cstdlib>
#include <set>
#include <system_error>
#include <utility>

#include "text/words.hpp"

namespace discmc::command {
namespace {

struct NamedLink {
  std::string name;
  H5L_type_t type;
  std::size_t bytes;  // of the name
};

herr_t collect(hid_t, const char* name, const H5L_info_t* info, void* links) {
  const bool has_text = info->type != H5L_TYPE_HARD;
  static_cast<std::vector<NamedLink>*>(links)->push_back(
      {name, info->type, has_text ? info->u.val_size : 0});
  return 0;
}

std::string target_of(const Hdf5Handle& group, const NamedLink& link) {
  std::string text(link.bytes, '\0');
  if (H5Lget_val(group.id(), link.name.c_str(), text.data(), text.size(), H5P_DEFAULT) < 0)
    return {};
  const char* file = text.c_str();
  const char* path = nullptr;
  if (link.type == H5L_TYPE_EXTERNAL)
    H5Lunpack_elink_val(text.data(), text.size(), nullptr, &file, &path);
  return file;
}

class Walk {
 public:
  Hdf5Contents contents(const Hdf5Handle& file) {
    visit(Hdf5Handle(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose), "", 0);
    return std::move(found_);
  }

 private:
  void visit(const Hdf5Handle& group, const std::string& path, int depth) {
    constexpr int max_depth = 64;
    if (depth == max_depth) return;
    std::vector<NamedLink> links;
    H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &links);
    for (const NamedLink& link : links) follow(group, link, path + "/" + link.name, depth);
  }

  void follow(const Hdf5Handle& group, const NamedLink& link, const std::string& path, int depth) {
    const Hdf5Handle object(H5Oopen(group.id(), link.name.c_str(), H5P_DEFAULT), H5Oclose);
    H5O_info_t info;
    if (!object || H5Oget_info(object.id(), &info) < 0) {
      if (link.type != H5L_TYPE_HARD)
        found_.dead_links.push_back(without_control(path + " to " + target_of(group, link)));
      return;
    }
    if (!seen_.emplace(file_of(object).native(), info.addr).second) return;
    if (auto dataset = description_of(object, path)) found_.datasets.push_back(std::move(*dataset));
    if (info.type == H5O_TYPE_GROUP) visit(object, path, depth + 1);
  }

  Hdf5Contents found_;
  std::set<std::pair<std::string, haddr_t>> seen_;
};

// Returns a text of the library. get(text, bytes): writes as much as fits, and returns the full
// length.
template <class Get>
std::string text_of(Get get) {
  const ssize_t length = get(nullptr, 0);
  if (length <= 0) return {};
  std::string text(static_cast<std::size_t>(length), '\0');
  get(text.data(), text.size() + 1);
  return text;
}

// Whether the library would find a source.
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

Hdf5Contents hdf5_contents(const Hdf5Handle& file) {
  return Walk().contents(file);
}

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

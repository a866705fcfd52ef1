// A zip of DICOM or pictures: unpacked into a temporary folder and read from there.
#include "volumes/formats/readers.hpp"

#ifdef DISCMC_WITH_LIBARCHIVE
#include <archive.h>

#include <string>
#include <vector>

#include "text/words.hpp"
#include "volumes/archive_source.hpp"
#include "volumes/formats/dicom/files.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#include "volumes/header_fields.hpp"
#include "volumes/unpacked_volume.hpp"
#endif

namespace discmc::command {

std::optional<std::filesystem::path> archive_of(const std::filesystem::path& name) {
  for (std::filesystem::path file = name; file.has_relative_path(); file = file.parent_path())
    if (is_file(file)) return file;
  return std::nullopt;
}

#ifdef DISCMC_WITH_LIBARCHIVE
namespace {

// Returns a member's path in the folder, without parts that would leave it. Returns an empty path
// for what macOS adds to archives.
std::filesystem::path inner_path(const std::string& name) {
  std::filesystem::path inner;
  for (const std::filesystem::path& part : std::filesystem::path(name)) {
    if (part == "__MACOSX" || part == ".DS_Store" || part.native().rfind("._", 0) == 0) return {};
    if (part != "/" && part != "." && part != "..") inner /= part;
  }
  return inner;
}

void unpack_member(const std::filesystem::path& zip, ArchiveSource& archive,
                   const std::filesystem::path& file) {
  const bool is_written =
      write_bytes(file, [&](void* bytes, std::size_t count) { return archive.read(bytes, count); });
  if (!archive.damage().empty())
    fail(zip, shown(file.filename().string()) + " in the archive is damaged or encrypted",
         "copy or export the archive again, without a password");
  if (!is_written)
    fail(zip, shown(file.filename().string()) + " cannot be unpacked into the temporary folder",
         "set TMPDIR to a folder with more space, or unpack the archive and give the folder");
}

void unpack(const std::filesystem::path& zip, const std::filesystem::path& folder) {
  ArchiveSource archive(zip, [](auto* reader) { archive_read_support_format_zip(reader); });
  while (const auto member = archive.next_member()) {
    const std::filesystem::path name = inner_path(without_control(*member));
    if (name.has_filename()) unpack_member(zip, archive, folder / name);
  }
  if (!archive.damage().empty())
    fail(zip, "the archive is damaged, or not a ZIP file", "copy or export it again");
}

// Finds the folder of pictures: descends while a folder is the only content, except files that are
// not pictures.
std::filesystem::path picture_folder(std::filesystem::path folder) {
  for (;;) {
    std::vector<std::filesystem::path> folders;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.is_directory())
        folders.push_back(entry.path());
      else if (is_picture_name(entry.path()))
        return folder;
    }
    if (folders.size() != 1) return folder;
    folder = folders.front();
  }
}

std::unique_ptr<VolumeReader> open_inside(const std::filesystem::path& zip,
                                          const std::filesystem::path& folder,
                                          const VolumeOptions& options) {
  const auto zarr = folder_of_zarr(folder);
  if (zarr) return open_zarr(*zarr, options);
  const auto dicom = dicom_files(folder);
  const auto pictures = picture_folder(folder);
  const bool are_there = !picture_files(pictures).empty() || !mask_files(pictures).empty();
  return open_folder(dicom.empty() && are_there ? pictures : folder, dicom, options,
                     "give a pattern, such as '" + (zip / "*.png").string() + "'");
}

// Removes options that apply once to any volume.
VolumeOptions whole(VolumeOptions options) {
  options.crop.reset();
  options.shrink = 1;
  options.holds_labels = false;
  return options;
}

}  // namespace

std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file,
                                       const VolumeOptions& options) {
  const auto zip = archive_of(file);
  return unpacked_volume(*zip, "zip", [&](const std::filesystem::path& folder) {
    unpack(*zip, folder);
    if (*zip == file) return open_inside(*zip, folder, options);
    const std::filesystem::path inner = file.lexically_relative(*zip);
    if (leads_out(inner.native()))
      fail(file, "the name leads out of the archive", "name a file in it");
    const bool is_pattern = inner.native().find_first_of("*?[") != std::string::npos;
    return is_pattern ? open_pattern(folder / inner, options)
                      : open_volume(folder / inner, whole(options));
  });
}
#else
std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file, const VolumeOptions&) {
  fail(file, "this discmc was built without libarchive", "unpack it and give the folder");
}
#endif

}  // namespace discmc::command

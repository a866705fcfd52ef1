#include "volume.hpp"

#include <glob.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <system_error>
#include <utility>

#include "other_kinds.hpp"
#include "volume_format.hpp"
#include "volumes/filters/cropped_volume.hpp"
#include "volumes/filters/shrunk_volume.hpp"
#include "volumes/formats/dicom/files.hpp"
#include "volumes/formats/hdf5/name.hpp"
#include "volumes/formats/pictures/picture_names.hpp"

namespace discmc::command {
namespace {

using Ends = std::initializer_list<std::string_view>;

// By the names that format_of_magic() has for them.
struct Format {
  std::string_view name;
  Ends ends;
  std::unique_ptr<VolumeReader> (*open)(ByteStream stream, const VolumeOptions& options);
};
const Format formats[] = {
    {"NRRD", {".nrrd", ".nhdr"}, open_nrrd},
    {"MetaImage", {".mha", ".mhd"}, open_metaimage},
    {"NIfTI", {".nii", ".nii.gz", ".hdr", ".hdr.gz", ".img", ".img.gz"}, open_nifti},
    {"VTK", {".vtk"}, open_vtk},
    {"VTK XML", {".vti"}, open_vti},
    {"NumPy", {".npy"}, open_numpy},
    {"InVesalius", {".inv3"}, open_invesalius},
};

// Headerless samples, and what they may be called though others have a header.
const Ends raw_ends = {".raw", ".raw.gz"};
const Ends headerless_ends = {".raw", ".raw.gz", ".img", ".img.gz"};

bool ends_with_one_of(const std::filesystem::path& file, Ends ends) {
  const std::string name = lower(file.filename().string());
  const std::string_view text = name;
  return std::any_of(ends.begin(), ends.end(), [text](std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
  });
}

// Files that a shell would find by the name, where it was quoted.
std::vector<std::filesystem::path> files_of_pattern(const std::filesystem::path& pattern) {
  glob_t found{};
  std::vector<std::filesystem::path> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  if (files.empty()) fail(pattern, "no file has such a name", "check it");
  return files;
}

std::unique_ptr<VolumeReader> open_pattern(const std::filesystem::path& pattern,
                                           const VolumeOptions& options) {
  const auto files = files_of_pattern(pattern);
  const auto other = std::find_if_not(files.begin(), files.end(), is_picture_name);
  if (other == files.end()) return open_pictures(pattern, files, options);
  if (std::any_of(files.begin(), files.end(), is_picture_name))
    fail(pattern,
         "there are PNG or TIFF files of such a name, and others, such as " +
             shown(other->filename().string()),
         "give a pattern of one kind, such as '*.png'");
  return open_dicom(pattern, files, options);
}

bool is_folder(const std::filesystem::path& file) {
  std::error_code ignored;
  return std::filesystem::is_directory(file, ignored);
}

bool is_pattern(const std::filesystem::path& file) {
  std::error_code ignored;
  return file.native().find_first_of("*?[") != std::string::npos &&
         !std::filesystem::exists(file, ignored);
}

void require_headerless_name(const std::filesystem::path& file) {
  if (is_volume_name(file) && !ends_with_one_of(file, headerless_ends))
    fail(file, "the name is that of a format with a header, which --dims and --type are not for",
         "leave them out, or name headerless samples .raw");
}

std::unique_ptr<VolumeReader> open_as_told(const std::filesystem::path& file,
                                           const VolumeOptions& options) {
  if (options.layout) {
    require_headerless_name(file);
    return open_raw(ByteStream(file), *options.layout);
  }
  if (is_folder(file))
    return open_folder(file, dicom_files(file), options, "give a pattern, such as '*.png'");
  if (is_pattern(file)) return open_pattern(file, options);
  if (is_picture_name(file)) return open_pictures(file, {file}, options);
  if (has_dicom_name(file)) return open_dicom(file, {file}, options);
  if (has_zip_name(file)) return open_zip(file, options);
  if (has_hdf5_name(file)) return open_hdf5(file, options);

  ByteStream stream = open_content(file);
  for (const Format& format : formats)
    if (ends_with_one_of(file, format.ends)) return format.open(std::move(stream), options);
  if (is_stream_name(file))
    fail(file, "this is a stream, not a volume", "give it to discmc decode, info or render");
  if (is_mesh_name(file))
    fail(file, "this is a mesh, not a volume",
         std::string("give the volume that it was made of; ") + who_takes_meshes);
  const auto found = format_of_magic(stream);
  for (const Format& format : formats)
    if (found == format.name) return format.open(std::move(stream), options);
  const bool is_bare_file = !stream.is_decoded() && !stream.is_read_once();
  if (found == "DICOM" && is_bare_file) return open_dicom(file, {file}, options);
  if (found == "zip" && is_bare_file) return open_zip(file, options);
  if (found == "HDF5" && is_bare_file) return open_hdf5(file, options);
  if (!is_bare_file && (found == "DICOM" || found == "zip" || found == "HDF5"))
    fail(file, std::string(*found) + " is not read from a pipe, nor packed",
         "store it in a file, unpacked");
  fail(
      stream.file(), found ? std::string(*found) + " is not read" : "the format is not known",
      "convert it, e.g. to NRRD or NIfTI, or give the layout of headerless samples with --dims and "
      "--type");
}

// A volume whose spacing is said to be another than its file has it.
class RespacedVolume final : public VolumeReader {
 public:
  RespacedVolume(std::unique_ptr<VolumeReader> volume, std::array<double, 3> spacing_mm)
      : volume_(std::move(volume)), info_(volume_->info()) {
    const std::array<double, 3> told = info_.spacing_mm;
    for (std::size_t axis = 0; axis < 3; ++axis) spacing_mm[axis] *= std::copysign(1.0, told[axis]);
    set_spacing(info_, spacing_mm);
    std::vector<std::string>& notes = info_.notes;
    notes.erase(std::remove(notes.begin(), notes.end(), no_spacing_note), notes.end());
    if (!info_.placement) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (double& along : info_.placement->axes_mm[axis])
        along *= std::fabs(info_.spacing_mm[axis] / told[axis]);
  }

  const VolumeInfo& info() const override { return info_; }
  void read_slice(void* samples) override { volume_->read_slice(samples); }
  void skip_slice() override { volume_->skip_slice(); }

 private:
  std::unique_ptr<VolumeReader> volume_;
  VolumeInfo info_;
};

void require_no_dicom_options(const std::filesystem::path& file, const VolumeReader& volume,
                              const VolumeOptions& options) {
  const std::string given = !options.series.empty()                 ? "--series"
                            : options.merges_series                 ? "--merge-series"
                            : options.order != SliceOrder::position ? "--order"
                                                                    : "";
  if (!given.empty())
    fail(file, given + " is for DICOM, but this is " + volume.info().format, "leave out " + given);
}

std::vector<std::string> notes_of_left_out(const std::vector<std::filesystem::path>& pictures,
                                           const std::string& remedy) {
  if (pictures.empty()) return {};
  return {"PNG or TIFF files beside the DICOM left out: " + std::to_string(pictures.size()) +
          ", such as " + shown(pictures[0].filename().string()) + "; to read them " + remedy};
}

std::string text_of_dead(const std::vector<std::filesystem::path>& links) {
  if (links.empty()) return {};
  return "links that lead nowhere: " + std::to_string(links.size()) + ", such as " +
         shown(links[0].filename().string());
}

}  // namespace

std::unique_ptr<VolumeReader> open_folder(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& dicom,
                                          const VolumeOptions& options,
                                          const std::string& remedy_of_pictures) {
  const auto pictures = picture_files(folder);
  const std::string dead = text_of_dead(dead_links(folder));
  if (!dicom.empty()) {
    auto notes = notes_of_left_out(pictures, remedy_of_pictures);
    if (!dead.empty()) notes.push_back(dead);
    return open_dicom(folder, dicom, options, notes);
  }
  if (!pictures.empty()) return open_pictures(folder, pictures, options);
  if (!dead.empty()) fail(folder, dead, "copy what they lead to, as with: git annex get, or cp -L");
  fail(folder, "the folder holds no DICOM, PNG or TIFF files",
       "name a file, or the folder of a series");
}

bool is_volume_name(const std::filesystem::path& file) {
  return ends_with_one_of(file, raw_ends) || has_dicom_name(file) || is_picture_name(file) ||
         has_zip_name(file) || has_hdf5_name(file) || is_folder(file) ||
         std::any_of(std::begin(formats), std::end(formats),
                     [&file](const Format& format) { return ends_with_one_of(file, format.ends); });
}

std::unique_ptr<VolumeReader> open_volume(const std::filesystem::path& file,
                                          const VolumeOptions& options) {
  auto volume = open_as_told(file, options);
  if (options.frame.value_or(0) >= volume->info().frames)
    fail(file, "this is one volume, and volume " + std::to_string(*options.frame) + " is asked for",
         "leave out --frame");
  if (volume->info().format.rfind("DICOM", 0) != 0)
    require_no_dicom_options(file, *volume, options);
  if (options.spacing_mm)
    volume = std::make_unique<RespacedVolume>(std::move(volume), *options.spacing_mm);
  if (options.crop) volume = cropped(file, std::move(volume), *options.crop);
  if (options.shrink > 1)
    volume = shrunk(file, std::move(volume), options.shrink, options.block_value);
  return volume;
}

}  // namespace discmc::command

#include "volume.hpp"

#include <glob.h>

#include <algorithm>
#include <initializer_list>
#include <system_error>
#include <utility>

#include "array_name.hpp"
#include "format_list.hpp"
#include "text/words.hpp"
#include "unpacked_volume.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/dicom/files.hpp"
#include "volumes/formats/pictures/picture_names.hpp"
#include "volumes/formats/readers.hpp"

namespace discmc::command {
namespace {

// Whether the name may be that of headerless samples, although some such files have a header.
bool is_raw_name(const std::filesystem::path& file) {
  return lower(without_packing(file).extension().string()) == ".raw";
}

bool may_be_headerless(const std::filesystem::path& file) {
  const VolumeFormat* const format = format_of_name(file);
  return format == nullptr || !is_read(*format) ||
         lower(without_packing(file).extension().string()) == ".img";
}

// Returns the files of a quoted pattern, as a shell would find them.
std::vector<std::filesystem::path> files_of_pattern(const std::filesystem::path& pattern) {
  glob_t found{};
  std::vector<std::filesystem::path> files;
  if (glob(pattern.c_str(), 0, nullptr, &found) == 0)
    files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
  globfree(&found);
  files.erase(std::remove_if(files.begin(), files.end(), is_system_name), files.end());
  if (files.empty()) fail(pattern, "no file matches the pattern", "check the pattern");
  return files;
}

std::unique_ptr<VolumeReader> open_by_kind(const std::filesystem::path& file,
                                           const VolumeOptions& options);

// Lists paths for the user to choose from.
std::string list_of(std::vector<std::filesystem::path> files) {
  sort_naturally(files);
  constexpr std::size_t max_listed = 10;
  std::string text = std::to_string(files.size()) + ", such as ";
  for (std::size_t i = 0; i < std::min(files.size(), max_listed); ++i)
    text += (i > 0 ? ", " : "") + without_control(files[i].string());
  return text;
}

// Masks are labels. Commands without labels require one of the files.
std::unique_ptr<VolumeReader> open_requested_masks(const std::filesystem::path& source,
                                                   const std::vector<std::filesystem::path>& files,
                                                   const VolumeOptions& options,
                                                   const std::vector<std::string>& notes = {}) {
  if (files.size() == 1) return open_by_kind(files[0], options);
  if (options.holds_labels || options.frame) return open_masks(source, files, options, notes);
  fail(source, "several volumes: " + list_of(files),
       "name one file, or read each file as a label with --labels all or --label NAME");
}

// Decides by the first bytes, because names of pictures may lack an extension. BMP has too few
// bytes.
bool is_picture(const std::filesystem::path& file) {
  const PictureKind kind = kind_of_head(ByteStream(file).peek(picture_magic_bytes));
  return kind != PictureKind::none && kind != PictureKind::bmp;
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
  if (!may_be_headerless(file) || is_folder(file))
    fail(file,
         "--dims and --type are for headerless samples, and this name has the extension of a "
         "format with a header",
         "leave them out, or rename headerless samples to .raw");
}

[[noreturn]] void fail_unread(const std::filesystem::path& file, const VolumeFormat* format) {
  if (format != nullptr)
    fail(file, "this is " + std::string(format->name) + ", which is not supported",
         std::string(format->remedy));
  if (is_stream_name(file))
    fail(file, "this is a stream, not a volume", "give it to discmc decode, info or render");
  if (is_mesh_name(file))
    fail(file, "this is a mesh, not a volume",
         std::string("give the volume that the mesh was made of; ") + commands_for_meshes);
  fail(file, "the format is unknown",
       "convert it, e.g. to NRRD or NIfTI, or give the layout of headerless samples with --dims "
       "and --type");
}

// Opens a packed file whose reader needs a file.
std::unique_ptr<VolumeReader> open_unpacked(ByteStream stream, const VolumeOptions& options) {
  return unpacked_volume(stream.file(), name(*stream.packing()), [&](const auto& folder) {
    const std::filesystem::path file = folder / without_packing(stream.file()).filename();
    unpack(stream, file);
    return open_by_kind(file, options);
  });
}

std::unique_ptr<VolumeReader> open_stream(ByteStream stream, const VolumeFormat& format,
                                          const VolumeOptions& options) {
  if (format.open_stream != nullptr) return format.open_stream(std::move(stream), options);
  if (!is_read(format)) fail_unread(stream.file(), &format);
  if (stream.is_read_once())
    fail(stream.file(), std::string(format.name) + " cannot be read from a pipe",
         "store it in a file");
  if (stream.packing()) return open_unpacked(std::move(stream), options);
  return format.open_file(stream.file(), options);
}

// Checks the first bytes of an existing file, whose format may differ from its name's.
void require_named_content(const std::filesystem::path& file) {
  const std::filesystem::path path = array_name(file).file;
  if (!is_file(path)) return;
  ByteStream stream(path);
  const VolumeFormat* const format = format_of_head(stream.peek(magic_bytes));
  if (format != nullptr && !is_read(*format)) fail_unread(file, format);
}

void require_no_address(const std::filesystem::path& file) {
  const std::string& text = file.native();
  const std::size_t scheme = text.find("://");
  const std::size_t letters = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789");
  if (scheme != std::string::npos && scheme > 1 && scheme == letters)
    fail(file, "this is an address, and volumes are read from files",
         "download it first, e.g. with: curl -O ADDRESS");
}

std::unique_ptr<VolumeReader> open_files(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options) {
  if (std::all_of(files.begin(), files.end(), is_mask_name))
    return open_requested_masks(source, files, options);
  const auto picture = std::find_if(files.begin(), files.end(), is_picture_name);
  const auto other = std::find_if_not(files.begin(), files.end(), is_picture_name);
  if (other == files.end()) return open_pictures(source, files, options);
  if (picture != files.end())
    fail(source, "there are pictures and other files, such as " + shown(other->filename().string()),
         "give a pattern of one kind, such as '" +
             (picture->parent_path() / ("*" + picture->extension().string())).string() + "'");
  if (is_picture(files[0])) return open_pictures(source, files, options);
  return open_dicom(source, files, options);
}

std::unique_ptr<VolumeReader> open_by_kind(const std::filesystem::path& file,
                                           const VolumeOptions& options) {
  require_no_address(file);
  if (!options.others.empty()) {
    VolumeOptions group_options = options;
    std::vector<std::filesystem::path> files = std::move(group_options.others);
    group_options.others.clear();
    files.insert(files.begin(), file);
    return open_files(file, files, group_options);
  }
  if (options.layout) {
    require_headerless_name(file);
    return open_raw(ByteStream(file), options);
  }
  if (is_zarr(file)) return open_zarr(file, options);
  const VolumeFormat* format = format_of_name(file);
  if (is_folder(file)) {
    if (format != nullptr && !is_read(*format)) fail_unread(file, format);
    return open_folder(file, dicom_files(file), options, "give a pattern, such as '*.png'");
  }
  if (const auto archive = archive_of(file); archive && *archive != file)
    return open_zip(file, options);
  if (is_pattern(file)) return open_pattern(file, options);
  if (format != nullptr && format->open_file != nullptr && !packing_of_name(file)) {
    require_named_content(file);
    return format->open_file(file, options);
  }

  ByteStream stream = open_content(file);
  const VolumeFormat* const content_format = format_of_head(stream.peek(magic_bytes));
  const bool may_be_any = format == nullptr && !is_stream_name(file) && !is_mesh_name(file);
  if (may_be_any || (content_format != nullptr && !is_read(*content_format)))
    format = content_format;
  if (format == nullptr) fail_unread(stream.file(), nullptr);
  return open_stream(std::move(stream), *format, options);
}

// Refuses options that the format does not use.
void require_used(const std::filesystem::path& file, const VolumeOptions& options,
                  std::string_view format) {
  const auto is_one_of = [format](std::initializer_list<std::string_view> names) {
    return std::any_of(names.begin(), names.end(), [format](std::string_view name) {
      return format.substr(0, name.size()) == name;
    });
  };
  const std::string what = ", and this is " + std::string(format);
  if (!options.axes.empty() && !is_one_of({"NumPy", "HDF5", "Zarr", "OME-Zarr", "TIFF"}))
    fail(file, "--axes applies to arrays and TIFF" + what, "leave out --axes");
  if (options.level && !is_one_of({"OME-Zarr"}))
    fail(file, "--level applies to OME-Zarr" + what, "leave out --level");
  if (!options.series.empty() && !is_one_of({"DICOM"}))
    fail(file, "--series applies to DICOM" + what, "leave out --series");
  if (options.merges_series && !is_one_of({"DICOM"}))
    fail(file, "--merge-series applies to DICOM" + what, "leave out --merge-series");
  if (options.order != SliceOrder::position && !is_one_of({"DICOM"}))
    fail(file, "--order applies to DICOM" + what, "leave out --order");
}

std::vector<std::string> notes_of_left_out(const std::vector<std::filesystem::path>& pictures,
                                           const std::string& remedy) {
  if (pictures.empty()) return {};
  return {"pictures beside the volumes are left out: " + std::to_string(pictures.size()) +
          ", such as " + shown(pictures[0].filename().string()) + "; to read them, " + remedy};
}

// Leaves out volumes that a header names as its parts: a.hdr its a.img, a.pvti its pieces. files:
// all, in order.
void leave_out_parts(std::vector<std::filesystem::path>& volumes,
                     const std::vector<std::filesystem::path>& files) {
  constexpr std::size_t max_bytes = 1 << 20;
  std::string lists;  // of pieces
  for (const auto& file : files)
    if (file.extension() == ".pvti") lists.append(ByteStream(file).peek(max_bytes)).append("\n");
  const auto is_part = [&](const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".img")
      return std::binary_search(files.begin(), files.end(),
                                std::filesystem::path(file).replace_extension(".hdr"));
    return extension == ".vti" && lists.find(file.filename().string() + '"') != std::string::npos;
  };
  volumes.erase(std::remove_if(volumes.begin(), volumes.end(), is_part), volumes.end());
}

// Opens the only volume in subfolders of a folder, or lists all.
std::unique_ptr<VolumeReader> open_inner(const std::filesystem::path& folder,
                                         const VolumeOptions& options) {
  const auto files = files_in(folder);
  std::vector<std::filesystem::path> volumes;
  for (const auto& file : files) {
    const VolumeFormat* const format = format_of_name(file);
    if (format != nullptr && is_read(*format) && format->name != "zip" && !is_picture_name(file))
      volumes.push_back(file);
  }
  leave_out_parts(volumes, files);
  if (volumes.size() == 1) return open_by_kind(volumes[0], options);
  if (volumes.size() > 1)
    fail(folder, "several volumes in folders: " + list_of(volumes), "name one file");
  for (const auto& file : files) {
    ByteStream stream(file);
    const VolumeFormat* format = format_of_head(stream.peek(magic_bytes));
    if (format == nullptr) format = format_of_name(file);
    if (format == nullptr || (is_read(*format) && format->name != "zip")) continue;
    fail(folder,
         "the folder holds " + std::string(format->name) + ", " + shown(file.filename().string()),
         format->name == "zip" ? "unpack it, and give the folder" : std::string(format->remedy));
  }
  fail(folder, "the folder holds no DICOM files and no pictures",
       "name a file, or the folder of a series");
}

std::string text_of_dead(const std::vector<std::filesystem::path>& links) {
  if (links.empty()) return {};
  return "links that lead nowhere: " + std::to_string(links.size()) + ", such as " +
         shown(links[0].filename().string());
}

}  // namespace

std::unique_ptr<VolumeReader> open_pattern(const std::filesystem::path& pattern,
                                           const VolumeOptions& options) {
  return open_files(pattern, files_of_pattern(pattern), options);
}

std::unique_ptr<VolumeReader> open_folder(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& dicom,
                                          const VolumeOptions& options,
                                          const std::string& remedy_of_pictures) {
  const auto pictures = picture_files(folder);
  const std::string dead = text_of_dead(dead_links(folder));
  if (!dicom.empty()) {
    auto notes = notes_of_left_out(pictures, remedy_of_pictures);
    if (dead.empty()) return open_dicom(folder, dicom, options, notes);
    notes.push_back(dead);
    try {
      return open_dicom(folder, dicom, options, notes);
    } catch (const VolumeError& error) {
      fail(error.file(), error.fault() + " (" + dead + ")", error.remedy());
    }
  }
  const auto masks = mask_files(folder);
  if (!pictures.empty() && (masks.empty() || pictures.size() > masks.size()))
    return open_pictures(folder, pictures, options);
  if (!masks.empty())
    return open_requested_masks(folder, masks, options,
                                notes_of_left_out(pictures, remedy_of_pictures));
  if (!dead.empty()) fail(folder, dead, "copy the files that they should lead to");
  return open_inner(folder, options);
}

void fail_frames(const std::filesystem::path& file, const VolumeInfo& info,
                 const VolumeOptions& options) {
  const bool has_labels = !info.labels.empty();
  const std::string frames = std::to_string(info.frames);
  const std::string last = std::to_string(info.frames - 1);
  std::string remedy = "choose one with --frame N, the first is 0";
  if (has_labels)
    remedy = "select labels with --label NAME, or " + remedy;
  else if (options.holds_labels && is_floating(info.type))
    remedy += "; if each is the probability of a label, extract them with --frame 0 to " + last +
              ", each with --iso 0.5 instead of labels";
  else if (options.holds_labels)
    remedy += "; if each is the mask of a label, extract them with --frame 0 to " + last +
              ", each with --label 1";
  fail(file,
       "the file holds " + std::string(has_labels ? "labels in " : "") + frames +
           " volumes, and one is read at a time",
       remedy);
}

bool is_volume_name(const std::filesystem::path& file) {
  return is_raw_name(file) || format_of_name(file) != nullptr || is_folder(file) || is_zarr(file);
}

std::unique_ptr<VolumeReader> open_volume(const std::filesystem::path& file,
                                          const VolumeOptions& options) {
  auto volume = open_by_kind(file, options);
  if (volume->info().frames > 1 && !options.frame) fail_frames(file, volume->info(), options);
  if (options.frame.value_or(0) >= volume->info().frames)
    fail(
        file,
        "the input has one volume, and volume " + std::to_string(*options.frame) + " was requested",
        "leave out --frame");
  if (options.channel.value_or(0) >= volume->info().channels)
    fail(file,
         "the input has one channel, and channel " + std::to_string(*options.channel) +
             " was requested",
         "leave out --channel");
  require_used(file, options, volume->info().format);
  if (options.holds_labels) volume = whole_labels(file, std::move(volume));
  if (options.crop) volume = cropped(file, std::move(volume), *options.crop);
  if (options.shrink > 1)
    volume = shrunk(file, std::move(volume), options.shrink, options.block_value);
  return volume;
}

}  // namespace discmc::command

// What the readers of the formats share: refusals, header text, sizes and axes. Internal to the
// volume readers.
#ifndef DISCMC_COMMAND_VOLUMES_VOLUME_FORMAT_HPP
#define DISCMC_COMMAND_VOLUMES_VOLUME_FORMAT_HPP

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "volume.hpp"
#include "volume_stream.hpp"

namespace discmc::host {

std::unique_ptr<VolumeReader> open_nrrd(const std::filesystem::path& file);
std::unique_ptr<VolumeReader> open_nifti(const std::filesystem::path& file);
std::unique_ptr<VolumeReader> open_metaimage(const std::filesystem::path& file);
std::unique_ptr<VolumeReader> open_raw(const std::filesystem::path& file, const RawLayout& layout);
/// source: what was named, of which these are the DICOM files.
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const std::string& series);

/// The same of pictures, a slice each.
std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source,
                                            std::vector<std::filesystem::path> files);

/// Throws a VolumeError that reads "file: what; remedy".
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what,
                       const std::string& remedy);

/// Throws the refusal of a sample type, by the name the file gives it.
[[noreturn]] void fail_type(const std::filesystem::path& file, std::string_view type);

/// Returns text from a file in quotes, cut to a length fit for a message, without control bytes.
std::string shown(std::string_view text);

/// Returns the beginning of the stream, enough for any sensible header, and goes back to its start.
std::string header_text(ByteStream& stream);

/// Goes to the first sample of a volume that is the end of its file. Throws when the file is
/// shorter.
void seek_volume_at_end(ByteStream& stream, const VolumeInfo& info);

/// Takes a line off the front, without its line feed and carriage return; nothing at the end.
std::optional<std::string_view> take_line(std::string_view& text);

/// Returns the text without blanks at either end.
std::string_view trimmed(std::string_view text);

/// Returns the text in lower case (ASCII letters only).
std::string lower(std::string_view text);

/// Returns the words between blanks.
std::vector<std::string_view> words(std::string_view text);

/// Returns the file beside the header that its text names. Throws when that is no name.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

/// Return the number when the text is one and nothing else; a real may be nan. The file and the
/// name of the field are for the VolumeError thrown otherwise.
std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text);
double real(const std::filesystem::path& file, std::string_view field, std::string_view text);

/// Takes sizes, fastest axis first. Two give one slice; those beyond the third must be 1. Throws
/// when one is out of the range of VolumeInfo::dims.
void set_dims(VolumeInfo& info, const std::filesystem::path& file,
              const std::vector<std::int64_t>& sizes);

/// Takes the spacing, along the coordinates.
/// Units: millimetres. A value of no use becomes 1, with a note.
void set_spacing(VolumeInfo& info, const std::array<double, 3>& spacing_mm);

/// Takes the placement, after set_spacing(), whose lengths stay and get the signs of the axes in
/// right-handed coordinates: a surface by the spacing alone is turned and moved against the placed
/// one, never mirrored. What is of no use becomes the coordinates and their origin, with a note.
/// A placement that says no more than the spacing is none.
void set_placement(VolumeInfo& info, VolumePlacement placement);

/// Takes value = slope * stored + intercept; a slope of 0 stands for no scaling at all. Throws when
/// slope is negative or either not finite.
void set_scale(VolumeInfo& info, const std::filesystem::path& file, double slope, double intercept);

}  // namespace discmc::host

#endif

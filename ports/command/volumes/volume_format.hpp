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

namespace discmc::command {

std::unique_ptr<VolumeReader> open_nrrd(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_nifti(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_metaimage(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_vtk(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_vti(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_invesalius(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_raw(ByteStream stream, const RawLayout& layout);
/// source: what was named, of which these are the DICOM files. notes: of what else it holds, told
/// with those of the volume.
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

/// The same of pictures, a slice each.
std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source,
                                            std::vector<std::filesystem::path> files,
                                            const VolumeOptions& options);

/// Opens what is in a folder: DICOM, with a note of pictures beside it and the remedy that reads
/// them, or else pictures. Throws when there is neither. dicom: dicom_files() of it.
std::unique_ptr<VolumeReader> open_folder(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& dicom,
                                          const VolumeOptions& options,
                                          const std::string& remedy_of_pictures);

/// An HDF5 file, or a dataset in it: scan.h5:/exchange/data. Of a file alone the dataset is the
/// only one that can be a volume.
std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options);

/// Whether a file is named as archives of zip are.
bool has_zip_name(const std::filesystem::path& file);

/// The same of what is in an archive of zip, unpacked into the folder for temporary files for as
/// long as the volume is open.
std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file,
                                       const VolumeOptions& options);

/// The bytes of a file, inflated where they are gzip.
ByteStream open_content(const std::filesystem::path& file);

/// The name of the format that a file begins like, of those known to have a header; nothing
/// otherwise.
std::optional<std::string_view> format_of_magic(ByteStream& stream);

/// Throws a VolumeError that reads "file: what; remedy".
[[noreturn]] void fail(const std::filesystem::path& file, const std::string& what,
                       const std::string& remedy);

/// Throws when all slices have been read.
void require_slice_left(const std::filesystem::path& file, std::size_t read, std::size_t slices);

/// Throws the refusal of a sample type, by the name the file gives it.
[[noreturn]] void fail_type(const std::filesystem::path& file, std::string_view type);

/// Returns text from a file in quotes, cut to a length fit for a message, without control bytes.
std::string shown(std::string_view text);

/// What is noted of a file that tells no spacing.
constexpr const char* no_spacing_note = "no spacing given, 1 mm taken";

/// Returns the extents of a volume for a message, as in "8 x 9 x 6".
std::string extents(const std::array<std::uint32_t, 3>& dims);

/// Units: bytes of all volumes in a file.
std::uint64_t bytes_of_all(const VolumeInfo& info);

/// Goes to so many bytes before the end of the file. Throws when the file is shorter, and where it
/// has no known end.
void skip_to_end(ByteStream& stream, std::uint64_t bytes);

/// Goes from the first sample of the first volume to that of the one asked for.
void skip_to_frame(ByteStream& stream, const VolumeInfo& info, const VolumeOptions& options);

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

/// Takes sizes, fastest axis first. Two give one slice; those beyond the third count volumes.
/// Throws when one is out of the range of VolumeInfo::dims, and when the file does not hold the
/// frame asked for, or holds several and none is.
void set_dims(VolumeInfo& info, const std::filesystem::path& file,
              const std::vector<std::int64_t>& sizes, const VolumeOptions& options = {});

/// Takes how many channels a voxel has. Throws when the one asked for is not among them, and when
/// there are several and none is asked for. names: of the channels, for people, or none.
void set_channels(VolumeInfo& info, const std::filesystem::path& file, std::uint64_t channels,
                  const VolumeOptions& options, const std::vector<std::string>& names = {});

/// Takes the spacing, along the coordinates.
/// Units: millimetres. A value of no use becomes 1, with a note.
void set_spacing(VolumeInfo& info, const std::array<double, 3>& spacing_mm);

/// Takes the placement, after set_spacing(), whose lengths stay and get the signs of the axes in
/// right-handed coordinates: a surface by the spacing alone is turned and moved against the placed
/// one, never mirrored. What is of no use becomes the coordinates and their origin, with a note.
/// A placement that says no more than the spacing is none.
void set_placement(VolumeInfo& info, VolumePlacement placement);

/// Takes a part of the volume, or makes its voxels larger: voxel (0, 0, 0) has its centre at
/// `first`, and the next ones are `step` away. Every voxel then lies where it was. Units: voxels
/// before. The file is for the VolumeError thrown where that is out of the range of a placement.
void set_part(VolumeInfo& info, const std::filesystem::path& file,
              const std::array<std::uint32_t, 3>& dims, const std::array<double, 3>& first,
              double step);

/// Takes value = slope * stored + intercept; a slope of 0 stands for no scaling at all. Throws when
/// slope is negative or either not finite.
void set_scale(VolumeInfo& info, const std::filesystem::path& file, double slope, double intercept);

}  // namespace discmc::command

#endif

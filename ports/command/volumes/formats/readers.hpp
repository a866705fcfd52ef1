// The readers of the formats, and their common promise:
//
//   A reader gives every sample of the requested volume, in the place and size that the file
//   declares, or throws the reason; it prints each assumption as a note.
//
// A reader therefore accounts for everything that it has not used, such as axes, pages, bytes
// behind the samples, and fields that change their meaning. Shared functions help: set_dims() and
// set_place() note what they drop or assume, SliceStream notes what follows the samples.
// VolumeError names the file, the fault and the remedy.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "volumes/volume.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {

std::unique_ptr<VolumeReader> open_nrrd(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_nifti(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_metaimage(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_vtk(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_vti(ByteStream stream, const VolumeOptions& options);
/// The pieces are files beside the stream's file.
std::unique_ptr<VolumeReader> open_pvti(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_mgh(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_mrc(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_cube(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_described(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_invesalius(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_raw(ByteStream stream, const VolumeOptions& options);
/// source: the named path, which contains these DICOM files. notes: about its other content,
/// printed with those of the volume.
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

/// Likewise opens pictures, one per slice.
std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source,
                                            std::vector<std::filesystem::path> files,
                                            const VolumeOptions& options);

/// Opens files by a pattern: pictures, or else DICOM.
std::unique_ptr<VolumeReader> open_pattern(const std::filesystem::path& pattern,
                                           const VolumeOptions& options);

/// Opens the content of a folder: DICOM, or else pictures. If there are both, a note has the remedy
/// that reads the pictures. Throws if there is neither. dicom: the folder's dicom_files().
std::unique_ptr<VolumeReader> open_folder(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& dicom,
                                          const VolumeOptions& options,
                                          const std::string& remedy_of_pictures);

/// Opens an HDF5 file, or a dataset in it: scan.h5:/exchange/data. A name without a dataset means
/// the only possible volume.
std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options);

/// Opens an .npz file, or an array in it: scan.npz:/volume. The rules are those of open_hdf5().
std::unique_ptr<VolumeReader> open_npz(const std::filesystem::path& name,
                                       const VolumeOptions& options);

/// Opens a folder of Zarr: an image of OME-Zarr, an array, or a group with one of them.
std::unique_ptr<VolumeReader> open_zarr(const std::filesystem::path& path,
                                        const VolumeOptions& options);

/// Whether a path is a Zarr group or array of version 2 or 3, or its metadata file.
bool is_zarr(const std::filesystem::path& path);

/// Returns the Zarr folder that `folder` is, or that is its only content.
std::optional<std::filesystem::path> folder_of_zarr(const std::filesystem::path& folder);

/// Whether a file of this name can be one of several masks, which need single-file formats.
bool is_mask_name(const std::filesystem::path& file);

/// Returns the masks of a folder, without its subfolders.
std::vector<std::filesystem::path> mask_files(const std::filesystem::path& folder);

/// Opens mask files as volumes of equal extents and place, in the natural order of names;
/// options.frame is the index of one. Each mask is one label with the name of its file. If options
/// declare labels, reading refuses a file with two values besides 0. source: the named path. notes:
/// added to those of the volume.
std::unique_ptr<VolumeReader> open_masks(const std::filesystem::path& source,
                                         std::vector<std::filesystem::path> files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

/// Returns the zip file of a path or pattern: scan.zip for scan.zip/*_c0.png, or nothing.
std::optional<std::filesystem::path> archive_of(const std::filesystem::path& name);

/// Opens the content of a zip archive, unpacked into a temporary folder while the volume is open.
/// file: the archive, or a pattern of files in it: scan.zip/*_c0.png.
std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file,
                                       const VolumeOptions& options);

}  // namespace discmc::command

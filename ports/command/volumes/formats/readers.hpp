// The readers of the formats, and what each of them promises:
//
//   A reader gives every sample of the requested volume, in the place and size that the file
//   declares, or throws the reason; it prints each assumption as a note.
//
// So it accounts for all that it has not used, such as axes, pages, bytes behind the samples, and
// fields that change their meaning. Shared functions do a part of it. set_dims() and set_place()
// note what they drop or assume, SliceStream what follows the samples; VolumeError names the file,
// the fault and the remedy.
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
/// The pieces are files beside the stream's.
std::unique_ptr<VolumeReader> open_pvti(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_mgh(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_mrc(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_cube(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_described(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_invesalius(ByteStream stream, const VolumeOptions& options);
std::unique_ptr<VolumeReader> open_raw(ByteStream stream, const VolumeOptions& options);
/// source: what was named, of which these are the DICOM files. notes: of its other content, printed
/// with those of the volume.
std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>& files,
                                         const VolumeOptions& options,
                                         const std::vector<std::string>& notes = {});

/// The same of pictures, a slice each.
std::unique_ptr<VolumeReader> open_pictures(const std::filesystem::path& source,
                                            std::vector<std::filesystem::path> files,
                                            const VolumeOptions& options);

/// Files by a pattern: pictures, or else DICOM.
std::unique_ptr<VolumeReader> open_pattern(const std::filesystem::path& pattern,
                                           const VolumeOptions& options);

/// Opens what is in a folder: DICOM, with a note of pictures beside it and the remedy that reads
/// them, or else pictures. Throws when there is neither. dicom: dicom_files() of it.
std::unique_ptr<VolumeReader> open_folder(const std::filesystem::path& folder,
                                          const std::vector<std::filesystem::path>& dicom,
                                          const VolumeOptions& options,
                                          const std::string& remedy_of_pictures);

/// An HDF5 file, or a dataset in it: scan.h5:/exchange/data. Without a dataset in the name,
/// the only one that can be a volume.
std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options);

/// An .npz file, or an array in it: scan.npz:/volume. As HDF5.
std::unique_ptr<VolumeReader> open_npz(const std::filesystem::path& name,
                                       const VolumeOptions& options);

/// A folder of Zarr: an image of OME-Zarr, an array, or a group with one of them.
std::unique_ptr<VolumeReader> open_zarr(const std::filesystem::path& path,
                                        const VolumeOptions& options);

/// The file that a name, or a pattern of files, is or goes into: scan.zip of scan.zip/*_c0.png.
/// Nothing where there is none.
std::optional<std::filesystem::path> archive_of(const std::filesystem::path& name);

/// The same of what is in an archive of zip, unpacked into the folder for temporary files for as
/// long as the volume is open. file: the archive, or a pattern of files in it: scan.zip/*_c0.png.
std::unique_ptr<VolumeReader> open_zip(const std::filesystem::path& file,
                                       const VolumeOptions& options);

}  // namespace discmc::command

// DCMTK, set up for the readers: with its decoders, and silent.
//
// This uses DCMTK, although GDCM is lighter and decodes JPEG 2000 itself. GDCM 3.0 allocates what a
// length in a file claims, up to 4 GiB. Debian's build has assertions that end the program on
// damaged files.
#pragma once

#include <dcmtk/config/osconfig.h>
// The first of all DCMTK headers.
#include <dcmtk/dcmdata/dctk.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace discmc::command {

enum class Pixels { left_out, included };

/// Opens a file. Values of some size stay in it until they are asked for. Returns nothing where it
/// is no DICOM file, a damaged one, or deflated as a whole.
std::unique_ptr<DcmFileFormat> open_dicom_file(const std::filesystem::path& file, Pixels pixels);

/// Whether the elements are stored otherwise than the file's header names.
bool contradicts_header(DcmFileFormat& file);

/// Whether pixel data of a transfer syntax, by its UID, is read. Limit: after open_dicom_file().
bool can_decode(const std::string& transfer_syntax);

/// Whether it is RLE or JPEG 2000, which DCMTK does not decode here.
bool is_decoded_here(E_TransferSyntax syntax);

/// The frames that the header counts, at least 1.
std::uint32_t frame_count(DcmDataset& dataset);

// What the versions of DCMTK, 3.6.7 of Debian 12 and 3.6.9 of Debian 13 among them, have under
// different names or with different parameters.

/// Whether pixel data is in fragments, as compressed data is.
bool is_encapsulated(E_TransferSyntax syntax);

/// The bytes of a frame, decompressed, by the header of the file. Nothing if the header lacks them.
std::optional<Uint32> frame_bytes_by_header(DcmElement& pixels, DcmDataset& dataset);

}  // namespace discmc::command

// DCMTK, set up for the readers: silent, and with its decoders.
//
// This uses DCMTK, although GDCM is lighter and decodes JPEG 2000 itself. GDCM 3.0 allocates what a
// length in a file claims, up to 4 GiB. Debian's build has assertions that end the program on
// damaged files.
#pragma once

#include <dcmtk/config/osconfig.h>
// DCMTK requires this header before its others.
#include <dcmtk/dcmdata/dctk.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace discmc::command {

enum class Pixels { left_out, included };

/// Opens a file. Large values stay in the file until they are read. Returns nothing if it is not
/// DICOM, is damaged, or is deflated as a whole.
std::unique_ptr<DcmFileFormat> open_dicom_file(const std::filesystem::path& file, Pixels pixels);

/// Whether elements are stored otherwise than the file's header declares.
bool contradicts_header(DcmFileFormat& file);

/// Whether pixel data of a transfer syntax, given by its UID, can be read. Limit: after
/// open_dicom_file().
bool can_decode(const std::string& transfer_syntax);

/// Whether discmc decodes the syntax itself: RLE or JPEG 2000.
bool is_decoded_here(E_TransferSyntax syntax);

/// Returns the number of frames in the header, at least 1.
std::uint32_t frame_count(DcmDataset& dataset);

// Functions with different names or parameters in DCMTK 3.6.7 (Debian 12), 3.6.9 (Debian 13) and
// others.

/// Whether pixel data is in fragments, which compressed data is.
bool is_encapsulated(E_TransferSyntax syntax);

/// Returns the decompressed bytes of a frame by the header, or nothing if the header lacks them.
std::optional<Uint32> frame_bytes_by_header(DcmElement& pixels, DcmDataset& dataset);

}  // namespace discmc::command

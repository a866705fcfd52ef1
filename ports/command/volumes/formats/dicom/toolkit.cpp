#include "toolkit.hpp"

#include <algorithm>

#include "files.hpp"

#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

namespace discmc::command {
namespace {

void set_up() {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
  dcmEnableUnknownVRConversion.set(OFTrue);  // PS3.5 6.2.2: UN gets its type from the dictionary
}

// is_nested_within() cannot read a deflated file.
bool is_deflated(const std::filesystem::path& file) {
  DcmFileFormat header;
  if (header.loadFile(file.c_str(), EXS_Unknown, EGL_noChange, 0, ERM_metaOnly).bad()) return false;
  OFString syntax;
  header.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, syntax);
  return DcmXfer(syntax.c_str()).getStreamCompression() != ESC_none;
}

// Calls the newer form if DCMTK has one: overload resolution prefers an int argument.
template <class Syntax>
auto has_fragments(const Syntax& syntax, int) -> decltype(syntax.usesEncapsulatedFormat()) {
  return syntax.usesEncapsulatedFormat();
}

template <class Syntax>
bool has_fragments(const Syntax& syntax, long) {
  return syntax.isEncapsulated();
}

template <class Element>
auto find_frame_bytes(Element& pixels, DcmDataset& dataset, Uint32& bytes, int)
    -> decltype(pixels.getUncompressedFrameSize(&dataset, bytes, OFBool{})) {
  return pixels.getUncompressedFrameSize(&dataset, bytes,
                                         !is_encapsulated(dataset.getOriginalXfer()));
}

template <class Element>
OFCondition find_frame_bytes(Element& pixels, DcmDataset& dataset, Uint32& bytes, long) {
  return pixels.getUncompressedFrameSize(&dataset, bytes);
}

}  // namespace

bool is_encapsulated(E_TransferSyntax syntax) {
  return has_fragments(DcmXfer(syntax), 0);
}

std::optional<Uint32> frame_bytes_by_header(DcmElement& pixels, DcmDataset& dataset) {
  Uint32 bytes = 0;
  if (find_frame_bytes(pixels, dataset, bytes, 0).bad()) return std::nullopt;
  return bytes;
}

std::uint32_t frame_count(DcmDataset& dataset) {
  Sint32 count = 0;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, count).bad()) return 1;
  return static_cast<std::uint32_t>(std::max(count, 1));
}

bool is_decoded_here(E_TransferSyntax syntax) {
  return syntax == EXS_RLELossless || syntax == EXS_JPEG2000LosslessOnly || syntax == EXS_JPEG2000;
}

bool can_decode(const std::string& transfer_syntax) {
  // JPIP keeps the pixels on a server. DCMTK supports the last two since 3.6.8.
  for (const char* const number : {"94", "95", "204", "205"})
    if (transfer_syntax == std::string("1.2.840.10008.1.2.4.") + number) return false;
  const E_TransferSyntax syntax = DcmXfer(transfer_syntax.c_str()).getXfer();
  return syntax != EXS_Unknown && (!is_encapsulated(syntax) || is_decoded_here(syntax) ||
                                   DcmCodecList::canChangeCoding(syntax, EXS_LittleEndianExplicit));
}

std::unique_ptr<DcmFileFormat> open_dicom_file(const std::filesystem::path& file, Pixels pixels) {
  static const bool is_set_up = (set_up(), true);
  static_cast<void>(is_set_up);
  constexpr std::uint32_t max_nested = 64;
  if (!is_nested_within(max_nested, file) || is_deflated(file)) return nullptr;
  constexpr Uint32 max_read_at_once = 4096;
  const DcmTagKey first_of_pixels(0x7fe0, 0);
  const auto load = [&]() -> std::unique_ptr<DcmFileFormat> {
    auto opened = std::make_unique<DcmFileFormat>();
    const OFCondition result = opened->loadFileUntilTag(
        file.c_str(), EXS_Unknown, EGL_noChange, max_read_at_once, ERM_autoDetect,
        pixels == Pixels::left_out ? first_of_pixels : DCM_UndefinedTagKey);
    return result.good() ? std::move(opened) : nullptr;
  };
  auto opened = load();
  if (opened && opened->getDataset()->tagExists(DCM_SOPClassUID)) return opened;
  // The header may be wrong about the byte order, or about explicit value representations.
  dcmAutoDetectDatasetXfer.set(OFTrue);
  auto by_content = load();
  dcmAutoDetectDatasetXfer.set(OFFalse);
  return by_content ? std::move(by_content) : std::move(opened);
}

bool contradicts_header(DcmFileFormat& file) {
  OFString named;
  return file.getMetaInfo()->findAndGetOFString(DCM_TransferSyntaxUID, named).good() &&
         DcmXfer(named.c_str()).getXfer() != file.getDataset()->getOriginalXfer();
}

}  // namespace discmc::command

#include "toolkit.hpp"

#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

namespace discmc::host {
namespace {

void set_up() {
  OFLog::configure(OFLogger::OFF_LOG_LEVEL);
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs();
  DJLSDecoderRegistration::registerCodecs();
}

}  // namespace

std::unique_ptr<DcmFileFormat> open_dicom_file(const std::filesystem::path& file, Pixels pixels) {
  static const bool is_set_up = (set_up(), true);
  static_cast<void>(is_set_up);
  constexpr Uint32 most_read_at_once = 4096;
  const DcmTagKey first_of_pixels(0x7fe0, 0);
  auto opened = std::make_unique<DcmFileFormat>();
  const OFCondition result = opened->loadFileUntilTag(
      file.c_str(), EXS_Unknown, EGL_noChange, most_read_at_once, ERM_autoDetect,
      pixels == Pixels::left_out ? first_of_pixels : DCM_UndefinedTagKey);
  return result.good() ? std::move(opened) : nullptr;
}

}  // namespace discmc::host

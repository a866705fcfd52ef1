// In place of the reader, where it was built without its libraries.
#include "volumes/formats/readers.hpp"

namespace discmc::command {

std::unique_ptr<VolumeReader> open_dicom(const std::filesystem::path& source,
                                         const std::vector<std::filesystem::path>&,
                                         const VolumeOptions&, const std::vector<std::string>&) {
  fail(
      source, "this is DICOM, and discmc was built without DCMTK and OpenJPEG",
      "install libdcmtk-dev and libopenjp2-7-dev and build again, or convert to NIfTI-1, e.g. with "
      "dcm2niix");
}

}  // namespace discmc::command

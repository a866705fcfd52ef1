// Nuclear medicine: the detector defines where the frames lie.
#include <optional>

#include "attributes.hpp"
#include "frames.hpp"
#include "vectors.hpp"

namespace discmc::command {
namespace {

// Slices lie in the order of SliceVector, otherwise in that of the frames.
std::uint32_t slice_of(DcmItem& dataset, std::uint32_t frame) {
  Uint16 number = 0;
  if (dataset.findAndGetUint16(DCM_SliceVector, number, frame).bad() || number == 0) return frame;
  return number - 1U;
}

std::optional<DicomPlace> detector_place(DcmItem& dataset, std::uint32_t frame) {
  Uint16 detector = 1;
  dataset.findAndGetUint16(DCM_DetectorVector, detector, frame);
  DcmItem* item = nullptr;
  if (dataset.findAndGetSequenceItem(DCM_DetectorInformationSequence, item, detector - 1).bad())
    return std::nullopt;
  return place_of(reals_of<3>(element_of(*item, DCM_ImagePositionPatient)),
                  reals_of<6>(element_of(*item, DCM_ImageOrientationPatient)));
}

}  // namespace

NoSlices place_nuclear(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  const std::string type = text_of(dataset, DCM_ImageType) + '\\';
  for (const char* const planar :
       {"STATIC", "DYNAMIC", "WHOLE BODY", "GATED", "TOMO", "GATED TOMO"})
    if (type.find('\\' + std::string(planar) + '\\') != std::string::npos)
      return {"pictures of a gamma camera, not slices (image type " + std::string(planar) + ")",
              "give the slices that were reconstructed from them (RECON TOMO)"};
  // The sign of the distance is that of the way along the normal (PS3.3, NM Reconstruction).
  std::vector<std::uint32_t> slices;
  for (DicomFrame& frame : frames) {
    if (!frame.place) frame.place = detector_place(dataset, frame.number);
    if (!frame.place) return {};
    slices.push_back(slice_of(dataset, frame.number));
  }
  place_by_steps(image, frames, slices);
  return {};
}

}  // namespace discmc::command

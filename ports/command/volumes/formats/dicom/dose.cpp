// Radiotherapy doses: their scale, and the offsets of their frames.
#include <cmath>

#include "attributes.hpp"
#include "frames.hpp"
#include "text/number_text.hpp"
#include "vectors.hpp"

namespace discmc::command {

void scale_dose(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  const double scaling = real_of(dataset, DCM_DoseGridScaling).value_or(0);
  if (!(scaling > 0)) {
    image.notes.emplace_back("a dose without DoseGridScaling, the stored values are used");
    return;
  }
  for (DicomFrame& frame : frames) frame.slope = scaling;
  const bool is_in_gray = text_of(dataset, DCM_DoseUnits) == "GY";
  image.notes.emplace_back(is_in_gray ? "values are doses in Gy" : "values are relative doses");
}

// The offsets are ways along the normal from the position of the first frame, which has 0, or z in
// the patient's space. The latter begin with that of the position (DICOM PS3.3 C.8.8.3.2).
NoSlices place_by_offsets(DcmItem& dataset, std::vector<DicomFrame>& frames) {
  const auto first = real_of(dataset, DCM_GridFrameOffsetVector);
  if (!first || !frames.front().place) return {};
  constexpr double rounding_mm = 0.01;
  const DicomPlace place = *frames.front().place;
  const Vector normal = normal_of(place);
  const bool are_ways = std::fabs(*first) <= rounding_mm;
  const bool are_axial = std::fabs(normal[2]) > 1 - 1e-6;
  if (!are_ways && !(are_axial && std::fabs(*first - place.position[2]) <= rounding_mm))
    return {"a grid whose GridFrameOffsetVector begins with " + short_number(*first) +
                ", which is neither 0 nor the z of its position",
            "export the dose again"};
  for (DicomFrame& frame : frames) {
    const auto offset = real_of(dataset, DCM_GridFrameOffsetVector, frame.number);
    if (!offset)
      return {"a grid with more frames than offsets (GridFrameOffsetVector)",
              "export the dose again"};
    const double way = are_ways ? *offset : (*offset - *first) * normal[2];
    frame.place->position = sum(place.position, way, normal);
  }
  return {};
}

}  // namespace discmc::command

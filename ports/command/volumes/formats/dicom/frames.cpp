#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "attributes.hpp"
#include "stack.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

void note_times(DcmItem& dataset, DicomImage& image) {
  DcmTagKey key = DCM_UndefinedTagKey;
  DcmElement* pointer = nullptr;
  if (dataset.findAndGetElement(DCM_FrameIncrementPointer, pointer).bad() ||
      pointer->getTagVal(key, 0).bad())
    return;
  if (key == DCM_FrameTime || key == DCM_FrameTimeVector)
    image.notes.emplace_back("the frames have times (FrameTime), and are read as slices");
}

// Whether all frames have one position, but no attribute repeats it on purpose. Some programs write
// slices of the eye like this.
bool are_in_one_place(const DicomImage& image, const std::vector<DicomFrame>& frames) {
  if (image.segments) return false;
  return std::all_of(frames.begin(), frames.end(), [&](const DicomFrame& frame) {
    if (!frame.place || frame.place->position != frames[0].place->position ||
        !have_one_direction(frame, frames[0]))
      return false;
    for (std::size_t kind = 0; kind < trait_count(); ++kind)
      if (!is_for_programs(kind) &&
          trait_of(frame.traits, kind) != trait_of(frames[0].traits, kind))
        return false;
    return true;
  });
}

// Moves frames from their common position by steps along the normal. slices: the slice number of
// each frame.
void place_by_steps(DicomImage& image, std::vector<DicomFrame>& frames,
                    const std::vector<std::uint32_t>& slices) {
  const DicomFrame first = frames.front();
  const bool is_given = first.slice_spacing_mm != 0;
  const double step_mm = is_given ? first.slice_spacing_mm : 1;
  const Vector normal = normal_of(*first.place);
  for (std::size_t i = 0; i < frames.size(); ++i)
    frames[i].place->position = sum(first.place->position, slices[i] * step_mm, normal);
  if (frames.size() > 1)
    image.notes.push_back("one position for all frames, read as slices " + short_number(step_mm) +
                          " mm apart, " +
                          (is_given ? "by " + std::string(first.slice_spacing_name)
                                    : "as SpacingBetweenSlices and SliceThickness are missing"));
}

// ---- radiotherapy doses ----

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

// Offsets that begin with 0 are distances along the normal from the first frame. Offsets that begin
// with the position's z are z in the patient's space (DICOM PS3.3 C.8.8.3.2).
RejectReason place_by_offsets(DcmItem& dataset, std::vector<DicomFrame>& frames) {
  const auto first = real_of(dataset, DCM_GridFrameOffsetVector);
  if (!first || !frames.front().place) return {};
  constexpr double rounding_mm = 0.01;
  const DicomPlace place = *frames.front().place;
  const Vector normal = normal_of(place);
  const bool are_distances = std::fabs(*first) <= rounding_mm;
  const bool are_axial = std::fabs(normal[2]) > 1 - 1e-6;
  if (!are_distances && !(are_axial && std::fabs(*first - place.position[2]) <= rounding_mm))
    return {"a grid whose GridFrameOffsetVector begins with " + short_number(*first) +
                ", which is neither 0 nor the z of its position",
            "export the dose again"};
  for (DicomFrame& frame : frames) {
    const auto offset = real_of(dataset, DCM_GridFrameOffsetVector, frame.number);
    if (!offset)
      return {"a grid with more frames than offsets (GridFrameOffsetVector)",
              "export the dose again"};
    const double distance = are_distances ? *offset : (*offset - *first) * normal[2];
    frame.place->position = sum(place.position, distance, normal);
  }
  return {};
}

// ---- nuclear medicine: the detector defines the positions of the frames ----

// Slices have the order of SliceVector, otherwise of the frames.
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

RejectReason place_nuclear(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  const std::string type = text_of(dataset, DCM_ImageType) + '\\';
  for (const char* const planar :
       {"STATIC", "DYNAMIC", "WHOLE BODY", "GATED", "TOMO", "GATED TOMO"})
    if (type.find('\\' + std::string(planar) + '\\') != std::string::npos)
      return {"pictures of a gamma camera, not slices (image type " + std::string(planar) + ")",
              "give the slices that were reconstructed from them (RECON TOMO)"};
  // The sign of the distance is along the normal (PS3.3, NM Reconstruction).
  std::vector<std::uint32_t> slices;
  for (DicomFrame& frame : frames) {
    if (!frame.place) frame.place = detector_place(dataset, frame.number);
    if (!frame.place) return {};
    slices.push_back(slice_of(dataset, frame.number));
  }
  place_by_steps(image, frames, slices);
  return {};
}

}  // namespace

bool have_own_positions(DcmItem& dataset) {
  const Attributes first(dataset, 0);
  return first.grouped_element(DCM_PlanePositionSequence, DCM_ImagePositionPatient) != nullptr ||
         first.grouped_element(DCM_PlanePositionVolumeSequence, DCM_ImagePositionVolume) != nullptr;
}

RejectReason place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  if (image.modality == "NM") return place_nuclear(dataset, image, frames);
  if (image.modality == "RTDOSE") scale_dose(dataset, image, frames);
  if (real_of(dataset, DCM_GridFrameOffsetVector)) return place_by_offsets(dataset, frames);
  if (frames.size() == 1) return {};
  note_times(dataset, image);
  const bool is_one_place =
      frames.front().place && (!have_own_positions(dataset) || are_in_one_place(image, frames));
  if (!is_one_place) return {};
  std::vector<std::uint32_t> slices(frames.size());
  std::iota(slices.begin(), slices.end(), 0U);
  place_by_steps(image, frames, slices);
  return {};
}

}  // namespace discmc::command

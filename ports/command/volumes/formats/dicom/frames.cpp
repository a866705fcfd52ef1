#include "frames.hpp"

#include <numeric>

#include "attributes.hpp"
#include "text/number_text.hpp"
#include "vectors.hpp"

namespace discmc::command {
namespace {

// Whether a functional group has the positions, and not the file as a whole.
bool have_own_positions(DcmItem& dataset) {
  return Attributes(dataset, 0)
             .grouped_element(DCM_PlanePositionSequence, DCM_ImagePositionPatient) != nullptr;
}

void note_times(DcmItem& dataset, DicomImage& image) {
  DcmTagKey key = DCM_UndefinedTagKey;
  DcmElement* pointer = nullptr;
  if (dataset.findAndGetElement(DCM_FrameIncrementPointer, pointer).bad() ||
      pointer->getTagVal(key, 0).bad())
    return;
  if (key == DCM_FrameTime || key == DCM_FrameTimeVector)
    image.notes.emplace_back("the frames have times (FrameTime), and are read as slices");
}

}  // namespace

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

NoSlices place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  if (image.modality == "NM") return place_nuclear(dataset, image, frames);
  if (image.modality == "RTDOSE") scale_dose(dataset, image, frames);
  if (real_of(dataset, DCM_GridFrameOffsetVector)) return place_by_offsets(dataset, frames);
  if (frames.size() == 1) return {};
  note_times(dataset, image);
  if (!frames.front().place || have_own_positions(dataset)) return {};
  std::vector<std::uint32_t> slices(frames.size());
  std::iota(slices.begin(), slices.end(), 0U);
  place_by_steps(image, frames, slices);
  return {};
}

}  // namespace discmc::command

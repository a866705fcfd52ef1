#include "frames.hpp"

#include <algorithm>
#include <numeric>

#include "attributes.hpp"
#include "stack.hpp"
#include "text/number_text.hpp"
#include "vectors.hpp"

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

// Whether all frames have one position, and no attribute gives them several times, as some programs
// write slices of the eye.
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

bool have_own_positions(DcmItem& dataset) {
  const Attributes first(dataset, 0);
  return first.grouped_element(DCM_PlanePositionSequence, DCM_ImagePositionPatient) != nullptr ||
         first.grouped_element(DCM_PlanePositionVolumeSequence, DCM_ImagePositionVolume) != nullptr;
}

NoSlices place_frames(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
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

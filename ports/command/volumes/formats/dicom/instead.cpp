#include "image.hpp"

#include <string>

#include "attributes.hpp"
#include "files.hpp"
#include "volumes/format_list.hpp"
#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

RejectReason contours(DcmItem& dataset) {
  constexpr int max_shown = 20;
  std::string names;
  DcmItem* contour = nullptr;
  signed long count = 0;
  for (; dataset.findAndGetSequenceItem(DCM_StructureSetROISequence, contour, count).good();
       ++count)
    if (count < max_shown)
      names += (count > 0 ? ", " : "") + shown(name_in(dataset, *contour, DCM_ROIName));
  if (count > max_shown) names += " and " + std::to_string(count - max_shown) + " more";
  return {"an RTSTRUCT, the contours " + (names.empty() ? "of nothing" : names),
          "make masks of them, e.g. with: dcmrtstruct2nii convert -r FILE -d FOLDER_OF_IMAGES "
          "-o MASKS, and give the folder of masks"};
}

}  // namespace

RejectReason foreign_content(const std::filesystem::path& file) {
  ByteStream stream(file);
  const std::string_view head = stream.peek(magic_bytes);
  const VolumeFormat* const format = is_dicom_head(head) ? nullptr : format_of_head(head);
  if (format == nullptr || format->name == "DICOM") return {};
  const std::filesystem::path stem = file.stem();
  const std::string name =
      stem.string() + std::string(format_of_name(stem) == format ? "" : format->endings[0]);
  return {std::string(format->name) + ", and not DICOM",
          is_read(*format) ? "rename it to " + name : std::string(format->remedy)};
}

RejectReason without_image(DcmItem& dataset) {
  if (dataset.tagExists(DCM_StructureSetROISequence)) return contours(dataset);
  const std::string document = text_of(dataset, DCM_MIMETypeOfEncapsulatedDocument);
  if (!document.empty())
    return {"a document in a DICOM file (" + shown(document) + ")",
            "it is not a volume: give the images that it was made of; to take it out, in Python: "
            "open('OUT', 'wb').write(pydicom.dcmread('FILE').EncapsulatedDocument)"};
  const std::string modality = text_of(dataset, DCM_Modality);
  return {"a DICOM file without an image" + (modality.empty() ? "" : " (" + shown(modality) + ")")};
}

}  // namespace discmc::command

#include "image.hpp"

#include <cmath>
#include <utility>

#include "toolkit.hpp"

namespace discmc::command {
namespace {

constexpr std::uint32_t max_frames = 1U << 16;

std::string text(DcmItem& item, const DcmTagKey& key) {
  OFString value;
  item.findAndGetOFStringArray(key, value);
  const std::string found(value.c_str(), value.size());
  return found.substr(0, found.find_last_not_of(" \0") + 1);
}

std::optional<std::uint32_t> whole(DcmItem& item, const DcmTagKey& key) {
  Uint16 value = 0;
  if (item.findAndGetUint16(key, value).bad()) return std::nullopt;
  return value;
}

constexpr double max_magnitude = 1e9;  // of millimetres and values

/// The numbers of an element, if it has so many at least and none is out of all measure.
template <std::size_t count>
std::optional<std::array<double, count>> reals(DcmItem& item, const DcmTagKey& key) {
  std::array<double, count> values{};
  for (std::size_t i = 0; i < count; ++i)
    if (item.findAndGetFloat64(key, values[i], i).bad() || !(std::fabs(values[i]) <= max_magnitude))
      return std::nullopt;
  return values;
}

// What is told for a frame: of itself, of all frames, or of the image, in this order.
class Attributes {
 public:
  Attributes(DcmItem& dataset, std::uint32_t frame) : dataset_(dataset) {
    DcmItem* item = nullptr;
    if (dataset
            .findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, item,
                                    static_cast<signed long>(frame))
            .good())
      groups_.push_back(item);
    if (dataset.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, item).good())
      groups_.push_back(item);
  }

  template <std::size_t count>
  std::optional<std::array<double, count>> reals(const DcmTagKey& group,
                                                 const DcmTagKey& key) const {
    for (DcmItem* functional : groups_) {
      DcmItem* item = nullptr;
      if (functional->findAndGetSequenceItem(group, item).bad()) continue;
      if (auto values = command::reals<count>(*item, key)) return values;
    }
    return command::reals<count>(dataset_, key);
  }

  double real(const DcmTagKey& group, const DcmTagKey& key, double otherwise) const {
    const auto values = reals<1>(group, key);
    return values ? (*values)[0] : otherwise;
  }

 private:
  DcmItem& dataset_;
  std::vector<DcmItem*> groups_;
};

std::optional<std::array<double, 3>> direction(const std::array<double, 6>& orientation,
                                               std::size_t first) {
  std::array<double, 3> vector = {orientation[first], orientation[first + 1],
                                  orientation[first + 2]};
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  constexpr double least = 1e-3;
  if (!(length > least)) return std::nullopt;
  for (double& component : vector) component /= length;
  return vector;
}

std::optional<DicomPlace> place(const Attributes& attributes) {
  const auto position = attributes.reals<3>(DCM_PlanePositionSequence, DCM_ImagePositionPatient);
  const auto orientation =
      attributes.reals<6>(DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient);
  if (!position || !orientation) return std::nullopt;
  const auto along_row = direction(*orientation, 0);
  const auto along_column = direction(*orientation, 3);
  if (!along_row || !along_column) return std::nullopt;
  return DicomPlace{*position, *along_row, *along_column};
}

DicomFrame frame(DcmItem& dataset, const std::shared_ptr<const DicomImage>& image,
                 std::uint32_t number) {
  const Attributes attributes(dataset, number);
  DicomFrame frame;
  frame.image = image;
  frame.number = number;
  frame.place = place(attributes);
  auto spacing = attributes.reals<2>(DCM_PixelMeasuresSequence, DCM_PixelSpacing);
  if (!spacing) spacing = reals<2>(dataset, DCM_ImagerPixelSpacing);
  if (spacing) frame.spacing_mm = {(*spacing)[1], (*spacing)[0]};
  frame.slice_spacing_mm =
      attributes.real(DCM_PixelMeasuresSequence, DCM_SpacingBetweenSlices,
                      attributes.real(DCM_PixelMeasuresSequence, DCM_SliceThickness, 0));
  frame.slope = attributes.real(DCM_PixelValueTransformationSequence, DCM_RescaleSlope, 1);
  frame.intercept = attributes.real(DCM_PixelValueTransformationSequence, DCM_RescaleIntercept, 0);
  return frame;
}

// The frames of a dose grid have one position, and their offsets from it.
void add_grid_offsets(DcmItem& dataset, std::vector<DicomFrame>& frames) {
  for (DicomFrame& frame : frames) {
    double offset = 0;
    if (!frame.place ||
        dataset.findAndGetFloat64(DCM_GridFrameOffsetVector, offset, frame.number).bad() ||
        !(std::fabs(offset) <= max_magnitude))
      return;
    const auto normal = normal_of(*frame.place);
    for (std::size_t i = 0; i < 3; ++i) frame.place->position[i] += offset * normal[i];
  }
}

// Returns what the samples are instead of grey values, or nothing.
std::string set_samples(DcmItem& dataset, DicomImage& image) {
  if (whole(dataset, DCM_SamplesPerPixel).value_or(1) != 1) return "a colour image";
  const std::string photometric = text(dataset, DCM_PhotometricInterpretation);
  if (photometric.rfind("PALETTE", 0) == 0) return "a colour image";
  image.is_inverted = photometric == "MONOCHROME1";
  const auto allocated = whole(dataset, DCM_BitsAllocated).value_or(0);
  const auto representation = whole(dataset, DCM_PixelRepresentation);
  // Floating point has no representation to tell.
  if (!representation && (allocated == 32 || allocated == 64)) {
    image.type = allocated == 32 ? SampleType::f32 : SampleType::f64;
    return {};
  }
  const bool is_signed = representation == 1U;
  if (allocated == 8)
    image.type = is_signed ? SampleType::i8 : SampleType::u8;
  else if (allocated == 16)
    image.type = is_signed ? SampleType::i16 : SampleType::u16;
  else if (allocated == 32)
    image.type = is_signed ? SampleType::i32 : SampleType::u32;
  else
    return "an image of " + std::to_string(allocated) + " bits a sample";
  image.bits = whole(dataset, DCM_BitsStored).value_or(allocated);
  image.high_bit = whole(dataset, DCM_HighBit).value_or(image.bits - 1);
  if (image.bits < 1 || image.high_bit >= allocated || image.high_bit + 1 < image.bits)
    return "an image of " + std::to_string(image.bits) + " bits up to bit " +
           std::to_string(image.high_bit) + " of " + std::to_string(allocated);
  DcmItem* table = nullptr;
  if (dataset.findAndGetSequenceItem(DCM_ModalityLUTSequence, table).good())
    return "an image with a table of values (Modality LUT)";
  return {};
}

}  // namespace

std::array<double, 3> normal_of(const DicomPlace& place) {
  const auto& [rx, ry, rz] = place.along_row;
  const auto& [cx, cy, cz] = place.along_column;
  return {ry * cz - rz * cy, rz * cx - rx * cz, rx * cy - ry * cx};
}

DicomContent dicom_content(const std::filesystem::path& file) {
  auto opened = open_dicom_file(file, Pixels::left_out);
  if (!opened)
    return {{},
            "no DICOM file, a damaged one, or one that is deflated as a whole (dcmconv +te "
            "inflates it)"};
  DcmDataset& dataset = *opened->getDataset();
  const auto image = std::make_shared<DicomImage>();
  image->file = file;
  image->rows = whole(dataset, DCM_Rows).value_or(0);
  image->columns = whole(dataset, DCM_Columns).value_or(0);
  if (image->rows == 0 || image->columns == 0) return {{}, "a DICOM file without image"};
  if (std::string instead = set_samples(dataset, *image); !instead.empty())
    return {{}, std::move(instead)};
  image->series = text(dataset, DCM_SeriesInstanceUID);
  image->instance = text(dataset, DCM_SOPInstanceUID);
  image->description = text(dataset, DCM_SeriesDescription);
  image->modality = text(dataset, DCM_Modality);
  Sint32 number = 0;
  if (dataset.findAndGetSint32(DCM_SeriesNumber, number).good()) image->series_number = number;
  const E_TransferSyntax syntax = dataset.getOriginalXfer();
  if (is_encapsulated(syntax)) image->compression = DcmXfer(syntax).getXferName();

  Sint32 count = 0;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, count).bad()) count = 1;
  if (count < 1 || static_cast<std::uint32_t>(count) > max_frames)
    return {{}, "an image of " + std::to_string(count) + " frames"};
  DicomContent content;
  for (Sint32 i = 0; i < count; ++i)
    content.frames.push_back(frame(dataset, image, static_cast<std::uint32_t>(i)));
  add_grid_offsets(dataset, content.frames);
  return content;
}

}  // namespace discmc::command

#include "image.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "attributes.hpp"
#include "segmentation.hpp"
#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

constexpr std::uint32_t max_frames = 1U << 16;

std::optional<Vector> direction(const std::array<double, 6>& orientation, std::size_t first) {
  Vector vector = {orientation[first], orientation[first + 1], orientation[first + 2]};
  const double size = length(vector);
  constexpr double min_length = 1e-3;
  if (!(size > min_length)) return std::nullopt;
  for (double& component : vector) component /= size;
  return vector;
}

// Returns whether an element has the distances between voxels.
bool read_spacing(DcmElement* element, const char* name, DicomFrame& frame) {
  const auto spacing = reals_of<2>(element);
  if (!spacing || !((*spacing)[0] > 0 && (*spacing)[1] > 0)) return false;
  frame.spacing_mm = {(*spacing)[1], (*spacing)[0]};
  frame.spacing_name = name;
  return true;
}

// Returns whether the picture has one region of ultrasound, with distances in centimetres.
bool read_region(DcmItem& dataset, DicomFrame& frame) {
  constexpr std::uint32_t centimetres = 3;
  DcmItem* other = nullptr;
  DcmItem* const region = first_item(dataset, DCM_SequenceOfUltrasoundRegions);
  if (region == nullptr ||
      dataset.findAndGetSequenceItem(DCM_SequenceOfUltrasoundRegions, other, 1).good() ||
      whole_of(*region, DCM_PhysicalUnitsXDirection) != centimetres ||
      whole_of(*region, DCM_PhysicalUnitsYDirection) != centimetres)
    return false;
  const double x = real_of(*region, DCM_PhysicalDeltaX).value_or(0);
  const double y = real_of(*region, DCM_PhysicalDeltaY).value_or(0);
  if (!(x > 0 && y > 0)) return false;
  frame.spacing_mm = {10 * x, 10 * y};
  frame.spacing_name = "SequenceOfUltrasoundRegions";
  return true;
}

void set_spacing(DcmItem& dataset, const Attributes& attributes, DicomFrame& frame) {
  const bool has_lengths =
      read_spacing(attributes.element(DCM_PixelMeasuresSequence, DCM_PixelSpacing), "PixelSpacing",
                   frame) ||
      read_spacing(element_of(dataset, DCM_ImagerPixelSpacing), "ImagerPixelSpacing", frame) ||
      read_spacing(element_of(dataset, DCM_NominalScannedPixelSpacing),
                   "NominalScannedPixelSpacing", frame) ||
      read_region(dataset, frame);
  if (!has_lengths &&
      read_spacing(element_of(dataset, DCM_PixelAspectRatio), "PixelAspectRatio", frame))
    frame.spacing_mm = {1, frame.spacing_mm[1] / frame.spacing_mm[0]};
  for (const auto& [key, name] : {std::pair(DCM_SpacingBetweenSlices, "SpacingBetweenSlices"),
                                  std::pair(DCM_SliceThickness, "SliceThickness")}) {
    const auto distance = real_of(attributes.element(DCM_PixelMeasuresSequence, key));
    if (distance.value_or(0) == 0) continue;
    frame.slice_spacing_mm = *distance;
    frame.slice_spacing_name = name;
    return;
  }
}

// Parametric maps store the scale of their samples in attributes of their own.
void set_scale(const Attributes& attributes, DicomFrame& frame) {
  const auto real = [&](const DcmTagKey& group, const DcmTagKey& key) {
    return real_of(attributes.element(group, key));
  };
  auto slope = real(DCM_PixelValueTransformationSequence, DCM_RescaleSlope);
  auto intercept = real(DCM_PixelValueTransformationSequence, DCM_RescaleIntercept);
  if (!slope && frame.image->is_parametric_map) {
    slope = real(DCM_RealWorldValueMappingSequence, DCM_RealWorldValueSlope);
    intercept = real(DCM_RealWorldValueMappingSequence, DCM_RealWorldValueIntercept);
  }
  frame.slope = slope.value_or(1);
  frame.intercept = intercept.value_or(0);
}

std::uint32_t segment(const Attributes& attributes) {
  DcmElement* const element =
      attributes.element(DCM_SegmentIdentificationSequence, DCM_ReferencedSegmentNumber);
  Uint16 number = 0;
  if (element != nullptr) element->getUint16(number);
  return number;
}

DicomFrame frame(DcmItem& dataset, const std::shared_ptr<const DicomImage>& image,
                 std::uint32_t number) {
  const Attributes attributes(dataset, number);
  DicomFrame frame;
  frame.image = image;
  frame.number = number;
  frame.place = place_of(
      reals_of<3>(attributes.element(DCM_PlanePositionSequence, DCM_ImagePositionPatient)),
      reals_of<6>(attributes.element(DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient)));
  if (!frame.place) {
    frame.place = place_of(
        reals_of<3>(attributes.element(DCM_PlanePositionVolumeSequence, DCM_ImagePositionVolume)),
        reals_of<6>(
            attributes.element(DCM_PlaneOrientationVolumeSequence, DCM_ImageOrientationVolume)));
    if (frame.place) frame.place->is_of_patient = false;
  }
  set_spacing(dataset, attributes, frame);
  set_scale(attributes, frame);
  frame.traits = traits_of(dataset, attributes, number);
  if (image->segments) frame.segment = segment(attributes);
  return frame;
}

// Checks the decimals that define positions. Some programs write a decimal comma. Returns the
// invalid one, or nothing.
RejectReason check_decimals(DcmItem& dataset, DicomImage& image) {
  const Attributes attributes(dataset, 0);
  const std::pair<DcmTagKey, DcmTagKey> decimals[] = {
      {DCM_PixelMeasuresSequence, DCM_PixelSpacing},
      {DCM_PixelMeasuresSequence, DCM_SpacingBetweenSlices},
      {DCM_PixelMeasuresSequence, DCM_SliceThickness},
      {DCM_PlanePositionSequence, DCM_ImagePositionPatient},
      {DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient},
      {DCM_PixelValueTransformationSequence, DCM_RescaleSlope},
      {DCM_PixelValueTransformationSequence, DCM_RescaleIntercept},
      {DCM_UndefinedTagKey, DCM_DoseGridScaling}};
  bool have_commas = false;
  for (const auto& [group, key] : decimals) {
    DcmElement* const element = attributes.element(group, key);
    const std::string text = text_of(element);
    if (text.empty()) continue;
    have_commas = have_commas || text.find(',') != std::string::npos;
    const auto count = 1 + std::count(text.begin(), text.end(), '\\');
    for (unsigned long i = 0; i < static_cast<unsigned long>(count); ++i)
      if (!real_of(element, i))
        return {"an image whose " + std::string(DcmTag(key).getTagName()) + " is " + shown(text) +
                    ", which is not a number",
                "correct it, e.g. with: dcmodify -m " + std::string(DcmTag(key).getTagName()) +
                    "=VALUE FILE"};
  }
  const auto spacing = reals_of<2>(attributes.element(decimals[0].first, decimals[0].second));
  if (spacing && !((*spacing)[0] > 0 && (*spacing)[1] > 0))
    image.notes.push_back("PixelSpacing is " + short_number((*spacing)[0]) + " by " +
                          short_number((*spacing)[1]) + " and is ignored");
  if (have_commas) image.notes.emplace_back("decimal commas are read as points");
  return {};
}

// Some programs write a signed padding value as an unsigned one.
std::optional<std::int32_t> padding_of(DcmItem& dataset, bool is_signed) {
  DcmElement* const element = element_of(dataset, DCM_PixelPaddingValue);
  Uint16 bits = 0;
  Sint16 value = 0;
  if (element == nullptr) return std::nullopt;
  if (element->getSint16(value).good()) return value;
  if (element->getUint16(bits).bad()) return std::nullopt;
  return is_signed ? std::int32_t{static_cast<Sint16>(bits)} : std::int32_t{bits};
}

// Returns the greys of a palette for samples of 8 bits; empty if it has colours.
std::vector<std::uint8_t> greys_of(DcmItem& dataset) {
  constexpr std::size_t max_greys = 256;
  const Uint16* words = nullptr;
  unsigned long count = 0;
  Uint16 first = 0;
  if (whole_of(dataset, DCM_BitsAllocated) != 8U ||
      whole_of(dataset, DCM_PixelRepresentation) != 0U ||
      dataset.findAndGetUint16(DCM_RedPaletteColorLookupTableDescriptor, first, 1).bad() ||
      first != 0 ||
      dataset.findAndGetUint16Array(DCM_RedPaletteColorLookupTableData, words, &count).bad() ||
      (count != max_greys && count != max_greys / 2))
    return {};
  for (const DcmTagKey& key :
       {DCM_GreenPaletteColorLookupTableData, DCM_BluePaletteColorLookupTableData}) {
    const Uint16* other = nullptr;
    unsigned long others = 0;
    if (dataset.findAndGetUint16Array(key, other, &others).bad() || others != count ||
        !std::equal(words, words + count, other))
      return {};
  }
  // Entries of 8 bits may share a word, the first in the low byte. Some programs declare 16 bits,
  // and write 8.
  const std::size_t in_a_word = max_greys / count;
  const bool are_low = *std::max_element(words, words + count) < max_greys;
  std::vector<std::uint8_t> greys;
  for (std::size_t i = 0; i < max_greys; ++i) {
    const unsigned shift = in_a_word == 2 ? 8 * (i % 2) : are_low ? 0 : 8;
    greys.push_back(static_cast<std::uint8_t>(words[i / in_a_word] >> shift));
  }
  return greys;
}

// Returns the kind of samples that are not grey values, or nothing.
RejectReason set_samples(DcmItem& dataset, DicomImage& image) {
  const std::string photometric = text_of(dataset, DCM_PhotometricInterpretation);
  image.channels = whole_of(dataset, DCM_SamplesPerPixel).value_or(1);
  image.is_planar = whole_of(dataset, DCM_PlanarConfiguration) == 1U;
  const bool is_read = image.channels == 3 && image.compression.empty() &&
                       (photometric == "RGB" || photometric == "YBR_FULL");
  if (image.channels != 1 && !is_read) return {"a colour image"};
  if (photometric == "YBR_FULL") image.channel_names = {"Y", "Cb", "Cr"};
  const bool are_numbers = image.segments && image.segments->kind == DicomSegments::Kind::numbers;
  if (photometric.rfind("PALETTE", 0) == 0 && !are_numbers) {
    image.greys = greys_of(dataset);
    if (image.greys.empty()) return {"a colour image, by its palette"};
  }
  image.is_inverted = photometric == "MONOCHROME1";
  const auto allocated = whole_of(dataset, DCM_BitsAllocated).value_or(0);
  const auto representation = whole_of(dataset, DCM_PixelRepresentation);
  // Floating point has no PixelRepresentation.
  if (!representation && (allocated == 32 || allocated == 64)) {
    image.type = allocated == 32 ? SampleType::f32 : SampleType::f64;
    return {};
  }
  const bool is_signed = representation == 1U;
  image.is_of_bits = allocated == 1;
  image.padding = padding_of(dataset, is_signed);
  if (allocated == 1)
    image.type = SampleType::u8;
  else if (allocated == 8)
    image.type = is_signed ? SampleType::i8 : SampleType::u8;
  else if (allocated == 16)
    image.type = is_signed ? SampleType::i16 : SampleType::u16;
  else if (allocated == 32)
    image.type = is_signed ? SampleType::i32 : SampleType::u32;
  else
    return {"an image of " + std::to_string(allocated) + " bits per sample"};
  image.bits = whole_of(dataset, DCM_BitsStored).value_or(allocated);
  image.high_bit = whole_of(dataset, DCM_HighBit).value_or(image.bits - 1);
  if (image.bits < 1 || image.high_bit >= allocated || image.high_bit + 1 < image.bits)
    return {"an image of " + std::to_string(image.bits) + " bits up to bit " +
            std::to_string(image.high_bit) + " of " + std::to_string(allocated)};
  if (first_item(dataset, DCM_ModalityLUTSequence) != nullptr)
    return {"an image with a table of values (Modality LUT)",
            "apply it with pydicom, and write the values as they are: "
            "apply_modality_lut(dataset.pixel_array, dataset)"};
  return {};
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0; });
}

// Sets up the conversion of names to UTF-8, if DCMTK supports this.
void set_encoding(DcmDataset& dataset) {
  const bool has_names = dataset.tagExists(DCM_SegmentSequence) ||
                         dataset.tagExists(DCM_StructureSetROISequence) ||
                         !is_ascii(text_of(dataset, DCM_SeriesDescription));
  if (has_names) dataset.convertToUTF8();
}

void set_names(DcmItem& dataset, DicomImage& image) {
  image.series = text_of(dataset, DCM_SeriesInstanceUID);
  image.instance = text_of(dataset, DCM_SOPInstanceUID);
  image.description = name_in(dataset, dataset, DCM_SeriesDescription);
  image.modality = text_of(dataset, DCM_Modality);
  image.is_parametric_map = text_of(dataset, DCM_SOPClassUID) == UID_ParametricMapStorage;
  Sint32 number = 0;
  if (dataset.findAndGetSint32(DCM_SeriesNumber, number).good()) image.series_number = number;
  if (dataset.findAndGetSint32(DCM_InstanceNumber, number).good()) image.instance_number = number;
}

bool is_directory(DcmFileFormat& file) {
  return text_of(*file.getMetaInfo(), DCM_MediaStorageSOPClassUID) ==
         UID_MediaStorageDirectoryStorage;
}

// A slope of zero would make all values equal.
void drop_slopes_of_zero(DicomImage& image, std::vector<DicomFrame>& frames) {
  bool have_any = false;
  for (DicomFrame& frame : frames) {
    if (frame.slope != 0) continue;
    have_any = true;
    frame.slope = 1;
    frame.intercept = 0;
  }
  if (have_any) image.notes.emplace_back("RescaleSlope is 0 and is ignored");
}

// Reads all frames. Returns why they are not slices, or nothing.
RejectReason set_frames(DcmDataset& dataset, const std::shared_ptr<DicomImage>& image,
                        std::vector<DicomFrame>& frames) {
  Sint32 count = 0;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, count).bad() || count == 0) count = 1;
  if (count < 1 || static_cast<std::uint32_t>(count) > max_frames)
    return {"an image of " + std::to_string(count) + " frames"};
  for (Sint32 i = 0; i < count; ++i)
    frames.push_back(frame(dataset, image, static_cast<std::uint32_t>(i)));
  drop_slopes_of_zero(*image, frames);
  if (!have_own_positions(dataset) && is_mosaic(dataset))
    return unfold_mosaic(dataset, *image, frames);
  return place_frames(dataset, *image, frames);
}

// Returns the packing of the pixels if it is unsupported, or nothing.
RejectReason unread_packing(DcmFileFormat& file) {
  const std::string uid = text_of(*file.getMetaInfo(), DCM_TransferSyntaxUID);
  if (uid.empty() || can_decode(uid)) return {};
  const auto is_one_of = [&uid](std::initializer_list<const char*> begins) {
    return std::any_of(begins.begin(), begins.end(), [&uid](const std::string& begin) {
      return uid.rfind("1.2.840.10008.1.2." + begin, 0) == 0;
    });
  };
  const std::string in_brackets = " (" + shown(uid) + ")";
  if (is_one_of({"4.94", "4.95", "4.204", "4.205"}))
    return {"an image whose pixels are on a server, by JPIP" + in_brackets,
            "export the series from the archive again, with its pixels"};
  if (is_one_of(
          {"4.100", "4.101", "4.102", "4.103", "4.104", "4.105", "4.106", "4.107", "4.108", "7."}))
    return {"a video" + in_brackets, "it is not a volume: give a series of slices, as images"};
  const std::string name = is_one_of({"4.20"})   ? "HTJ2K"
                           : is_one_of({"4.11"}) ? "JPEG XL"
                                                 : DcmXfer(uid.c_str()).getXferName();
  return {"an image packed as " + name + in_brackets + ", which is not supported",
          "export it without compression, or unpack it, e.g. with pydicom: dataset.decompress()"};
}

// Returns the content of a file without slices, or nothing.
RejectReason read_image(DcmDataset& dataset, const std::shared_ptr<DicomImage>& image,
                        std::vector<DicomFrame>& frames) {
  image->rows = whole_of(dataset, DCM_Rows).value_or(0);
  image->columns = whole_of(dataset, DCM_Columns).value_or(0);
  set_encoding(dataset);
  if (image->rows == 0 || image->columns == 0) return without_image(dataset);
  const E_TransferSyntax syntax = dataset.getOriginalXfer();
  if (is_encapsulated(syntax)) image->compression = DcmXfer(syntax).getXferName();
  if (dataset.tagExists(DCM_SegmentationType)) image->segments = segments_of(dataset);
  for (const auto& step : {set_samples, check_decimals})
    if (RejectReason instead = step(dataset, *image)) return instead;
  set_names(dataset, *image);
  return set_frames(dataset, image, frames);
}

}  // namespace

std::uint64_t picture_bytes(const DicomImage& image) {
  const std::uint64_t across = image.mosaic ? image.mosaic->across : 1;
  const std::uint64_t samples = across * image.columns * across * image.rows * image.channels;
  return image.is_of_bits ? (samples + 7) / 8 : samples * sample_bytes(image.type);
}

std::optional<DicomPlace> place_of(const std::optional<Vector>& position,
                                   const std::optional<std::array<double, 6>>& orientation) {
  if (!position || !orientation) return std::nullopt;
  const auto along_row = direction(*orientation, 0);
  const auto along_column = direction(*orientation, 3);
  if (!along_row || !along_column) return std::nullopt;
  return DicomPlace{*position, *along_row, *along_column};
}

Vector normal_of(const DicomPlace& place) {
  return cross(place.along_row, place.along_column);
}

DicomContent dicom_content(const std::filesystem::path& file) {
  DicomContent content;
  content.instead = foreign_content(file);
  if (content.instead) return content;
  auto opened = open_dicom_file(file, Pixels::left_out);
  if (!opened) {
    content.instead.what =
        "not a DICOM file, damaged, or deflated as a whole (inflate it with dcmconv +te)";
    return content;
  }
  content.is_directory = is_directory(*opened);
  content.instead = unread_packing(*opened);
  if (content.instead) return content;
  const auto image = std::make_shared<DicomImage>();
  image->file = file;
  if (contradicts_header(*opened))
    image->notes.emplace_back("the transfer syntax in the header is wrong; the content is used");
  content.instead = read_image(*opened->getDataset(), image, content.frames);
  if (content.instead) content.frames.clear();
  return content;
}

}  // namespace discmc::command

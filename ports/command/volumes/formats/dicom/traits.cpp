#include "traits.hpp"

#include <algorithm>
#include <iterator>

#include "attributes.hpp"
#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

enum class Form {
  text,
  number,
  vector,      ///< one value per frame, as in nuclear medicine
  image_type,  ///< from the third value on; the first two may differ within a volume
  gradient,    ///< in its own sequence
  uid
};

struct Kind {
  const char* name;
  const char* unit;
  Form form;
  enum class Use { volume, stack, part, programs } use;
  DcmTagKey group;  ///< the functional group in files of many frames
  DcmTagKey key;
};

const DcmTagKey none = DCM_UndefinedTagKey;
constexpr auto volume = Kind::Use::volume, stack = Kind::Use::stack, part = Kind::Use::part,
               programs = Kind::Use::programs;

// The kinds in the order in which they separate volumes.
const Kind kinds[] = {
    {"patient", "", Form::text, volume, none, DCM_PatientID},
    {"study", "", Form::uid, volume, none, DCM_StudyInstanceUID},
    {"frame of reference", "", Form::uid, volume, none, DCM_FrameOfReferenceUID},
    {"kernel", "", Form::text, volume, DCM_CTReconstructionSequence, DCM_ConvolutionKernel},
    {"image type", "", Form::image_type, volume, none, DCM_ImageType},
    {"frame type", "", Form::image_type, volume, DCM_MRImageFrameTypeSequence, DCM_FrameType},
    {"frame type", "", Form::image_type, volume, DCM_CTImageFrameTypeSequence, DCM_FrameType},
    {"frame type", "", Form::image_type, volume, DCM_PETFrameTypeSequence, DCM_FrameType},
    {"component", "", Form::text, volume, DCM_MRImageFrameTypeSequence, DCM_ComplexImageComponent},
    {"stack", "", Form::text, stack, DCM_FrameContentSequence, DCM_StackID},
    {"energy window", "", Form::vector, part, none, DCM_EnergyWindowVector},
    {"detector", "", Form::vector, part, none, DCM_DetectorVector},
    {"phase", "", Form::vector, part, none, DCM_PhaseVector},
    {"R-R interval", "", Form::vector, part, none, DCM_RRIntervalVector},
    {"time slot", "", Form::vector, part, none, DCM_TimeSlotVector},
    {"time slice", "", Form::vector, part, none, DCM_TimeSliceVector},
    {"temporal position", "", Form::number, part, none, DCM_TemporalPositionIdentifier},
    {"temporal position", "", Form::number, part, DCM_FrameContentSequence,
     DCM_TemporalPositionIndex},
    {"time", " ms", Form::number, part, DCM_TemporalPositionSequence,
     DCM_TemporalPositionTimeOffset},
    {"label or control", "", Form::text, part, DCM_MRArterialSpinLabelingSequence, DCM_ASLContext},
    {"echo time", " ms", Form::number, part, none, DCM_EchoTime},
    {"echo time", " ms", Form::number, part, DCM_MREchoSequence, DCM_EffectiveEchoTime},
    {"b-value", " s/mm2", Form::number, part, DCM_MRDiffusionSequence, DCM_DiffusionBValue},
    {"gradient", "", Form::gradient, part, DCM_MRDiffusionSequence,
     DCM_DiffusionGradientOrientation},
    {"cardiac phase", " %", Form::number, part, DCM_CardiacSynchronizationSequence,
     DCM_NominalPercentageOfCardiacPhase},
    {"respiratory phase", " %", Form::number, part, DCM_RespiratorySynchronizationSequence,
     DCM_NominalPercentageOfRespiratoryPhase},
    {"trigger delay", " ms", Form::number, part, DCM_CardiacSynchronizationSequence,
     DCM_NominalCardiacTriggerDelayTime},
    {"trigger time", " ms", Form::number, part, none, DCM_TriggerTime},
    {"inversion time", " ms", Form::number, part, none, DCM_InversionTime},
    {"inversion time", " ms", Form::text, part, DCM_MRModifierSequence, DCM_InversionTimes},
    {"velocity direction", "", Form::text, part, DCM_MRVelocityEncodingSequence,
     DCM_VelocityEncodingDirection},
    {"data type", "", Form::text, part, DCM_ImageDataTypeSequence, DCM_DataType},
    {"flip angle", " degrees", Form::number, part, DCM_MRTimingAndRelatedParametersSequence,
     DCM_FlipAngle},
    {"repetition time", " ms", Form::number, part, DCM_MRTimingAndRelatedParametersSequence,
     DCM_RepetitionTime},
    {"tube voltage", " kV", Form::number, part, DCM_CTXRayDetailsSequence, DCM_KVP},
    {"frame reference time", " ms", Form::number, part, none, DCM_FrameReferenceTime},
    {"acquisition", "", Form::number, part, none, DCM_AcquisitionNumber},
    {"image type", "", Form::text, programs, none, DCM_ImageType},
    {"dimension index", "", Form::text, programs, DCM_FrameContentSequence,
     DCM_DimensionIndexValues},
    {"acquisition time", "", Form::text, programs, DCM_FrameContentSequence,
     DCM_FrameAcquisitionDateTime},
    {"acquisition time", "", Form::text, programs, none, DCM_AcquisitionTime},
    {"content time", "", Form::text, programs, none, DCM_ContentTime},
    {"instance number", "", Form::number, programs, none, DCM_InstanceNumber},
    {"instance", "", Form::uid, programs, none, DCM_SOPInstanceUID},
};

std::string from_third_value(const std::string& text) {
  std::size_t at = 0;
  for (int i = 0; i < 2; ++i) {
    at = text.find('\\', at);
    if (at == std::string::npos) return {};
    ++at;
  }
  return text.substr(at);
}

std::string gradient(const Attributes& attributes, const Kind& kind) {
  auto* const sequence = dynamic_cast<DcmSequenceOfItems*>(
      attributes.element(kind.group, DCM_DiffusionGradientDirectionSequence));
  if (sequence != nullptr && sequence->card() > 0) return text_of(*sequence->getItem(0), kind.key);
  return text_of(attributes.element(kind.group, kind.key));
}

std::string value_of(DcmItem& dataset, const Attributes& attributes, std::uint32_t frame,
                     const Kind& kind) {
  if (kind.form == Form::gradient) return gradient(attributes, kind);
  if (kind.form == Form::vector) {
    const auto value = real_of(dataset, kind.key, frame);
    return value ? short_number(*value) : "";
  }
  DcmElement* const element = attributes.element(kind.group, kind.key);
  if (element == nullptr) return {};
  if (kind.form == Form::number)
    if (const auto value = real_of(element)) return short_number(*value);
  const std::string text = text_of(element);
  return kind.form == Form::image_type ? from_third_value(text) : text;
}

}  // namespace

std::size_t trait_count() {
  return std::size(kinds);
}

bool is_of_volume(std::size_t kind) {
  return kinds[kind].use == Kind::Use::volume;
}

bool is_of_stack(std::size_t kind) {
  return kinds[kind].use == Kind::Use::stack;
}

bool is_uid(std::size_t kind) {
  return kinds[kind].form == Form::uid;
}

bool is_for_programs(std::size_t kind) {
  return kinds[kind].use == Kind::Use::programs || is_uid(kind);
}

bool has_order(std::size_t kind) {
  const Form form = kinds[kind].form;
  return form != Form::uid && form != Form::gradient && !is_of_volume(kind) && !is_of_stack(kind);
}

const std::string& trait_of(const DicomTraits& traits, std::size_t kind) {
  static const std::string no_value;
  const auto found = std::find_if(traits.begin(), traits.end(),
                                  [kind](const DicomTrait& each) { return each.kind == kind; });
  return found == traits.end() ? no_value : found->value;
}

std::string trait_text(std::size_t kind, const std::string& value) {
  const Kind& row = kinds[kind];
  const bool is_number = row.form == Form::number || row.form == Form::vector;
  return std::string(row.name) + ' ' + (is_number ? value : shown(value)) + row.unit;
}

const char* trait_name(std::size_t kind) {
  return kinds[kind].name;
}

bool is_trait_before(const std::string& a, const std::string& b) {
  const auto left = finite_number(a), right = finite_number(b);
  if (left && right && *left != *right) return *left < *right;
  return a < b;
}

DicomTraits traits_of(DcmItem& dataset, const Attributes& attributes, std::uint32_t frame) {
  DicomTraits traits;
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind)
    if (std::string value = value_of(dataset, attributes, frame, kinds[kind]); !value.empty())
      traits.push_back({kind, std::move(value)});
  return traits;
}

}  // namespace discmc::command

#include "pixels.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>

#include "jpeg2000.hpp"
#include "toolkit.hpp"

#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

[[noreturn]] void fail_frame(const DicomFrame& frame, const std::string& what) {
  fail(frame.image->file, "frame " + std::to_string(frame.number) + " (the first is 0): " + what,
       "export or copy the file again");
}

std::size_t frame_bytes(const DicomImage& image) {
  return std::size_t{image.columns} * image.rows * sample_bytes(image.type);
}

DcmElement& pixel_element(DcmDataset& dataset, const DicomFrame& frame) {
  const SampleType type = frame.image->type;
  const DcmTagKey key = type == SampleType::f32   ? DCM_FloatPixelData
                        : type == SampleType::f64 ? DCM_DoubleFloatPixelData
                                                  : DCM_PixelData;
  DcmElement* element = nullptr;
  if (dataset.findAndGetElement(key, element).bad() || element == nullptr)
    fail_frame(frame, "the pixel data is missing");
  return *element;
}

std::uint32_t frames(DcmDataset& dataset) {
  Sint32 count = 0;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, count).bad()) return 1;
  return static_cast<std::uint32_t>(std::max(count, 1));
}

bool is_jpeg2000(E_TransferSyntax syntax) {
  return syntax == EXS_JPEG2000LosslessOnly || syntax == EXS_JPEG2000;
}

// The fragments of compressed pixel data: after a table of offsets the frames, of one or more each.
class Fragments {
 public:
  Fragments(DcmDataset& dataset, DcmElement& element, const DicomFrame& frame)
      : frame_(frame), frames_(frames(dataset)) {
    auto* pixels = dynamic_cast<DcmPixelData*>(&element);
    E_TransferSyntax syntax = EXS_Unknown;
    const DcmRepresentationParameter* parameter = nullptr;
    if (pixels != nullptr) pixels->getOriginalRepresentationKey(syntax, parameter);
    if (pixels == nullptr ||
        pixels->getEncapsulatedRepresentation(syntax, parameter, sequence_).bad())
      fail_frame(frame, "the compressed pixel data is missing");
  }

  Uint32 end() const { return static_cast<Uint32>(sequence_->card()); }

  /// The first fragment of a frame, where that is told.
  std::optional<Uint32> start(std::uint32_t number) const {
    Uint32 fragment = 0;
    if (DcmCodec::determineStartFragment(number, static_cast<Sint32>(frames_), sequence_, fragment)
            .bad())
      return std::nullopt;
    return fragment;
  }

  /// All bytes of the frame.
  std::vector<std::uint8_t> bytes() {
    const auto first = start(frame_.number);
    const auto beyond = frame_.number + 1 < frames_ ? start(frame_.number + 1) : end();
    if (!first || !beyond) fail_frame(frame_, "its part of the compressed pixel data is not told");
    std::vector<std::uint8_t> all;
    for (Uint32 i = *first; i < *beyond; ++i) {
      DcmPixelItem& item = at(i);
      Uint8* bytes = nullptr;
      if (item.getUint8Array(bytes).bad() || bytes == nullptr)
        fail_frame(frame_, "the compressed pixel data ends early");
      all.insert(all.end(), bytes, bytes + item.getLength());
    }
    drop(*first, *beyond);
    return all;
  }

  /// Leaves fragments in the file, which reading has brought into memory.
  void drop(Uint32 first, Uint32 beyond) {
    for (Uint32 i = first; i < std::min(beyond, end()); ++i) at(i).compact();
  }

 private:
  DcmPixelItem& at(unsigned long index) {
    DcmPixelItem* item = nullptr;
    if (sequence_->getItem(item, index).bad() || item == nullptr)
      fail_frame(frame_, "the compressed pixel data ends early");
    return *item;
  }

  const DicomFrame& frame_;
  std::uint32_t frames_;
  DcmPixelSequence* sequence_ = nullptr;
};

// Leaves of every sample its bits, and its sign above them.
template <class Sample>
void cut_to_bits(const DicomImage& image, unsigned char* samples, std::size_t bytes) {
  constexpr std::uint32_t width = 8 * sizeof(Sample);
  const std::uint32_t above = width - 1 - image.high_bit;
  const std::uint32_t below = width - image.bits;
  for (std::size_t at = 0; at < bytes; at += sizeof(Sample)) {
    std::make_unsigned_t<Sample> raw{};
    std::memcpy(&raw, samples + at, sizeof raw);
    raw = static_cast<std::make_unsigned_t<Sample>>(raw << above);
    Sample sample{};
    std::memcpy(&sample, &raw, sizeof sample);
    sample = static_cast<Sample>(sample >> below);  // of signed ones arithmetic
    std::memcpy(samples + at, &sample, sizeof sample);
  }
}

void cut_to_bits(const DicomImage& image, unsigned char* samples, std::size_t bytes) {
  with_sample_type(image.type, [&](auto sample) {
    using Sample = decltype(sample);
    if constexpr (std::is_integral_v<Sample>)
      if (image.bits < 8 * sizeof(Sample)) cut_to_bits<Sample>(image, samples, bytes);
  });
}

}  // namespace

DicomPixels::DicomPixels() = default;
DicomPixels::~DicomPixels() = default;

void DicomPixels::read_floats(DcmElement& element, const DicomFrame& frame) {
  const std::uint64_t bytes = frame_bytes(*frame.image);
  const std::uint64_t begin = frame.number * bytes;
  if (begin + bytes > element.getLength() ||
      element
          .getPartialValue(decoded_.data(), static_cast<Uint32>(begin), static_cast<Uint32>(bytes))
          .bad())
    fail_frame(frame, "the pixel data ends early");
}

void DicomPixels::read_jpeg2000(DcmDataset& dataset, DcmElement& element, const DicomFrame& frame) {
  const DicomImage& image = *frame.image;
  const auto stream = Fragments(dataset, element, frame).bytes();
  const std::string damage = decode_jpeg2000(
      stream, {image.columns, image.rows, static_cast<std::uint32_t>(sample_bytes(image.type))},
      decoded_.data());
  if (!damage.empty()) fail_frame(frame, damage);
}

void DicomPixels::read_frame(DcmDataset& dataset, DcmElement& element, const DicomFrame& frame) {
  if (frame_bytes_by_header(element, dataset) != frame_bytes(*frame.image))
    fail_frame(frame, "the pixel data has another size than the header says");
  std::optional<Fragments> fragments;
  if (is_encapsulated(dataset.getOriginalXfer())) fragments.emplace(dataset, element, frame);
  // Where the file does not tell where frames begin, that is found behind the one before.
  Uint32 fragment = 0;
  if (frame.number == next_frame_)
    fragment = next_fragment_;
  else if (fragments)
    fragment = fragments->start(frame.number).value_or(0);
  const Uint32 first = fragment;
  OFString color_model;
  const OFCondition result =
      element.getUncompressedFrame(&dataset, frame.number, fragment, decoded_.data(),
                                   static_cast<Uint32>(decoded_.size()), color_model);
  if (result.bad())
    fail_frame(frame, std::string("the pixel data cannot be decoded (") + result.text() + ")");
  if (fragments) fragments->drop(first, fragment);
  next_frame_ = frame.number + 1;
  next_fragment_ = fragment;
}

void DicomPixels::read(const DicomFrame& frame, void* samples) {
  if (image_ != frame.image) {
    opened_ = open_dicom_file(frame.image->file, Pixels::included);
    image_ = frame.image;
    next_frame_ = 0;
    next_fragment_ = 0;
  }
  if (!opened_) fail_frame(frame, "the file cannot be read to its end");
  DcmDataset& dataset = *opened_->getDataset();
  DcmElement& element = pixel_element(dataset, frame);
  const std::size_t bytes = frame_bytes(*frame.image);
  decoded_.resize(bytes + bytes % 2);  // DCMTK pads frames to an even length
  const E_TransferSyntax syntax = dataset.getOriginalXfer();
  if (is_floating(frame.image->type))
    read_floats(element, frame);
  else if (is_jpeg2000(syntax))
    read_jpeg2000(dataset, element, frame);
  else
    read_frame(dataset, element, frame);
  cut_to_bits(*frame.image, decoded_.data(), bytes);
  std::memcpy(samples, decoded_.data(), bytes);
}

}  // namespace discmc::command

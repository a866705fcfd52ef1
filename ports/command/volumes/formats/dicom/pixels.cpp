#include "pixels.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <type_traits>

#include "jpeg2000.hpp"
#include "jpeg_header.hpp"
#include "rle.hpp"
#include "toolkit.hpp"

#include <dcmtk/dcmdata/dccodec.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

#include "volumes/volume_error.hpp"

namespace discmc::command {

// A picture in a file: of a mosaic the only one, otherwise one a frame.
struct StoredPicture {
  const DicomImage& image;
  std::uint32_t number;
};

namespace {

StoredPicture picture_of(const DicomFrame& frame) {
  return {*frame.image, frame.image->mosaic ? 0 : frame.number};
}

[[noreturn]] void fail_picture(const StoredPicture& picture, const std::string& what) {
  fail(picture.image.file, "frame " + std::to_string(picture.number) + " (the first is 0): " + what,
       "export or copy the file again");
}

DcmElement& pixel_element(DcmDataset& dataset, const StoredPicture& picture) {
  const SampleType type = picture.image.type;
  const DcmTagKey key = type == SampleType::f32   ? DCM_FloatPixelData
                        : type == SampleType::f64 ? DCM_DoubleFloatPixelData
                                                  : DCM_PixelData;
  DcmElement* element = nullptr;
  if (dataset.findAndGetElement(key, element).bad() || element == nullptr)
    fail_picture(picture, "the pixel data is missing");
  return *element;
}

std::uint32_t frames(DcmDataset& dataset) {
  Sint32 count = 0;
  if (dataset.findAndGetSint32(DCM_NumberOfFrames, count).bad()) return 1;
  return static_cast<std::uint32_t>(std::max(count, 1));
}

// Of a mosaic, that of all of it.
PictureSize stored_size(const DicomImage& image) {
  const std::uint32_t across = image.mosaic ? image.mosaic->across : 1;
  return {across * image.columns, across * image.rows,
          static_cast<std::uint32_t>(sample_bytes(image.type))};
}

// The fragments of compressed pixel data: after a table of offsets the frames, of one or more each.
class Fragments {
 public:
  Fragments(DcmDataset& dataset, DcmElement& element, const StoredPicture& picture)
      : picture_(picture), frames_(frames(dataset)) {
    auto* pixels = dynamic_cast<DcmPixelData*>(&element);
    E_TransferSyntax syntax = EXS_Unknown;
    const DcmRepresentationParameter* parameter = nullptr;
    if (pixels != nullptr) pixels->getOriginalRepresentationKey(syntax, parameter);
    if (pixels == nullptr ||
        pixels->getEncapsulatedRepresentation(syntax, parameter, sequence_).bad())
      fail_picture(picture, "the compressed pixel data is missing");
  }

  Uint32 end() const { return static_cast<Uint32>(sequence_->card()); }

  /// The first fragment of a frame, if the file stores that.
  std::optional<Uint32> start(std::uint32_t number) const {
    Uint32 fragment = 0;
    if (DcmCodec::determineStartFragment(number, static_cast<Sint32>(frames_), sequence_, fragment)
            .bad())
      return std::nullopt;
    return fragment;
  }

  /// All bytes of the frame.
  std::vector<std::uint8_t> bytes() {
    const auto first = start(picture_.number);
    const auto beyond = picture_.number + 1 < frames_ ? start(picture_.number + 1) : end();
    if (!first || !beyond)
      fail_picture(picture_, "its part of the compressed pixel data is unknown");
    if (*first >= *beyond) fail_picture(picture_, "the offsets of frames are not in order");
    std::vector<std::uint8_t> all;
    for (Uint32 i = *first; i < *beyond; ++i) {
      const Uint8* const bytes = content(i);
      all.insert(all.end(), bytes, bytes + at(i).getLength());
    }
    drop(*first, *beyond);
    return all;
  }

  /// The first fragment of the frame, in JPEG of the right size. next: the one that follows the
  /// previous frame, 0 if that is unknown.
  Uint32 jpeg_start(Uint32 next) {
    const Uint32 first = next > 0 ? next : start(picture_.number).value_or(0);
    if (first == 0) fail_picture(picture_, "its part of the compressed pixel data is unknown");
    const std::string mismatch =
        jpeg_mismatch(content(first), at(first).getLength(), stored_size(picture_.image));
    if (!mismatch.empty()) fail_picture(picture_, mismatch);
    return first;
  }

  /// Leaves fragments in the file, which reading has brought into memory.
  void drop(Uint32 first, Uint32 beyond) {
    for (Uint32 i = first; i < std::min(beyond, end()); ++i) at(i).compact();
  }

 private:
  DcmPixelItem& at(unsigned long index) {
    DcmPixelItem* item = nullptr;
    if (sequence_->getItem(item, index).bad() || item == nullptr)
      fail_picture(picture_, "the compressed pixel data ends early");
    return *item;
  }

  const Uint8* content(Uint32 index) {
    DcmPixelItem& item = at(index);
    Uint8* bytes = nullptr;
    if (item.getLength() == 0)
      fail_picture(picture_, "fragment " + std::to_string(index) + " of the pixel data is empty");
    if (item.getUint8Array(bytes).bad() || bytes == nullptr)
      fail_picture(picture_, "the compressed pixel data ends early");
    return bytes;
  }

  StoredPicture picture_;
  std::uint32_t frames_;
  DcmPixelSequence* sequence_ = nullptr;
};

// DCMTK puts the bytes of 16 bits in native order. The words of longer samples in big-endian files
// are then in the wrong order, and all bytes in files that declare them as bytes.
void put_in_order(E_TransferSyntax syntax, DcmElement& element, std::size_t size,
                  unsigned char* samples, std::size_t bytes) {
  if (!DcmXfer(syntax).isBigEndian() || gLocalByteOrder == EBO_BigEndian) return;
  const std::size_t unit = element.getVR() == EVR_OB ? 1 : 2;
  for (std::size_t at = 0; at + size <= bytes; at += size)
    for (std::size_t low = 0, high = size - unit; low < high; low += unit, high -= unit)
      std::swap_ranges(samples + at + low, samples + at + low + unit, samples + at + high);
}

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

void DicomPixels::read_bytes(DcmElement& element, const StoredPicture& picture, std::uint64_t begin,
                             std::uint64_t bytes) {
  if (begin + bytes > element.getLength() ||
      element
          .getPartialValue(decoded_.data(), static_cast<Uint32>(begin), static_cast<Uint32>(bytes))
          .bad())
    fail_picture(picture, "the pixel data ends early");
}

void DicomPixels::read_bits(DcmDataset& dataset, DcmElement& element,
                            const StoredPicture& picture) {
  if (is_encapsulated(dataset.getOriginalXfer()))
    fail_picture(picture, "compressed samples of one bit are not supported");
  // Pictures follow each other without a gap, the lowest bit of a byte first.
  const std::uint64_t count = std::uint64_t{picture.image.columns} * picture.image.rows;
  const std::uint64_t first = picture.number * count;
  read_bytes(element, picture, first / 8, (first + count + 7) / 8 - first / 8);
  for (std::uint64_t i = count; i-- > 0;) {
    const std::uint64_t bit = first % 8 + i;
    decoded_[i] = decoded_[bit / 8] >> bit % 8 & 1;
  }
}

void DicomPixels::read_compressed(DcmDataset& dataset, DcmElement& element,
                                  const StoredPicture& picture) {
  const auto bytes = Fragments(dataset, element, picture).bytes();
  const auto decoder = dataset.getOriginalXfer() == EXS_RLELossless ? decode_rle : decode_jpeg2000;
  const std::string damage = decoder(bytes, stored_size(picture.image), decoded_.data());
  if (!damage.empty()) fail_picture(picture, damage);
}

void DicomPixels::read_picture(DcmDataset& dataset, DcmElement& element,
                               const StoredPicture& picture) {
  if (frame_bytes_by_header(element, dataset) != picture_bytes(picture.image))
    fail_picture(picture, "the pixel data has another size than the header");
  const E_TransferSyntax syntax = dataset.getOriginalXfer();
  std::optional<Fragments> fragments;
  if (is_encapsulated(syntax)) fragments.emplace(dataset, element, picture);
  const std::uint64_t counted = frames(dataset);
  const std::uint64_t there =
      fragments ? counted : element.getLength() / picture_bytes(picture.image);
  left_out_ = there - std::min(there, counted);
  // If the file does not store where frames begin, each begins after the previous one.
  const Uint32 next = picture.number == next_picture_ ? next_fragment_ : 0;
  const Uint32 first = fragments ? fragments->jpeg_start(next) : 0;
  Uint32 fragment = first;
  OFString color_model;
  const OFCondition result =
      element.getUncompressedFrame(&dataset, picture.number, fragment, decoded_.data(),
                                   static_cast<Uint32>(decoded_.size()), color_model);
  if (result.bad())
    fail_picture(picture, std::string("the pixel data cannot be decoded (") + result.text() + ")");
  if (fragments) fragments->drop(first, fragment);
  next_picture_ = picture.number + 1;
  next_fragment_ = fragment;
  if (!fragments)
    put_in_order(syntax, element, sample_bytes(picture.image.type), decoded_.data(),
                 decoded_.size());
}

void DicomPixels::decode(const StoredPicture& picture) {
  if (!opened_) fail_picture(picture, "the file cannot be read to its end");
  DcmDataset& dataset = *opened_->getDataset();
  DcmElement& element = pixel_element(dataset, picture);
  const DicomImage& image = picture.image;
  const std::uint64_t bytes = picture_bytes(image);
  // One more of bits, of which the first may be within a byte, and of what DCMTK pads.
  decoded_.resize(std::max<std::uint64_t>(bytes + 1, std::uint64_t{image.columns} * image.rows));
  if (is_floating(image.type))
    read_bytes(element, picture, picture.number * bytes, bytes);
  else if (image.is_of_bits)
    read_bits(dataset, element, picture);
  else if (is_decoded_here(dataset.getOriginalXfer()))
    read_compressed(dataset, element, picture);
  else
    read_picture(dataset, element, picture);
  if (!image.is_of_bits) cut_to_bits(image, decoded_.data(), bytes);
}

void DicomPixels::read(const DicomFrame& frame, void* samples) {
  const StoredPicture picture = picture_of(frame);
  const DicomImage& image = *frame.image;
  if (image_ != frame.image) {
    opened_ = open_dicom_file(image.file, Pixels::included);
    image_ = frame.image;
    next_picture_ = 0;
    next_fragment_ = 0;
    is_decoded_ = false;
  }
  if (!image.mosaic || !is_decoded_) decode(picture);
  is_decoded_ = true;
  const std::size_t row = std::size_t{image.columns} * sample_bytes(image.type);
  if (!image.mosaic) {
    std::memcpy(samples, decoded_.data(), image.rows * row);
    return;
  }
  const std::size_t across = image.mosaic->across;
  const unsigned char* from = decoded_.data() + frame.number / across * image.rows * across * row +
                              frame.number % across * row;
  for (std::size_t y = 0; y < image.rows; ++y)
    std::memcpy(static_cast<unsigned char*>(samples) + y * row, from + y * across * row, row);
}

}  // namespace discmc::command

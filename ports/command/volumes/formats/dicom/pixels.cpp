#include "pixels.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "decoders.hpp"
#include "toolkit.hpp"

#include <dcmtk/dcmdata/dcpixseq.h>

#include "volumes/volume_error.hpp"

namespace discmc::command {

// A picture in a file: the only picture of a mosaic, otherwise one per frame.
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

// Returns the extents of a picture; for a mosaic, of the whole mosaic.
PictureSize stored_size(const DicomImage& image) {
  const std::uint32_t across = image.mosaic ? image.mosaic->across : 1;
  return {across * image.columns, across * image.rows,
          static_cast<std::uint32_t>(sample_bytes(image.type))};
}

DicomFragments fragments(DcmDataset& dataset, DcmElement& element, const StoredPicture& picture) {
  auto* const pixels = dynamic_cast<DcmPixelData*>(&element);
  E_TransferSyntax syntax = EXS_Unknown;
  const DcmRepresentationParameter* parameter = nullptr;
  DcmPixelSequence* sequence = nullptr;
  if (pixels != nullptr) pixels->getOriginalRepresentationKey(syntax, parameter);
  if (pixels == nullptr ||
      pixels->getEncapsulatedRepresentation(syntax, parameter, sequence).bad() ||
      sequence == nullptr)
    fail_picture(picture, "the compressed pixel data is missing");
  return {*sequence, frame_count(dataset)};
}

// DCMTK puts each 16-bit word into native order. In big-endian files, the words of longer samples
// remain in the wrong order. If the file declares the samples as bytes, all their bytes remain in
// the wrong order.
void put_in_order(E_TransferSyntax syntax, DcmElement& element, std::size_t size,
                  unsigned char* samples, std::size_t bytes) {
  if (!DcmXfer(syntax).isBigEndian() || gLocalByteOrder == EBO_BigEndian) return;
  const std::size_t unit = element.getVR() == EVR_OB ? 1 : 2;
  if (size <= unit) return;
  for (std::size_t at = 0; at + size <= bytes; at += size)
    for (std::size_t low = 0, high = size - unit; low < high; low += unit, high -= unit)
      std::swap_ranges(samples + at + low, samples + at + low + unit, samples + at + high);
}

// Keeps only the bits of a sample, and extends its sign above them.
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
    sample = static_cast<Sample>(sample >> below);  // arithmetic shift of signed samples
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
  if (!fragments_)
    fragments_ = std::make_unique<DicomFragments>(fragments(dataset, element, picture));
  left_out_ = fragments_->left_out();
  std::string damage = fragments_->read(picture.number, compressed_);
  const E_TransferSyntax syntax = dataset.getOriginalXfer();
  const PictureSize size = stored_size(picture.image);
  if (!damage.empty()) fail_picture(picture, damage);
  if (syntax == EXS_RLELossless)
    damage = decode_rle(compressed_, size, decoded_.data());
  else if (is_decoded_here(syntax))
    damage = decode_jpeg2000(compressed_, size, decoded_.data());
  else
    damage = decode_jpeg(compressed_, size, dataset, decoded_.data());
  if (!damage.empty()) fail_picture(picture, damage);
}

void DicomPixels::read_uncompressed(DcmDataset& dataset, DcmElement& element,
                                    const StoredPicture& picture) {
  const std::uint64_t bytes = picture_bytes(picture.image);
  if (frame_bytes_by_header(element, dataset) != bytes)
    fail_picture(picture, "the pixel data has another size than the header");
  const std::uint64_t stored_frames = element.getLength() / bytes;
  left_out_ = stored_frames - std::min<std::uint64_t>(stored_frames, frame_count(dataset));
  Uint32 fragment = 0;
  OFString color_model;
  const OFCondition result =
      element.getUncompressedFrame(&dataset, picture.number, fragment, decoded_.data(),
                                   static_cast<Uint32>(decoded_.size()), color_model);
  if (result.bad())
    fail_picture(picture, std::string("the pixel data cannot be decoded (") + result.text() + ")");
  put_in_order(dataset.getOriginalXfer(), element, sample_bytes(picture.image.type),
               decoded_.data(), decoded_.size());
}

void DicomPixels::decode(const StoredPicture& picture) {
  if (!opened_) fail_picture(picture, "the file cannot be read to its end");
  DcmDataset& dataset = *opened_->getDataset();
  DcmElement& element = pixel_element(dataset, picture);
  const DicomImage& image = picture.image;
  const std::uint64_t bytes = picture_bytes(image);
  // Bits may begin within a byte, and DCMTK pads to even sizes: reserves one more byte.
  decoded_.resize(std::max<std::uint64_t>(bytes + 1, std::uint64_t{image.columns} * image.rows));
  if (is_floating(image.type))
    read_bytes(element, picture, picture.number * bytes, bytes);
  else if (image.is_of_bits)
    read_bits(dataset, element, picture);
  else if (is_encapsulated(dataset.getOriginalXfer()))
    read_compressed(dataset, element, picture);
  else
    read_uncompressed(dataset, element, picture);
  if (!image.is_of_bits) cut_to_bits(image, decoded_.data(), bytes);
  if (!image.greys.empty())
    std::transform(decoded_.begin(), decoded_.end(), decoded_.begin(),
                   [&image](unsigned char index) { return image.greys[index]; });
}

void DicomPixels::read(const DicomFrame& frame, void* samples) {
  const StoredPicture picture = picture_of(frame);
  const DicomImage& image = *frame.image;
  if (image_ != frame.image) {
    fragments_.reset();
    opened_ = open_dicom_file(image.file, Pixels::included);
    image_ = frame.image;
    is_decoded_ = false;
  }
  if (!image.mosaic || !is_decoded_) decode(picture);
  is_decoded_ = true;
  const std::size_t sample = sample_bytes(image.type);
  const std::size_t row = std::size_t{image.columns} * image.channels * sample;
  if (image.is_planar && image.channels > 1) {
    const std::size_t count = std::size_t{image.columns} * image.rows;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t channel = 0; channel < image.channels; ++channel)
        std::memcpy(static_cast<unsigned char*>(samples) + (i * image.channels + channel) * sample,
                    decoded_.data() + (channel * count + i) * sample, sample);
    return;
  }
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

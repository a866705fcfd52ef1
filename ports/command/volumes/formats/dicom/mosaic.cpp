#include "image.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "attributes.hpp"
#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volumes/byte_source.hpp"

namespace discmc::command {
namespace {

// The values of each element, as text without blanks.
using CsaHeader = std::map<std::string, std::vector<std::string>>;

// Removes little-endian numbers and texts from the front; returns nothing beyond the end.
class ByteParser {
 public:
  explicit ByteParser(std::string_view bytes) : left_(bytes) {}

  std::optional<std::string_view> bytes(std::size_t count) {
    if (count > left_.size()) return std::nullopt;
    const std::string_view front = left_.substr(0, count);
    left_.remove_prefix(count);
    return front;
  }

  std::optional<std::uint32_t> number() {
    const auto four = bytes(4);
    if (!four) return std::nullopt;
    return static_cast<std::uint32_t>(whole_of(four->data(), four->size(), false));
  }

 private:
  std::string_view left_;
};

std::string text(std::string_view padded) {
  return std::string(trimmed(padded.substr(0, padded.find('\0'))));
}

struct Element {
  std::string name;
  std::uint32_t values = 0;  ///< number of values; further items are empty
  std::uint32_t items = 0;
};

std::optional<Element> parse_element(ByteParser& parser) {
  const auto name = parser.bytes(64);
  const auto values = parser.number();
  const auto kind = parser.bytes(8);  // the value representation, twice
  const auto items = parser.number();
  const auto check = parser.number();
  if (!name || !values || !kind || !items || !check) return std::nullopt;
  return Element{text(*name), *values, *items};
}

// Four numbers precede an item. In the newer kind, the second is the length of the item. In the
// older kind, the first is this length plus an excess, the item count of the first element.
std::optional<std::string_view> parse_item(ByteParser& parser, bool is_newer,
                                           std::uint32_t excess) {
  const auto first = parser.number();
  const auto second = parser.number();
  if (!first || !second || !parser.bytes(8)) return std::nullopt;
  if (!is_newer && *first < excess) return std::nullopt;
  const std::uint32_t length = is_newer ? *second : *first - excess;
  const auto item = parser.bytes(length);
  const std::uint32_t padding = (4 - length % 4) % 4;
  if (!item || !parser.bytes(padding)) return std::nullopt;
  return item;
}

// Reads a CSA image header, of the newer kind (SV10) or the older one. Accepts any bytes, and
// returns what precedes the first damage.
CsaHeader read_csa_header(std::string_view bytes) {
  constexpr std::uint32_t max_elements = 1000;
  const bool is_newer = bytes.substr(0, 4) == "SV10";
  if (is_newer) bytes.remove_prefix(std::min<std::size_t>(8, bytes.size()));
  ByteParser parser(bytes);
  CsaHeader header;
  const auto elements = parser.number();
  if (!elements || *elements > max_elements || !parser.number()) return header;
  std::uint32_t excess = 0;
  for (std::uint32_t i = 0; i < *elements; ++i) {
    const auto element = parse_element(parser);
    if (!element) return header;
    if (i == 0) excess = element->items;
    for (std::uint32_t item = 0; item < element->items; ++item) {
      const auto value = parse_item(parser, is_newer, excess);
      if (!value) return header;
      if (item < element->values) header[element->name].push_back(text(*value));
    }
  }
  return header;
}

// Returns the element of a private block, wherever the file has put the block.
DcmTagKey private_key(DcmItem& dataset, Uint16 group, const std::string& creator, Uint16 element) {
  for (DcmObject* each = dataset.nextInContainer(nullptr); each != nullptr;
       each = dataset.nextInContainer(each)) {
    const Uint16 block = each->getETag();
    OFString name;
    if (each->getGTag() == group && block >= 0x10 && block <= 0xff &&
        static_cast<DcmElement*>(each)->getOFString(name, 0).good() &&
        std::string_view(name.c_str(), name.length()) == creator)
      return DcmTagKey(group, static_cast<Uint16>(block << 8 | element));
  }
  return DCM_UndefinedTagKey;
}

CsaHeader csa_header(DcmItem& dataset) {
  const Uint8* bytes = nullptr;
  unsigned long count = 0;
  if (dataset
          .findAndGetUint8Array(private_key(dataset, 0x0029, "SIEMENS CSA HEADER", 0x10), bytes,
                                &count)
          .bad() ||
      bytes == nullptr)
    return {};
  return read_csa_header({reinterpret_cast<const char*>(bytes), count});
}

std::optional<double> csa_number(const CsaHeader& header, const std::string& name,
                                 std::size_t index = 0) {
  const auto found = header.find(name);
  if (found == header.end() || found->second.size() <= index) return std::nullopt;
  return decimal(found->second[index]);
}

std::uint32_t count_of_slices(DcmItem& dataset, const CsaHeader& header) {
  constexpr double max_slices = 65536;
  auto count = csa_number(header, "NumberOfImagesInMosaic");
  if (!count) count = real_of(dataset, private_key(dataset, 0x0019, "SIEMENS MR HEADER", 0x0a));
  return count && *count >= 1 && *count <= max_slices ? static_cast<std::uint32_t>(*count) : 0;
}

bool is_called_mosaic(DcmItem& dataset) {
  return text_of(dataset, DCM_ImageType).find("MOSAIC") != std::string::npos;
}

bool is_united_imaging_grid(DcmItem& dataset) {
  const auto count = real_of(dataset, private_key(dataset, 0x0065, "Image Private Header", 0x50));
  return count.value_or(0) > 1;
}

// Returns the slices of a mosaic; the mosaic's position is in its single frame.
std::vector<DicomFrame> slices_of(const DicomFrame& mosaic, const DicomImage& image,
                                  std::uint32_t slices, const Vector& step) {
  const double aside = (image.mosaic->across - 1) / 2.0;  // in slices
  const DicomPlace& place = *mosaic.place;
  Vector first = place.position;
  first = sum(first, aside * image.columns * mosaic.spacing_mm[0], place.along_row);
  first = sum(first, aside * image.rows * mosaic.spacing_mm[1], place.along_column);
  std::vector<DicomFrame> frames(slices, mosaic);
  for (std::uint32_t slice = 0; slice < slices; ++slice) {
    frames[slice].number = slice;
    frames[slice].place->position = sum(first, slice, step);
  }
  return frames;
}

}  // namespace

bool is_mosaic(DcmItem& dataset) {
  if (is_called_mosaic(dataset)) return true;
  return text_of(dataset, DCM_Modality) == "MR" &&
         (is_united_imaging_grid(dataset) || count_of_slices(dataset, csa_header(dataset)) > 1);
}

RejectReason unfold_mosaic(DcmItem& dataset, DicomImage& image, std::vector<DicomFrame>& frames) {
  const std::string remedy = "convert it to NIfTI, e.g. with dcm2niix";
  if (is_united_imaging_grid(dataset))
    return {"a grid of slices in one picture (United Imaging)", remedy};
  const CsaHeader header = csa_header(dataset);
  const std::uint32_t slices = count_of_slices(dataset, header);
  const std::string called = "a Siemens mosaic of " +
                             (slices > 0 ? std::to_string(slices) : "an unknown number of") +
                             " slices";
  Vector towards{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto component = csa_number(header, "SliceNormalVector", i);
    if (!component || slices == 0)
      return {called + " without the CSA header (0029,xx10), which holds their direction",
              remedy + ", which assumes a direction"};
    towards[i] = *component;
  }
  const auto across = static_cast<std::uint32_t>(std::ceil(std::sqrt(slices)));
  if (frames.size() != 1 || image.columns % across != 0 || image.rows % across != 0)
    return {called + " that do not fit in " + std::to_string(image.columns) + " x " +
                std::to_string(image.rows) + " voxels",
            remedy};
  const DicomFrame first = frames.front();
  if (!first.place || !(first.spacing_mm[0] > 0 && first.spacing_mm[1] > 0) ||
      !(first.slice_spacing_mm > 0))
    return {called + " without a position or a voxel size", remedy};

  image.mosaic = {across};
  image.columns /= across;
  image.rows /= across;
  Vector step = normal_of(*first.place);
  const double along = dot(step, towards);
  constexpr double min_cosine = 0.5;  // SliceNormalVector is the normal, up to its sign
  if (!(std::fabs(along) > min_cosine))
    return {called + " whose SliceNormalVector is not a normal", remedy};
  for (double& component : step) component *= std::copysign(first.slice_spacing_mm, along);
  frames = slices_of(first, image, slices, step);
  return {};
}

}  // namespace discmc::command

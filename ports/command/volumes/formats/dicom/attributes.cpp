#include "attributes.hpp"

#include <iconv.h>

#include <algorithm>
#include <cmath>

#include "text/number_text.hpp"
#include "text/words.hpp"

namespace discmc::command {

DcmElement* element_of(DcmItem& item, const DcmTagKey& key) {
  DcmElement* element = nullptr;
  return item.findAndGetElement(key, element).good() ? element : nullptr;
}

DcmItem* first_item(DcmItem& item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  return item.findAndGetSequenceItem(sequence, found).good() ? found : nullptr;
}

std::string text_of(DcmElement* element) {
  OFString value;
  if (element == nullptr || element->getOFStringArray(value).bad()) return {};
  std::string found(value.c_str(), value.size());
  std::replace(found.begin(), found.end(), '\0', ' ');
  return std::string(trimmed(found));
}

std::string name_in(DcmItem& dataset, DcmItem& item, const DcmTagKey& key) {
  const std::string set = text_of(dataset, DCM_SpecificCharacterSet);
  std::string text = text_of(item, key);
  const auto has = [&](const char* name) { return set.find(name) != std::string::npos; };
  if (!has("ISO 2022")) return text;
  const bool is_korean = has("IR 149"), is_chinese = has("IR 58");
  const iconv_t converter = iconv_open("UTF-8", is_korean    ? "EUC-KR"
                                                : is_chinese ? "GB2312"
                                                             : "ISO-2022-JP-2");
  if (converter == reinterpret_cast<iconv_t>(-1)) return text;
  // These have letters of 8 bits, as without what announces them.
  for (const char* const announced : {"\x1b$)C", "\x1b$)A"})
    for (std::size_t at = 0; (at = text.find(announced)) != std::string::npos;) text.erase(at, 4);
  std::string utf8(4 * text.size() + 1, '\0');
  char* in = text.data();
  char* out = utf8.data();
  std::size_t in_left = text.size(), out_left = utf8.size();
  const bool is_read = iconv(converter, &in, &in_left, &out, &out_left) != std::size_t(-1);
  iconv_close(converter);
  utf8.resize(utf8.size() - out_left);
  return is_read ? utf8 : text;
}

std::optional<double> real_of(DcmElement* element, unsigned long index) {
  constexpr double max_magnitude = 1e9;  // of millimetres and values
  OFString text;                         // of binary numbers, too, with all their digits
  if (element == nullptr || element->getOFString(text, index).bad()) return std::nullopt;
  const auto value = decimal({text.data(), text.length()});
  if (!value || !(std::fabs(*value) <= max_magnitude)) return std::nullopt;
  return value;
}

std::optional<std::uint32_t> whole_of(DcmItem& item, const DcmTagKey& key) {
  Uint16 value = 0;
  if (item.findAndGetUint16(key, value).bad()) return std::nullopt;
  return value;
}

Attributes::Attributes(DcmItem& dataset, std::uint32_t frame) : dataset_(dataset) {
  DcmItem* item = nullptr;
  if (dataset
          .findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, item,
                                  static_cast<signed long>(frame))
          .good())
    groups_.push_back(item);
  if (dataset.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, item).good())
    groups_.push_back(item);
}

DcmElement* Attributes::grouped_element(const DcmTagKey& group, const DcmTagKey& key) const {
  for (DcmItem* functional : groups_)
    if (DcmItem* const item = first_item(*functional, group))
      if (DcmElement* const element = element_of(*item, key)) return element;
  return nullptr;
}

DcmElement* Attributes::element(const DcmTagKey& group, const DcmTagKey& key) const {
  DcmElement* const grouped = grouped_element(group, key);
  return grouped != nullptr ? grouped : element_of(dataset_, key);
}

}  // namespace discmc::command

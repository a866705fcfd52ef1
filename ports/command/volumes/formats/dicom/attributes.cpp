#include "attributes.hpp"

#include <iconv.h>

#include <algorithm>
#include <cmath>

#include "text/name_text.hpp"
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

namespace {

// Converts text to UTF-8. A character set that the text itself chooses stays until the next choice.
class ToUtf8 {
 public:
  explicit ToUtf8(const char* set) : converter_(iconv_open("UTF-8", set)) {}
  ToUtf8(const ToUtf8&) = delete;
  ToUtf8& operator=(const ToUtf8&) = delete;
  ~ToUtf8() {
    if (is_open()) iconv_close(converter_);
  }

  // Returns false if the text is not valid in the character set.
  bool add(std::string text, std::string& to) {
    if (!is_open()) return false;
    std::string converted(4 * text.size() + 1, '\0');
    char* in = text.data();
    char* out = converted.data();
    std::size_t in_left = text.size(), out_left = converted.size();
    if (iconv(converter_, &in, &in_left, &out, &out_left) == std::size_t(-1)) return false;
    to.append(converted, 0, converted.size() - out_left);
    return true;
  }

 private:
  bool is_open() const { return converter_ != reinterpret_cast<iconv_t>(-1); }

  iconv_t converter_;
};

bool is_katakana(char c) {
  return static_cast<unsigned char>(c) > 0xA0 && static_cast<unsigned char>(c) < 0xE0;
}

// Half-width katakana (ISO IR 13) have 8 bits, which iconv's Japanese character set lacks.
bool add_japanese(ToUtf8& converter, std::string_view text, std::string& to) {
  while (!text.empty()) {
    if (is_katakana(text[0])) {
      const unsigned code = 0xFF61U + static_cast<unsigned char>(text[0]) - 0xA1U;
      to += {'\xEF', static_cast<char>(0x80U | (code >> 6U & 0x3FU)),
             static_cast<char>(0x80U | (code & 0x3FU))};
      text.remove_prefix(1);
      continue;
    }
    const auto end = std::find_if(text.begin(), text.end(), is_katakana);
    const auto length = static_cast<std::size_t>(end - text.begin());
    if (!converter.add(std::string(text.substr(0, length)), to)) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

std::string name_in(DcmItem& dataset, DcmItem& item, const DcmTagKey& key) {
  const std::string set = text_of(dataset, DCM_SpecificCharacterSet);
  std::string text = text_of(item, key);
  const auto has = [&](const char* name) { return set.find(name) != std::string::npos; };
  if (!has("ISO 2022")) return utf8(text);
  const bool is_korean = has("IR 149"), is_chinese = has("IR 58");
  ToUtf8 converter(is_korean ? "EUC-KR" : is_chinese ? "GB2312" : "ISO-2022-JP-2");
  // These escapes announce letters of 8 bits.
  for (const std::string_view announced : {"\x1b$)C", "\x1b$)A", "\x1b)I"})
    for (std::size_t at = 0; (at = text.find(announced)) != std::string::npos;)
      text.erase(at, announced.size());
  std::string name;
  const bool is_read =
      has("IR 13") ? add_japanese(converter, text, name) : converter.add(text, name);
  return is_read ? name : utf8(text);
}

std::optional<double> real_of(DcmElement* element, unsigned long index) {
  constexpr double max_magnitude = 1e9;  // in millimetres and values
  OFString text;                         // also of binary numbers, with all digits
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

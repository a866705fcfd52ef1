#include "attributes.hpp"

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

std::optional<double> decimal(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return finite_number(std::string(trimmed(text)));
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

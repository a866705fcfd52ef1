#include "attributes.hpp"

#include <algorithm>
#include <cmath>

#include "text/number_text.hpp"
#include "volumes/volume_format.hpp"

namespace discmc::command {

std::string text_of(DcmItem& item, const DcmTagKey& key) {
  OFString value;
  item.findAndGetOFStringArray(key, value);
  std::string found(value.c_str(), value.size());
  std::replace(found.begin(), found.end(), '\0', ' ');
  return std::string(trimmed(found));
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

std::optional<double> real_of(DcmItem& item, const DcmTagKey& key, unsigned long index) {
  constexpr double max_magnitude = 1e9;  // of millimetres and values
  DcmElement* element = nullptr;
  if (item.findAndGetElement(key, element).bad() || element == nullptr) return std::nullopt;
  OFString text;  // of binary numbers, too, with all their digits
  if (element->getOFString(text, index).bad()) return std::nullopt;
  const auto value = decimal(std::string(text.c_str()));
  if (!value || !(std::fabs(*value) <= max_magnitude)) return std::nullopt;
  return value;
}

DcmItem* first_item(DcmItem& item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  return item.findAndGetSequenceItem(sequence, found).good() ? found : nullptr;
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

DcmItem* Attributes::holder(const DcmTagKey& group, const DcmTagKey& key) const {
  for (DcmItem* functional : groups_) {
    DcmItem* const item = first_item(*functional, group);
    if (item != nullptr && item->tagExists(key)) return item;
  }
  return dataset_.tagExists(key) ? &dataset_ : nullptr;
}

std::string Attributes::text(const DcmTagKey& group, const DcmTagKey& key) const {
  DcmItem* const item = holder(group, key);
  return item == nullptr ? std::string() : text_of(*item, key);
}

std::optional<double> Attributes::real(const DcmTagKey& group, const DcmTagKey& key) const {
  DcmItem* const item = holder(group, key);
  return item == nullptr ? std::nullopt : real_of(*item, key);
}

}  // namespace discmc::command

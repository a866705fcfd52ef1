// The values of DICOM elements: of a frame, of all frames of a file, or of the file.
#pragma once

#include "toolkit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace discmc::command {

/// Returns an element, or nullptr.
DcmElement* element_of(DcmItem& item, const DcmTagKey& key);

/// Returns the first item of a sequence, or nullptr.
DcmItem* first_item(DcmItem& item, const DcmTagKey& sequence);

// These read the values of an element; nullptr has none.

/// Returns the text without the blanks around it, several values with \ between them.
std::string text_of(DcmElement* element);

/// Returns one of the numbers, stored as text or not. Nothing where it is none, or out of all
/// measure.
std::optional<double> real_of(DcmElement* element, unsigned long index = 0);

/// Returns this many numbers, if there are at least as many.
template <std::size_t count>
std::optional<std::array<double, count>> reals_of(DcmElement* element) {
  std::array<double, count> values{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = real_of(element, i);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

inline std::string text_of(DcmItem& item, const DcmTagKey& key) {
  return text_of(element_of(item, key));
}

/// Returns a name as UTF-8, also from the character sets of Asia that DCMTK does not convert.
/// dataset: that names its character set.
std::string name_in(DcmItem& dataset, DcmItem& item, const DcmTagKey& key);

inline std::optional<double> real_of(DcmItem& item, const DcmTagKey& key, unsigned long index = 0) {
  return real_of(element_of(item, key), index);
}

/// Returns a whole number of 16 bits.
std::optional<std::uint32_t> whole_of(DcmItem& item, const DcmTagKey& key);

/// The attributes of a frame of a file.
class Attributes {
 public:
  Attributes(DcmItem& dataset, std::uint32_t frame);

  /// Returns the element in a functional group of the frame, or of all frames, or in the file, in
  /// this order. Null if none has it.
  DcmElement* element(const DcmTagKey& group, const DcmTagKey& key) const;

  /// The same, but for the file.
  DcmElement* grouped_element(const DcmTagKey& group, const DcmTagKey& key) const;

 private:
  DcmItem& dataset_;
  std::vector<DcmItem*> groups_;
};

}  // namespace discmc::command

// Values of DICOM elements: of a frame, of all frames of a file, or of the file.
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

// These read the values of an element, or nothing from nullptr.

/// Returns the text without surrounding blanks, and with \ between several values.
std::string text_of(DcmElement* element);

/// Returns one of the numbers, stored as text or binary. Returns nothing for other text, and for
/// absurdly large numbers.
std::optional<double> real_of(DcmElement* element, unsigned long index = 0);

/// Returns this many numbers, if the element has as many or more.
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

/// Returns a name as UTF-8, including Asian character sets that DCMTK does not convert. dataset:
/// declares the character set.
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

  /// Returns the element from a functional group of the frame, else of all frames, else from the
  /// file. Null if none has it.
  DcmElement* element(const DcmTagKey& group, const DcmTagKey& key) const;

  /// Likewise returns the element from the functional groups only.
  DcmElement* grouped_element(const DcmTagKey& group, const DcmTagKey& key) const;

 private:
  DcmItem& dataset_;
  std::vector<DcmItem*> groups_;
};

}  // namespace discmc::command

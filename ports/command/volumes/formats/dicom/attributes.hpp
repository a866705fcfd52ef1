// The values of DICOM elements: of a frame, of all frames of a file, or of the file.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_ATTRIBUTES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_ATTRIBUTES_HPP

#include "toolkit.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace discmc::command {

/// Returns the text of an element without the blanks around it, several values with \ between them.
std::string text_of(DcmItem& item, const DcmTagKey& key);

/// Returns a whole number of 16 bits.
std::optional<std::uint32_t> whole_of(DcmItem& item, const DcmTagKey& key);

/// Returns the number of a decimal text, in which a comma stands for the point.
std::optional<double> decimal(std::string text);

/// Returns one of the numbers of an element, text or not. Nothing where it is missing, no number,
/// or out of all measure.
std::optional<double> real_of(DcmItem& item, const DcmTagKey& key, unsigned long index = 0);

/// Returns as many numbers of an element, if it has so many at least.
template <std::size_t count>
std::optional<std::array<double, count>> reals_of(DcmItem& item, const DcmTagKey& key) {
  std::array<double, count> values{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto value = real_of(item, key, i);
    if (!value) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

/// The first item of a sequence, or none.
DcmItem* first_item(DcmItem& item, const DcmTagKey& sequence);

/// What a file tells of one of its frames.
class Attributes {
 public:
  Attributes(DcmItem& dataset, std::uint32_t frame);

  /// The item that holds an element: in the functional group of the frame, in that of all frames,
  /// or the file, in this order; none where no one does.
  DcmItem* holder(const DcmTagKey& group, const DcmTagKey& key) const;

  std::string text(const DcmTagKey& group, const DcmTagKey& key) const;
  std::optional<double> real(const DcmTagKey& group, const DcmTagKey& key) const;

  template <std::size_t count>
  std::optional<std::array<double, count>> reals(const DcmTagKey& group,
                                                 const DcmTagKey& key) const {
    DcmItem* const item = holder(group, key);
    return item == nullptr ? std::nullopt : reals_of<count>(*item, key);
  }

 private:
  DcmItem& dataset_;
  std::vector<DcmItem*> groups_;
};

}  // namespace discmc::command

#endif

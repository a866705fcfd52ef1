// Which labels of a segmentation are meant by numbers and names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "label_description.hpp"
#include "pictures/srgb.hpp"
#include "volumes/filters/filters.hpp"

namespace discmc::command {

/// Labels that are one surface, and what they are called.
struct NamedLabels {
  LabelSet set;
  std::string name;
  std::optional<Srgb> colour;
};

/// The labels of some layers of a segmentation.
class LabelNames {
 public:
  /// table: of all layers. layers: the numbers of those that are read; not none.
  LabelNames(LabelTable table, std::vector<std::uint32_t> layers);

  const std::vector<std::uint32_t>& layers() const { return layers_; }

  /// The labels of a list such as "5,right lung": names may hold commas, too. A name is that in the
  /// table, or else the only one that differs from it in case and underscores alone. Throws
  /// std::invalid_argument where a label is not known or several are meant.
  std::vector<NamedLabels> each(const std::string& list) const;

  /// All of the list as one surface. It has the name and the colour of its label, or the list as
  /// its name where there are several.
  NamedLabels together(const std::string& list) const;

  /// The regions of the table: those of several labels.
  std::vector<NamedLabels> regions() const;

  /// What a label is called, and its colour. A value that several labels have, or none, is called
  /// by its number.
  NamedLabels named(std::uint32_t layer, LabelValue value) const;

 private:
  std::optional<NamedLabels> by_number(std::string_view text) const;
  std::optional<NamedLabels> by_name(std::string_view text) const;
  std::string list_of_names() const;

  LabelTable table_;
  std::vector<std::uint32_t> layers_;
  // Places in the table: of masks, by their layers, and of labels with one value.
  std::map<std::uint32_t, std::vector<std::size_t>> masks_;
  std::map<LabelValue, std::vector<std::size_t>> of_value_;
  std::size_t longest_name_ = 0;
};

}  // namespace discmc::command

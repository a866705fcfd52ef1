// Finds labels of a segmentation by numbers and names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "label_table.hpp"
#include "pictures/srgb.hpp"
#include "volumes/filters/filters.hpp"

namespace discmc::command {

/// Labels that form one surface, and their common name.
struct NamedLabels {
  LabelSet set;
  std::string name;
  std::optional<Srgb> colour;
};

/// The labels of some layers of a segmentation.
class LabelNames {
 public:
  /// table: of all layers. layers: the numbers of those that are read; not empty.
  LabelNames(LabelTable table, std::vector<std::uint32_t> layers);

  const std::vector<std::uint32_t>& layers() const { return layers_; }

  /// Returns the labels of a list such as "5,right lung"; names may contain commas. A name is equal
  /// to one in the table, or differs from only one there by case and underscores. Throws
  /// std::invalid_argument if a label is unknown or ambiguous.
  std::vector<NamedLabels> each(const std::string& list) const;

  /// Returns all labels of the list as one surface. It has the name and the colour of a single
  /// label, or the list as its name.
  NamedLabels together(const std::string& list) const;

  /// Returns the regions of the table, which have several labels.
  std::vector<NamedLabels> regions() const;

  /// Returns the name and colour of a label. If several labels have its value, or none, its number
  /// is its name.
  NamedLabels named(std::uint32_t layer, LabelValue value) const;

 private:
  std::optional<NamedLabels> by_number(std::string_view text) const;
  std::optional<NamedLabels> by_name(std::string_view text) const;
  std::string list_of_names() const;

  LabelTable table_;
  std::vector<std::uint32_t> layers_;
  // Indexes in the table: of masks, by layer, and of labels with one value.
  std::map<std::uint32_t, std::vector<std::size_t>> masks_;
  std::map<LabelValue, std::vector<std::size_t>> of_value_;
  std::size_t longest_name_ = 0;
};

}  // namespace discmc::command

// A segmentation as a command takes it: its layers, and which of its labels are meant.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "volumes/label_names.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Labels that overlap are in several layers, each a volume of the file. All layers are read unless
/// --frame chooses one.
class Segmentation {
 public:
  /// Opens the first layer. Throws where the file holds several volumes that are no layers, and
  /// none is chosen.
  Segmentation(const std::string& path, const VolumeArguments& arguments);

  /// The description of the first layer; the others have the same extents.
  const VolumeInfo& info() const { return info_; }
  const LabelNames& names() const { return names_; }

  /// Opens a layer: the first one once without opening the file again.
  std::unique_ptr<VolumeReader> open(std::uint32_t layer);

 private:
  std::string path_;
  VolumeOptions options_;
  std::unique_ptr<VolumeReader> first_;  // until it is asked for
  VolumeInfo info_;
  LabelNames names_;
};

/// Finds the labels that are selected, and names them. Returns their bits, in the order of the
/// selections. Throws std::invalid_argument where they are not found.
std::unique_ptr<VolumeReader> open_labels(Segmentation& segmentation, const std::string& path,
                                          std::vector<NamedSelection>& selections);

}  // namespace discmc::command

// A segmentation: its layers, and the requested labels.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "volumes/label_names.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// The layers of a segmentation. Labels that overlap are in several layers, each of which is a
/// volume of the file. All layers are read unless --frame chooses one.
class Segmentation {
 public:
  /// Opens the first layer. Throws if the file holds several volumes that are not layers, and the
  /// user has chosen none.
  Segmentation(const std::string& path, const VolumeArguments& arguments);

  /// The description of the first layer; the others have the same extents.
  const VolumeInfo& info() const { return info_; }
  const LabelNames& names() const { return names_; }

  /// Opens a layer. The first call for layer 0 reuses the file that is already open.
  std::unique_ptr<VolumeReader> open(std::uint32_t layer);

 private:
  std::string path_;
  VolumeOptions options_;
  std::unique_ptr<VolumeReader> first_;  // until the first open(0)
  VolumeInfo info_;
  LabelNames names_;
};

/// Finds and names the selected labels. Returns their bits, in the order of the selections. Throws
/// std::invalid_argument if labels are missing.
std::unique_ptr<VolumeReader> open_labels(Segmentation& segmentation, const std::string& path,
                                          std::vector<NamedSelection>& selections);

}  // namespace discmc::command

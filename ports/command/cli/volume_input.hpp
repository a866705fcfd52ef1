// The volume of a command: opened as its arguments require, and how its surface is extracted.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "extraction/extraction.hpp"
#include "extraction/selection.hpp"
#include "meshing.hpp"
#include "progress.hpp"
#include "smoothing/closed_volume.hpp"
#include "smoothing/smoothed_volume.hpp"
#include "statistics/measured_volume.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {

/// Throws when the file can be read once only. purpose: what takes the pass.
void require_second_pass(const std::string& path, const std::string& purpose);

constexpr const char* gradient_pass = "normals of the gradient read the volume twice";

/// The volume, whose notes are printed: each once, however often it is opened. All commands open
/// volumes by this or the next ones, but info, which has notes in its table.
std::unique_ptr<VolumeReader> noted(const std::string& path, std::unique_ptr<VolumeReader> volume);
std::unique_ptr<VolumeReader> open_noted(const std::string& path, const VolumeOptions& options);

/// Opens a volume; of labels in several layers the first one, where none is chosen.
std::unique_ptr<VolumeReader> open_layer(const std::string& path, const VolumeOptions& options);

/// As open_noted(), measured as it is read. If labels are selected, returns the volume of their
/// bits, and completes the selections.
std::unique_ptr<MeasuredVolume> open_measured(const std::string& path, VolumeArguments& arguments);

/// Opens the mask of the volume, if there is one, and prints what is unusual about it.
std::unique_ptr<VolumeReader> open_noted_mask(const VolumeArguments& arguments,
                                              const VolumeInfo& volume);

/// A volume that gradients can be made of, and what is on in it.
struct GradientVolume {
  VolumeInfo info;  ///< of the file
  std::unique_ptr<SliceReader> reader;
  Selection selection;
};

/// The volume from its first slice on, narrowed for gradients. volume: not yet read; is read to its
/// end, and so measured.
std::unique_ptr<SliceReader> narrowed_again(const std::string& path, const VolumeOptions& options,
                                            double iso, VolumeReader& volume);

/// The volume once more, in samples that the library takes (is_scanner_type()): itself, or else
/// narrowed, which takes a pass over it. Throws as require_second_pass().
GradientVolume open_for_gradient(const std::string& path, const VolumeOptions& options, double iso);

/// The deviation of --smooth, if it is given. Units: millimetres.
std::optional<double> smoothing_mm(const VolumeArguments& arguments, const VolumeInfo& volume);

/// The selected voxels closed and smoothed, as far as that is asked for.
class MendedVolume {
 public:
  /// volume: as SmoothedVolume. options: of the volume; become those of what is extracted: its
  /// threshold, without the mask, which has cut it.
  MendedVolume(const VolumeArguments& arguments, VolumeReader& volume, ExtractionOptions& options);

  /// What is extracted: the volume itself where nothing is asked for.
  SliceReader& samples() const;
  bool is_changed() const { return closed_ || smooth_; }
  /// Limit: is_changed().
  std::uint64_t not_numbers() const;
  /// The description of --smooth, if it is given.
  const std::optional<double>& deviation_mm() const { return deviation_mm_; }

 private:
  VolumeReader& volume_;
  std::unique_ptr<ClosedVolume> closed_;
  std::unique_ptr<SmoothedVolume> smooth_;
  std::optional<double> deviation_mm_;
};

/// At the first threshold. progress, mask: have to live as long as the options are in use.
ExtractionOptions extraction_options(const VolumeArguments& arguments, Progress& progress,
                                     VolumeReader* mask = nullptr);

/// The surfaces that are asked for of the volume, each with its threshold. What a rule finds is
/// printed. A rule needs a pass over the volume, unless the file states Hounsfield units and the
/// rule needs no more. Throws where a rule does not fit the values, and as require_second_pass().
std::vector<NamedSelection> with_thresholds(const std::string& path,
                                            const VolumeArguments& arguments);

}  // namespace discmc::command

// The volume of a command: opens it by the arguments, and prepares the extraction.
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

/// Throws if the file can be read only once. purpose: what needs the second pass.
void require_second_pass(const std::string& path, const std::string& purpose);

constexpr const char* gradient_pass = "normals of the gradient read the volume twice";

/// Returns a volume that prints each of its notes once, however often it is opened. All commands
/// open volumes by this function or the next ones, except info, whose table has the notes.
std::unique_ptr<VolumeReader> noted(const std::string& path, std::unique_ptr<VolumeReader> volume);
std::unique_ptr<VolumeReader> open_noted(const std::string& path, const VolumeOptions& options);

/// Opens a volume. If labels are in several layers and none is chosen, opens the first.
std::unique_ptr<VolumeReader> open_layer(const std::string& path, const VolumeOptions& options);

/// Likewise opens a volume that is measured as it is read. If labels are selected, returns the
/// volume of their bits, and completes the selections.
std::unique_ptr<MeasuredVolume> open_measured(const std::string& path, VolumeArguments& arguments);

/// Opens the mask of the volume, if there is one, and prints its notes.
std::unique_ptr<VolumeReader> open_noted_mask(const VolumeArguments& arguments,
                                              const VolumeInfo& volume);

/// A volume from which gradients can be computed, and its selection.
struct GradientVolume {
  VolumeInfo info;  ///< of the file
  std::unique_ptr<SliceReader> reader;
  Selection selection;
};

/// Returns the volume from its first slice on, narrowed for gradients. volume: not yet read; this
/// function reads and measures all of it.
std::unique_ptr<SliceReader> narrowed_again(const std::string& path, const VolumeOptions& options,
                                            double iso, VolumeReader& volume);

/// Opens the volume again with samples of a type that the library supports (is_scanner_type()).
/// Other types are narrowed, which needs a pass. Throws like require_second_pass().
GradientVolume open_for_gradient(const std::string& path, const VolumeOptions& options, double iso);

/// Returns the deviation of --smooth, if given. Units: millimetres.
std::optional<double> smoothing_mm(const VolumeArguments& arguments, const VolumeInfo& volume);

/// The selected voxels, closed and smoothed as requested.
class MendedVolume {
 public:
  /// volume: as SmoothedVolume. options: of the volume; become the options of the result: its
  /// threshold, and no mask, which is already applied.
  MendedVolume(const VolumeArguments& arguments, VolumeReader& volume, ExtractionOptions& options);

  /// Returns the samples to extract: the volume itself if nothing is requested.
  SliceReader& samples() const;
  bool is_changed() const { return closed_ || smooth_; }
  /// Limit: is_changed().
  std::uint64_t not_numbers() const;
  /// Returns the deviation of --smooth, if given.
  const std::optional<double>& deviation_mm() const { return deviation_mm_; }

 private:
  VolumeReader& volume_;
  std::unique_ptr<ClosedVolume> closed_;
  std::unique_ptr<SmoothedVolume> smooth_;
  std::optional<double> deviation_mm_;
};

/// Returns the options for the first threshold. progress, mask: must outlive the options.
ExtractionOptions extraction_options(const VolumeArguments& arguments, Progress& progress,
                                     VolumeReader* mask = nullptr);

/// Returns the requested surfaces, each with its threshold. Prints each threshold that a rule
/// finds. A rule needs a pass over the volume, unless the file states Hounsfield units and the rule
/// needs only these. Throws if a rule does not fit the values, or like require_second_pass().
std::vector<NamedSelection> with_thresholds(const std::string& path,
                                            const VolumeArguments& arguments);

}  // namespace discmc::command

#include "volume_input.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <utility>

#include "extraction/narrowed_volume.hpp"
#include "segmentation.hpp"
#include "text/message.hpp"
#include "text/number_text.hpp"
#include "volumes/byte_source.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/volume_info.hpp"
#include "volumes/volume_offset.hpp"

namespace discmc::command {
namespace {

void require_reach(double close_mm, const VolumeInfo& info) {
  const auto distances = info.distances_mm();
  const double finest = *std::min_element(distances.begin(), distances.end());
  const double max_mm = VoxelBall::max_reach * finest;
  if (close_mm > max_mm)
    throw std::invalid_argument("--close " + value_text(close_mm) + ": that is more than " +
                                value_text(VoxelBall::max_reach) + " voxels of " +
                                value_text(finest) + " mm; give at most " + value_text(max_mm) +
                                ", or use --shrink");
}

// Prints each note once, even if a volume is opened for several passes.
void print_once(const std::string& path, const std::string& text) {
  static std::set<std::pair<std::string, std::string>> printed;
  if (printed.emplace(path, text).second) print_message(path, text);
}

// Prints the notes of a volume when it is opened, and further notes after its last slice.
class NotedVolume final : public VolumeFilter {
 public:
  NotedVolume(std::string path, std::unique_ptr<VolumeReader> volume)
      : VolumeFilter(std::move(volume)), path_(std::move(path)) {
    print_notes();
  }

  void read_slice(void* samples) override {
    VolumeFilter::read_slice(samples);
    if (++read_ == info().dims[2]) print_notes();
  }

  void skip_slice() override {
    VolumeFilter::skip_slice();
    if (++read_ == info().dims[2]) print_notes();
  }

 private:
  void print_notes() const {
    for (const std::string& note : notes()) print_once(path_, note);
  }

  std::string path_;
  std::uint32_t read_ = 0;  // number of slices read
};

}  // namespace

void require_second_pass(const std::string& path, const std::string& purpose) {
  if (is_read_once(path))
    throw std::runtime_error(display_name(path) + ": " + purpose +
                             ", but this input can be read only once; store it in a file");
}

std::unique_ptr<VolumeReader> noted(const std::string& path, std::unique_ptr<VolumeReader> volume) {
  return std::make_unique<NotedVolume>(path, std::move(volume));
}

std::unique_ptr<VolumeReader> open_noted(const std::string& path, const VolumeOptions& options) {
  return noted(path, open_volume(path, options));
}

std::unique_ptr<VolumeReader> open_layer(const std::string& path, const VolumeOptions& options) {
  VolumeOptions first_frame = options;
  if (!options.frame) first_frame.frame = 0;
  auto volume = open_volume(path, first_frame);
  const VolumeInfo& info = volume->info();
  if (options.frame || info.frames == 1 || !info.labels.empty()) return volume;
  // The reader may list the choices.
  if (!is_read_once(path)) open_volume(path, options);
  fail_frames(path, info, options);
}

std::unique_ptr<MeasuredVolume> open_measured(const std::string& path, VolumeArguments& arguments) {
  if (arguments.selects_labels()) {
    Segmentation segmentation(path, arguments);
    return std::make_unique<MeasuredVolume>(open_labels(segmentation, path, arguments.selections));
  }
  return std::make_unique<MeasuredVolume>(open_noted(path, arguments.options));
}

std::unique_ptr<VolumeReader> open_noted_mask(const VolumeArguments& arguments,
                                              const VolumeInfo& volume) {
  if (arguments.mask.empty()) return nullptr;
  auto mask = noted(arguments.mask, open_mask(arguments.mask, arguments.options, volume));
  const double apart = offset_mm(mask->info(), volume);
  if (apart > 0)
    print_message(arguments.mask, "the mask lies up to " + short_number(apart) +
                                      " mm away from the volume; its voxels apply by index");
  return mask;
}

std::unique_ptr<SliceReader> narrowed_again(const std::string& path, const VolumeOptions& options,
                                            double iso, VolumeReader& volume) {
  require_second_pass(path, gradient_pass);
  const SampleBounds bounds = sample_bounds(volume);
  return narrowed(open_noted(path, options), bounds, iso);
}

GradientVolume open_for_gradient(const std::string& path, const VolumeOptions& options,
                                 double iso) {
  require_second_pass(path, gradient_pass);
  auto volume = open_noted(path, options);
  const VolumeInfo info = volume->info();
  if (is_scanner_type(info.type)) return {info, std::move(volume), {iso}};
  return {info, narrowed_again(path, options, iso, *volume), {0}};
}

std::optional<double> smoothing_mm(const VolumeArguments& arguments, const VolumeInfo& volume) {
  if (!arguments.smooth_mm || *arguments.smooth_mm > 0) return arguments.smooth_mm;
  return steps_mm(volume);
}

MendedVolume::MendedVolume(const VolumeArguments& arguments, VolumeReader& volume,
                           ExtractionOptions& options)
    : volume_(volume) {
  const auto selected = [&options](double low) {
    return std::pair(std::exchange(options.selection, Selection{low}),
                     std::exchange(options.mask, nullptr));
  };
  if (arguments.close_mm > 0) {
    require_reach(arguments.close_mm, volume.info());
    const auto [selection, mask] = selected(1);
    closed_ = std::make_unique<ClosedVolume>(volume, selection, mask, arguments.close_mm);
  }
  if (const auto deviation = smoothing_mm(arguments, volume.info())) {
    const auto [selection, mask] = selected(0);
    deviation_mm_ = deviation;
    smooth_ = std::make_unique<SmoothedVolume>(samples(), selection, mask, *deviation);
  }
}

SliceReader& MendedVolume::samples() const {
  if (smooth_) return *smooth_;
  return closed_ ? static_cast<SliceReader&>(*closed_) : volume_;
}

std::uint64_t MendedVolume::not_numbers() const {
  return closed_ ? closed_->not_numbers() : smooth_->not_numbers();
}

ExtractionOptions extraction_options(const VolumeArguments& arguments, Progress& progress,
                                     VolumeReader* mask) {
  ExtractionOptions options;
  options.selection = arguments.selections[0].selection;
  options.border = arguments.border;
  options.filters_by_majority = arguments.median > 0;
  options.memory = arguments.memory;
  if (!arguments.capacities.empty())
    options.capacities = Capacities{arguments.capacities[0], arguments.capacities[1]};
  options.mask = mask;
  options.progress = [&progress](std::uint32_t slices) { progress.show(slices); };
  return options;
}

}  // namespace discmc::command

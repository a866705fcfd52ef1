#include "smoothed_labels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "extraction/moved_surface.hpp"
#include "extraction/surfaces.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "smoothed_volume.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::meshing {
namespace {

using Voxel = std::array<std::uint32_t, 3>;

// The voxels of a label, from `first` to before `end`.
struct LabelBox {
  Voxel first{~0U, ~0U, ~0U}, end{};
  std::uint64_t voxels = 0;

  void add(const Voxel& begin, std::uint32_t end_x) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      first[axis] = std::min(first[axis], begin[axis]);
      end[axis] = std::max(end[axis], axis == 0 ? end_x : begin[axis] + 1);
    }
    voxels += end_x - begin[0];
  }
};

// Widens the box until the surface of the label cannot reach its faces.
LabelBox widened(const LabelBox& box, const Voxel& dims, const Voxel& margin) {
  LabelBox wide = box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    wide.first[axis] -= std::min(box.first[axis], margin[axis]);
    wide.end[axis] += std::min(dims[axis] - box.end[axis], margin[axis]);
  }
  return wide;
}

// Returns 1 for the voxels of a label in a box, otherwise 0.
template <class Sample>
class LabelMask final : public SliceReader {
 public:
  LabelMask(const SampleGrid& whole, const std::vector<Sample>& samples, Sample label,
            const LabelBox& box)
      : whole_dims_(whole.dims), samples_(samples), label_(label), box_(box) {
    for (std::size_t axis = 0; axis < 3; ++axis) info_.dims[axis] = box.end[axis] - box.first[axis];
    info_.spacing_mm = whole.spacing_mm;
  }

  const SampleGrid& info() const override { return info_; }
  void read_slice(void* samples) override {
    auto* mask = static_cast<std::uint8_t*>(samples);
    const std::size_t z = box_.first[2] + slice_++;
    for (std::uint32_t y = box_.first[1]; y < box_.end[1]; ++y) {
      const Sample* row = samples_.data() + (z * whole_dims_[1] + y) * whole_dims_[0];
      mask = std::transform(row + box_.first[0], row + box_.end[0], mask,
                            [this](Sample sample) { return sample == label_ ? 1 : 0; });
    }
  }

 private:
  Voxel whole_dims_;
  const std::vector<Sample>& samples_;
  Sample label_;
  LabelBox box_;
  SampleGrid info_;
  std::uint32_t slice_ = 0;
};

template <class Sample>
class LabelSmoother {
 public:
  LabelSmoother(SliceReader& volume, const LabelOptions& options, double deviation_mm,
                double tolerance)
      : info_(volume.info()),
        options_(options),
        deviation_mm_(deviation_mm),
        tolerance_(tolerance) {
    const std::size_t slice = std::size_t{info_.dims[0]} * info_.dims[1];
    samples_.resize(slice * info_.dims[2]);
    for (std::uint32_t z = 0; z < info_.dims[2]; ++z) {
      volume.read_slice(samples_.data() + z * slice);
      find_boxes(z);
      if (options.progress) options.progress(z + 1);
    }
  }

  std::vector<SmoothedLabel> smoothed(
      const std::function<void(std::size_t, std::size_t)>& progress) const {
    const std::vector<std::pair<Sample, LabelBox>> boxes(boxes_.begin(), boxes_.end());
    std::vector<SmoothedLabel> labels;
    run_in_order<std::optional<SmoothedLabel>>(
        options_.jobs, boxes.size(), [](std::size_t, auto&) {},
        [&](std::size_t number, auto& label) {
          label = smoothed(boxes[number].first, boxes[number].second);
        },
        [&](std::size_t, auto& label) {
          labels.push_back(std::move(*label));
          if (progress) progress(labels.size(), boxes.size());
        });
    keep_all_volumes(labels);
    labels.erase(std::remove_if(labels.begin(), labels.end(),
                                [this](const SmoothedLabel& label) {
                                  return options_.chosen &&
                                         options_.chosen->count(label.surface.label) == 0;
                                }),
                 labels.end());
    return labels;
  }

 private:
  void find_boxes(std::uint32_t z) {
    for (std::uint32_t y = 0; y < info_.dims[1]; ++y) {
      const Sample* row = samples_.data() + (std::size_t{z} * info_.dims[1] + y) * info_.dims[0];
      for (std::uint32_t x = 0, end = 0; x < info_.dims[0]; x = end) {
        for (end = x + 1; end < info_.dims[0] && row[end] == row[x];) ++end;
        if (row[x] == 0) continue;
        boxes_[row[x]].add({x, y, z}, end);
        scatter_.add(end - x);
      }
    }
    if (boxes_.size() > max_labels) refuse_values(z, max_labels);
    if (boxes_.size() > max_scattered_labels) scatter_.require_labels(z, labels_near(z));
  }

  // Returns the number of values in a slice and the two before it.
  std::size_t labels_near(std::uint32_t z) const {
    return static_cast<std::size_t>(
        std::count_if(boxes_.begin(), boxes_.end(),
                      [z](const auto& each) { return each.second.end[2] + 2 > z; }));
  }

  SmoothedLabel smoothed(Sample label, const LabelBox& box) const {
    const LabelBox wide = widened(box, info_.dims, SmoothedVolume::reach(info_, deviation_mm_));
    LabelMask<Sample> mask(info_, samples_, label, wide);
    SmoothedVolume smooth(mask, {1}, nullptr, deviation_mm_);
    JoinedSurface joined;
    MovedSurface moved(joined, wide.first);
    CrossingFinder crossings(smooth.info(), {0}, moved.offset(), true);
    SurfaceRequest request{{0}, make_sink(moved), &crossings};
    request.regions = make_region_receiver(moved);
    SurfaceOptions options;
    options.border = options_.border;
    extract_surfaces(smooth, options, {request});
    joined.surface().spacing_mm = info_.spacing_mm;
    return {{label, box.voxels, std::move(joined.surface())}, std::move(crossings)};
  }

  // Smooths unchosen labels, too, because they share walls with chosen ones.
  void keep_all_volumes(std::vector<SmoothedLabel>& labels) const {
    std::map<Sample, std::size_t> indexes;
    for (const auto& each : boxes_) indexes.emplace(each.first, indexes.size());
    VolumeKeeping keeping =
        SmoothedVolume::keeping(info_, deviation_mm_, tolerance_, options_.border);
    keeping.jobs = options_.jobs;
    keeping.surface_of = [&](const Vertex& voxel) {
      const auto at = [](std::int32_t half_steps) {
        return static_cast<std::size_t>(half_steps / 2);
      };
      const Sample sample =
          samples_[(at(voxel.z) * info_.dims[1] + at(voxel.y)) * info_.dims[0] + at(voxel.x)];
      const auto found = indexes.find(sample);
      return found == indexes.end() ? VolumeKeeping::none : found->second;
    };
    std::vector<SmoothSurface> surfaces;
    for (SmoothedLabel& each : labels)
      surfaces.push_back({&each.surface.surface, &each.crossings.crossings()});
    keep_volumes(surfaces, keeping);
  }

  const SampleGrid& info_;
  const LabelOptions& options_;
  double deviation_mm_, tolerance_;
  std::vector<Sample> samples_;
  std::map<Sample, LabelBox> boxes_;
  ValueScatter scatter_;
};

}  // namespace

std::vector<SmoothedLabel> smoothed_labels(
    SliceReader& volume, const LabelOptions& options, double deviation_mm, double tolerance,
    const std::function<void(std::size_t done, std::size_t total)>& progress) {
  std::vector<SmoothedLabel> labels;
  with_whole_type(volume.info().type, [&](auto type) {
    labels =
        LabelSmoother<decltype(type)>(volume, options, deviation_mm, tolerance).smoothed(progress);
  });
  return labels;
}

}  // namespace discmc::meshing

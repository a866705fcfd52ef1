#include "labels.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>

#include "label_run.hpp"
#include "surface/joined_surface.hpp"

namespace discmc::meshing {
namespace {

struct Label {
  LabelValue value;
  std::uint64_t voxels = 0;
  Polygons polygons{};
  std::optional<LabelRun> run{};  // empty in slices far from its voxels
};

// The labels of a volume by their samples.
template <class Sample>
class LabelScan {
 public:
  LabelScan(const SampleGrid& info, const LabelOptions& options)
      : info_(info), options_(options), limits_{info.dims[0], info.dims[1], options.border} {}

  void add_slice(const Sample* row) {
    for (std::uint32_t y = 0; y < limits_.height; ++y, row += limits_.width) add_row(row, y);
    const auto is_over = [this](Label* label) { return end_slice(*label); };
    running_.erase(std::remove_if(running_.begin(), running_.end(), is_over), running_.end());
    ++slice_;
  }

  std::vector<LabelledSurface> finish() {
    std::vector<LabelledSurface> surfaces;
    for (const std::unique_ptr<Label>& label : labels_) {
      if (label->run) end_run(*label);
      surfaces.push_back(
          {label->value, label->voxels, {info_.spacing_mm, std::move(label->polygons)}});
    }
    std::sort(surfaces.begin(), surfaces.end(),
              [](const auto& a, const auto& b) { return a.label < b.label; });
    return surfaces;
  }

 private:
  void add_row(const Sample* row, std::uint32_t y) {
    for (std::uint32_t x = 0, end = 0; x < limits_.width; x = end) {
      const Sample sample = row[x];
      for (end = x + 1; end < limits_.width && row[end] == sample;) ++end;
      if (Label* const label = label_of(sample)) add_voxels(*label, y, x, end);
    }
  }

  void add_voxels(Label& label, std::uint32_t y, std::uint32_t begin, std::uint32_t end) {
    if (!label.run) {
      running_.push_back(&label);
      scatter_.require_labels(slice_, running_.size());
      label.run.emplace(slice_);
    }
    label.run->add(y, begin, end);
    label.voxels += end - begin;
    scatter_.add(end - begin);
  }

  // Returns whether the run of the label is over.
  bool end_slice(Label& label) {
    label.run->end_slice();
    if (!label.run->is_over()) return false;
    end_run(label);
    return true;
  }

  void end_run(Label& label) {
    JoinedSurface surface;
    label.run->extract(limits_, options_.filters_by_majority, scan_, surface);
    label.run.reset();
    Polygons& polygons = surface.surface().polygons;
    if (label.polygons.empty()) {
      label.polygons = std::move(polygons);
    } else {
      label.polygons.append(polygons);
      label.polygons.sort();
    }
  }

  // Returns null if the voxel belongs to no surface.
  Label* label_of(Sample sample) {
    if (has_last_ && sample == last_sample_) return last_label_;
    has_last_ = true;
    last_sample_ = sample;
    return last_label_ = options_.selects(sample) ? added_label(sample) : nullptr;
  }

  Label* added_label(Sample sample) {
    Label*& label = by_sample_[sample];
    if (label != nullptr) return label;
    if (labels_.size() == max_labels) refuse_values(slice_, max_labels);
    labels_.push_back(std::make_unique<Label>(Label{sample}));
    return label = labels_.back().get();
  }

  const SampleGrid& info_;
  const LabelOptions& options_;
  Limits limits_;
  std::uint32_t slice_ = 0;  // current slice
  std::vector<Label*> running_;
  ValueScatter scatter_;
  HostScan scan_;
  std::vector<std::unique_ptr<Label>> labels_;
  std::unordered_map<Sample, Label*> by_sample_;
  // Neighbours mostly have one label.
  bool has_last_ = false;
  Sample last_sample_{};
  Label* last_label_ = nullptr;
};

}  // namespace

void refuse_values(std::uint32_t slice, std::uint32_t max_values) {
  throw std::invalid_argument("more than " + std::to_string(max_values) + " values up to slice " +
                              std::to_string(slice) +
                              ": the values are samples, not labels; give a threshold or a range");
}

std::vector<LabelledSurface> extract_labels(SliceReader& volume, const LabelOptions& options) {
  const SampleGrid& info = volume.info();
  std::vector<LabelledSurface> surfaces;
  with_whole_type(info.type, [&](auto type) {
    using Sample = decltype(type);
    LabelScan<Sample> scan(info, options);
    std::vector<std::uint8_t> slice(info.slice_bytes());
    for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
      volume.read_slice(slice.data());
      scan.add_slice(reinterpret_cast<const Sample*>(slice.data()));
      if (options.progress) options.progress(z + 1);
    }
    surfaces = scan.finish();
  });
  return surfaces;
}

}  // namespace discmc::meshing

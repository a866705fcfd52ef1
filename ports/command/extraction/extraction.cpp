#include "extraction.hpp"

#include <discmc/surface_group.hpp>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "require.hpp"
#include "streams/stream_file.hpp"

namespace discmc::host {
namespace {

constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;

// Counts the lattice edges between an on and an off voxel: classic Marching Cubes puts a vertex on
// each of them.
class CrossingCounter {
 public:
  CrossingCounter(const Limits& limits, std::int32_t threshold)
      : width_(limits.width),
        closed_(limits.border == Border::closed),
        threshold_(threshold),
        below_(std::size_t{limits.width} * limits.height, 0) {}

  template <class Sample>
  void add_slice(const Sample* samples) {
    const bool has_below = closed_ || slices_ > 0;
    std::vector<std::uint8_t> on(below_.size());
    for (std::size_t i = 0; i < on.size(); ++i) {
      on[i] = samples[i] >= threshold_ ? 1 : 0;
      const std::size_t x = i % width_;
      if (x > 0) add(on[i] != on[i - 1]);
      if (i >= width_) add(on[i] != on[i - width_]);
      if (has_below) add(on[i] != below_[i]);
      if (!closed_ || on[i] == 0) continue;
      add(x == 0);
      add(x + 1 == width_);
      add(i < width_);
      add(i + width_ >= on.size());
    }
    below_ = std::move(on);
    ++slices_;
  }

  std::uint64_t count() const {
    const auto above = closed_ ? std::count(below_.begin(), below_.end(), 1) : 0;
    return count_ + static_cast<std::uint64_t>(above);
  }

 private:
  void add(bool crosses) { count_ += crosses ? 1U : 0U; }

  std::size_t width_;
  bool closed_;
  std::int32_t threshold_;
  std::vector<std::uint8_t> below_;
  std::uint32_t slices_ = 0;
  std::uint64_t count_ = 0;
};

struct Arena {
  bool has_narrow_indices;
  std::uint64_t bytes;
  Capacities capacities;
};

template <class Normals>
Arena arena_with(const Limits& limits, const Capacities& capacities) {
  if (is_valid<std::uint16_t>(capacities))
    return {true, bytes_for<std::uint16_t, Normals>(limits, capacities), capacities};
  if (is_valid<std::uint32_t>(capacities))
    return {false, bytes_for<std::uint32_t, Normals>(limits, capacities), capacities};
  throw std::invalid_argument("--capacities " + std::to_string(capacities.records) + "," +
                              std::to_string(capacities.holes) + ": give at least " +
                              std::to_string(minimum_capacities().records) +
                              " records, and fewer than 2^31 - 8");
}

template <class Normals>
Arena arena_of(const Limits& limits, std::uint64_t bytes) {
  const std::uint64_t least = minimum_bytes<std::uint16_t, Normals>(limits);
  if (bytes < least)
    throw std::invalid_argument("--memory " + std::to_string(bytes) +
                                " is too little for slices of " + std::to_string(limits.width) +
                                "x" + std::to_string(limits.height) + ": give at least " +
                                std::to_string(least) + " bytes");
  if (takes_narrow_indices<Normals>(limits, bytes))
    return {true, bytes, default_capacities<std::uint16_t, Normals>(limits, bytes)};
  return {false, bytes, default_capacities<std::uint32_t, Normals>(limits, bytes)};
}

// What is asked for, or a generous one. Throws where an extractor would refuse.
template <class Normals>
Arena arena_for(const Limits& limits, std::uint32_t slices, const ExtractionOptions& options) {
  if (options.capacities) return arena_with<Normals>(limits, *options.capacities);
  // More than the worst case needs is never touched.
  const std::uint64_t most = worst_case_bytes<std::uint32_t, Normals>(limits, slices);
  const std::uint64_t generous =
      std::max(generous_bytes, 2 * minimum_bytes<std::uint32_t, Normals>(limits));
  return arena_of<Normals>(limits, std::min(options.memory > 0 ? options.memory : generous, most));
}

template <class Sample>
void tell_slice(SliceEncoder& encoder, const std::vector<Sample>& slice) {
  const auto count = static_cast<std::uint32_t>(slice.size());
  require(encoder.push(slice.data(), count).status);
}

template <class Index, class Sample, class Normals>
std::vector<Extraction> extract_samples(VolumeReader& volume, const Limits& limits,
                                        const ExtractionOptions& options, const Arena& arena,
                                        const std::vector<SurfaceRequest>& surfaces) {
  const VolumeInfo& info = volume.info();
  std::vector<std::unique_ptr<std::uint8_t[]>> memory;
  std::vector<Extractor<Index, Normals>> extractors(surfaces.size());
  std::vector<CrossingCounter> crossings;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    // Left as it comes: what is never used costs nothing.
    memory.emplace_back(new std::uint8_t[arena.bytes]);
    if constexpr (Normals::holds_samples) {
      const auto spacing = spacing_nm(info.spacing_mm);
      extractors[i].set_spacing({spacing[0], spacing[1], spacing[2]});
    }
    const Status started = extractors[i].start(limits, arena.capacities, surfaces[i].threshold,
                                               {memory[i].get(), arena.bytes}, surfaces[i].sink);
    if (started != Status::ok) throw std::invalid_argument(text(started));
    crossings.emplace_back(limits, surfaces[i].threshold);
  }
  SurfaceGroup<Extractor<Index, Normals>> all(
      extractors.data(), static_cast<std::uint32_t>(extractors.size()), limits.width);
  std::vector<Sample> slice(info.slice_bytes() / sizeof(Sample));
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    require(all.push(slice.data(), static_cast<std::uint32_t>(slice.size())).status);
    if (options.slices != nullptr) tell_slice(*options.slices, slice);
    for (CrossingCounter& counter : crossings) counter.add_slice(slice.data());
    if (options.progress) options.progress(z + 1);
  }
  require(all.finish());
  if (options.slices != nullptr) require(options.slices->finish());
  std::vector<Extraction> result;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    result.push_back({extractors[i].statistics(),
                      std::uint64_t{info.dims[0]} * info.dims[1] * info.dims[2],
                      crossings[i].count(), arena.bytes, extractors[i].bytes_used(),
                      arena.capacities, extractors[i].high_water()});
  return result;
}

template <class Sample, class Normals>
std::vector<Extraction> extract_in(VolumeReader& volume, const ExtractionOptions& options,
                                   const std::vector<SurfaceRequest>& surfaces) {
  const Limits limits{volume.info().dims[0], volume.info().dims[1], options.border};
  const Arena arena = arena_for<Normals>(limits, volume.info().dims[2], options);
  return arena.has_narrow_indices ? extract_samples<std::uint16_t, Sample, Normals>(
                                        volume, limits, options, arena, surfaces)
                                  : extract_samples<std::uint32_t, Sample, Normals>(
                                        volume, limits, options, arena, surfaces);
}

template <class Sample>
std::vector<Extraction> extract_as(VolumeReader& volume, const ExtractionOptions& options,
                                   const std::vector<SurfaceRequest>& surfaces) {
  return options.normals ? extract_in<Sample, GradientNormals<Sample>>(volume, options, surfaces)
                         : extract_in<Sample, NoNormals>(volume, options, surfaces);
}

// Three numbers, for people.
template <class Numbers>
std::string list(const Numbers& numbers, const char* separator) {
  std::ostringstream text;
  text.precision(9);
  text << numbers[0] << separator << numbers[1] << separator << numbers[2];
  return text.str();
}

}  // namespace

StreamHeader stream_header(const VolumeInfo& info, const ExtractionOptions& options) {
  StreamHeader header;
  header.width = info.dims[0];
  header.height = info.dims[1];
  header.depth = info.dims[2];
  const auto spacing = spacing_nm(info.spacing_mm);
  std::copy(spacing.begin(), spacing.end(), header.spacing_nm);
  header.threshold = options.threshold;
  header.border = options.border;
  return header;
}

void require_same_volume(const VolumeInfo& info, const StreamHeader& header) {
  const std::uint32_t extents[] = {header.width, header.height, header.depth};
  const auto spacing = spacing_nm(info.spacing_mm);
  bool has_extents = true, has_spacing = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] != 0 && extents[axis] != info.dims[axis]) has_extents = false;
    const std::int64_t known = header.spacing_nm[axis];
    constexpr std::int64_t rounding = 1;
    if (known != 0 && std::abs(known - spacing[axis]) > rounding) has_spacing = false;
  }
  const char* remedy = ": give the volume that the stream was made of";
  if (!has_extents)
    throw std::invalid_argument("the volume has " + list(info.dims, "x") +
                                " voxels, and the stream is of " + list(extents, "x") + remedy);
  if (!has_spacing)
    throw std::invalid_argument("the volume has the spacing " + list(info.spacing_mm, ",") +
                                " mm, and the stream is of " + list(spacing_mm(header), ",") +
                                " mm" + remedy);
}

Extraction extract(VolumeReader& volume, const ExtractionOptions& options, const Sink& sink) {
  return extract(volume, options, std::vector<SurfaceRequest>{{options.threshold, sink}})[0];
}

std::vector<Extraction> extract(VolumeReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces) {
  switch (volume.info().type) {
    case SampleType::u8:
      return extract_as<std::uint8_t>(volume, options, surfaces);
    case SampleType::u16:
      return extract_as<std::uint16_t>(volume, options, surfaces);
    case SampleType::i16:
      break;
  }
  return extract_as<std::int16_t>(volume, options, surfaces);
}

}  // namespace discmc::host

#include "extraction.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "stream_file.hpp"

namespace discmc::host {
namespace {

constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;
// Below this 16-bit indices count all records, and a run on the host is a run on the device.
constexpr std::uint64_t small_arena = std::uint64_t{1} << 20;

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

// What the index width that goes with so little memory asks for at least. Units: bytes.
template <class Normals>
std::uint64_t least_bytes(const Limits& limits) {
  const std::uint64_t narrow = minimum_bytes<std::uint16_t, Normals>(limits);
  return narrow < small_arena ? narrow : minimum_bytes<std::uint32_t, Normals>(limits);
}

// An arena, and how it is split.
struct Arrangement {
  std::uint64_t bytes;
  Capacities capacities;
};

// Throws where an extractor would refuse.
template <class Index, class Normals>
Arrangement arrangement(const Limits& limits, const ExtractionOptions& options,
                        std::uint64_t memory) {
  if (options.capacities) {
    if (!is_valid<Index>(*options.capacities))
      throw std::invalid_argument(
          "--capacities " + std::to_string(options.capacities->records) + "," +
          std::to_string(options.capacities->holes) + ": give at least " +
          std::to_string(minimum_capacities().records) + " records, and fewer than 2^31");
    return {memory, *options.capacities};
  }
  if (memory < minimum_bytes<Index, Normals>(limits))
    throw std::invalid_argument("--memory " + std::to_string(memory) +
                                " is too little for slices of " + std::to_string(limits.width) +
                                "x" + std::to_string(limits.height) + ": give at least " +
                                std::to_string(least_bytes<Normals>(limits)) + " bytes");
  return {memory, default_capacities<Index, Normals>(limits, memory)};
}

template <class Index, class Sample, class Normals>
Extraction extract_samples(VolumeReader& volume, const Limits& limits,
                           const ExtractionOptions& options, std::uint64_t memory,
                           const Sink& sink) {
  const VolumeInfo& info = volume.info();
  const auto [bytes, capacities] = arrangement<Index, Normals>(limits, options, memory);
  // Left as it comes: what is never used costs nothing.
  const std::unique_ptr<std::uint8_t[]> arena(new std::uint8_t[bytes]);
  Extractor<Index, Normals> extractor;
  if constexpr (Normals::holds_samples) {
    const auto spacing = spacing_nm(info.spacing_mm);
    extractor.set_spacing({spacing[0], spacing[1], spacing[2]});
  }
  const Status started =
      extractor.start(limits, capacities, options.threshold, {arena.get(), bytes}, sink);
  if (started != Status::ok) throw std::invalid_argument(text(started));
  std::vector<Sample> slice(info.slice_bytes() / sizeof(Sample));
  CrossingCounter crossings(limits, options.threshold);
  for (std::uint32_t z = 0; z < info.dims[2]; ++z) {
    volume.read_slice(slice.data());
    const PushResult pushed =
        extractor.push(slice.data(), static_cast<std::uint32_t>(slice.size()));
    if (pushed.status != Status::ok) throw std::runtime_error(text(pushed.status));
    crossings.add_slice(slice.data());
    if (options.progress) options.progress(z + 1);
  }
  const Status finished = extractor.finish();
  if (finished != Status::ok) throw std::runtime_error(text(finished));
  return {extractor.statistics(), std::uint64_t{info.dims[0]} * info.dims[1] * info.dims[2],
          crossings.count(),      bytes,
          extractor.bytes_used(), capacities,
          extractor.high_water()};
}

// The arena that is asked for, or a generous one. Units: bytes.
template <class Normals>
std::uint64_t arena_bytes(const Limits& limits, std::uint32_t slices,
                          const ExtractionOptions& options) {
  if (options.capacities) {
    const std::uint64_t narrow = bytes_for<std::uint16_t, Normals>(limits, *options.capacities);
    return narrow < small_arena && is_valid<std::uint16_t>(*options.capacities)
               ? narrow
               : bytes_for<std::uint32_t, Normals>(limits, *options.capacities);
  }
  const std::uint64_t least = 2 * minimum_bytes<std::uint32_t, Normals>(limits);
  const std::uint64_t most =
      std::max(worst_case_bytes<std::uint32_t, Normals>(limits, slices), least);
  // More than the worst case needs is never touched.
  return options.memory > 0 ? std::min(options.memory, std::max(most, small_arena))
                            : std::max(std::min(generous_bytes, most), least);
}

template <class Sample, class Normals>
Extraction extract_in(VolumeReader& volume, const ExtractionOptions& options, const Sink& sink) {
  const Limits limits{volume.info().dims[0], volume.info().dims[1], options.border};
  const std::uint64_t memory = arena_bytes<Normals>(limits, volume.info().dims[2], options);
  const bool is_asked_for = options.memory > 0 || options.capacities;
  return is_asked_for && memory < small_arena ? extract_samples<std::uint16_t, Sample, Normals>(
                                                    volume, limits, options, memory, sink)
                                              : extract_samples<std::uint32_t, Sample, Normals>(
                                                    volume, limits, options, memory, sink);
}

template <class Sample>
Extraction extract_as(VolumeReader& volume, const ExtractionOptions& options, const Sink& sink) {
  return options.normals ? extract_in<Sample, GradientNormals<Sample>>(volume, options, sink)
                         : extract_in<Sample, NoNormals>(volume, options, sink);
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
  switch (volume.info().type) {
    case SampleType::u8:
      return extract_as<std::uint8_t>(volume, options, sink);
    case SampleType::u16:
      return extract_as<std::uint16_t>(volume, options, sink);
    case SampleType::i16:
      break;
  }
  return extract_as<std::int16_t>(volume, options, sink);
}

}  // namespace discmc::host

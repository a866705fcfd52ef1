#include "extraction.hpp"

#include <discmc/learning_extractor.hpp>
#include <discmc/surface_group.hpp>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <memory>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "crossing_counter.hpp"
#include "mask_bits.hpp"
#include "own_filter.hpp"
#include "require.hpp"
#include "streams/stream_file.hpp"

namespace discmc::host {
namespace {

constexpr std::uint64_t generous_bytes = std::uint64_t{64} << 20;

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

template <class Normals>
std::uint64_t generous_bytes_for(const Limits& limits) {
  return std::max(generous_bytes, 2 * minimum_bytes<std::uint32_t, Normals>(limits));
}

// What is asked for, or a generous one. Throws where an extractor would refuse.
template <class Normals>
Arena arena_for(const Limits& limits, std::uint32_t slices, const ExtractionOptions& options) {
  if (options.capacities) return arena_with<Normals>(limits, *options.capacities);
  // More than the worst case needs is never touched.
  const std::uint64_t most = worst_case_bytes<std::uint32_t, Normals>(limits, slices);
  const std::uint64_t asked =
      options.memory > 0 ? options.memory : generous_bytes_for<Normals>(limits);
  return arena_of<Normals>(limits, std::min(asked, most));
}

// Rows of bits from samples: those of all surfaces side by side, as SurfaceGroup and SliceEncoder
// take them.
class BitSource {
 public:
  BitSource(const VolumeInfo& info, const Limits& limits, const ExtractionOptions& options,
            const std::vector<SurfaceRequest>& surfaces)
      : height_(limits.height),
        row_bytes_(bit_row_bytes(limits.width)),
        bits_(row_bytes_ * surfaces.size() * height_),
        filtered_(row_bytes_ * surfaces.size()),
        full_row_(row_bytes_, 0xff),
        is_full_(surfaces.size(), true) {
    if (limits.width % 8 != 0)
      full_row_.back() = static_cast<std::uint8_t>((1U << limits.width % 8) - 1);
    for (const SurfaceRequest& surface : surfaces) {
      selectors_.emplace_back(info, surface.selection);
      crossings_.emplace_back(limits);
      if (options.takes_majority) filters_.push_back(std::make_unique<OwnFilter>(limits));
    }
  }

  /// Calls for every row that is due after this slice. mask: the rows of its mask, if it has one.
  template <class Call>
  void add_slice(const void* samples, const std::uint8_t* mask, Call call) {
    if (mask != nullptr) mask_.insert(mask_.end(), mask, mask + row_bytes_ * height_);
    const std::size_t stride = filtered_.size();
    for (std::size_t i = 0; i < selectors_.size(); ++i) {
      const auto not_numbers = selectors_[i].select(samples, bits_.data() + i * row_bytes_, stride);
      if (i == 0) not_numbers_ += not_numbers;
    }
    for (std::uint32_t y = 0; y < height_; ++y) add_row(bits_.data() + y * stride, call);
  }
  /// Calls for the rows that are left.
  template <class Call>
  void finish(Call call) {
    while (is_filtered([](OwnFilter& own, std::size_t) { return own.filter.drain(); }))
      pass_on(filtered_.data(), call);
  }

  std::uint64_t crossings(std::size_t surface) const { return crossings_[surface].count(); }
  std::uint64_t not_numbers() const { return not_numbers_; }
  bool is_full(std::size_t surface) const { return is_full_[surface]; }

 private:
  template <class Call>
  void add_row(std::uint8_t* row, Call call) {
    if (filters_.empty()) return pass_on(row, call);
    if (is_filtered(
            [&](OwnFilter& own, std::size_t i) { return own.filter.push(row + i * row_bytes_); }))
      pass_on(filtered_.data(), call);
  }
  // Whether the filters, which are all where the first one is, had a row each.
  template <class Next>
  bool is_filtered(Next next) {
    bool has_row = false;
    for (std::size_t i = 0; i < filters_.size(); ++i) {
      const std::uint8_t* const row = next(*filters_[i], i);
      has_row = row != nullptr;
      if (has_row) std::copy(row, row + row_bytes_, filtered_.data() + i * row_bytes_);
    }
    return has_row;
  }
  template <class Call>
  void pass_on(std::uint8_t* row, Call call) {
    if (!mask_.empty()) apply_mask(row);
    for (std::size_t i = 0; i < crossings_.size(); ++i) {
      const std::uint8_t* const own = row + i * row_bytes_;
      crossings_[i].add_row(own);
      is_full_[i] = is_full_[i] && std::equal(full_row_.begin(), full_row_.end(), own);
    }
    call(row);
  }
  // After the filters, which would put voxels beside the mask's edge on again.
  void apply_mask(std::uint8_t* row) {
    const auto end = mask_.begin() + static_cast<std::ptrdiff_t>(row_bytes_);
    for (std::size_t i = 0; i < crossings_.size(); ++i)
      keep_masked(row + i * row_bytes_, mask_.begin(), row_bytes_);
    mask_.erase(mask_.begin(), end);
  }

  std::uint32_t height_;
  std::size_t row_bytes_;
  std::vector<std::uint8_t> bits_;      // of a slice
  std::vector<std::uint8_t> filtered_;  // a row
  std::vector<std::uint8_t> full_row_;
  std::vector<bool> is_full_;      // so far, of each surface
  std::deque<std::uint8_t> mask_;  // rows of the mask that are not yet due
  std::vector<SliceSelector> selectors_;
  std::vector<std::unique_ptr<OwnFilter>> filters_;
  std::vector<CrossingCounter> crossings_;
  std::uint64_t not_numbers_ = 0;
};

// Slices of a volume that follow each other.
struct SliceSpan {
  std::uint32_t first, end;
  bool holds(std::uint32_t z) const { return z >= first && z < end; }
};

// What an extractor is given: of a slab also a slice of its neighbours.
SliceSpan given_slices(const Limits& limits, std::uint32_t depth,
                       const std::optional<SlabRange>& slab) {
  if (!slab) return {0, depth};
  return {slab->first - (limits.slab.continues_below ? 1 : 0),
          slab->end() + (limits.slab.continues_above ? 1 : 0)};
}

// What these are made from: the filter looks at a slice on either side.
SliceSpan slices_for(const SliceSpan& given, std::uint32_t depth, bool takes_majority) {
  const std::uint32_t reach = takes_majority ? 1 : 0;
  return {given.first > reach ? given.first - reach : 0, std::min(depth, given.end + reach)};
}

// The samples that an extractor takes, where it takes any beside bits.
template <class AnyExtractor>
struct SampleOf {
  using Type = void;
};
template <class Index, class Sample>
struct SampleOf<Extractor<Index, GradientNormals<Sample>>> {
  using Type = Sample;
};
template <class AnyExtractor>
constexpr bool holds_samples = !std::is_void_v<typename SampleOf<AnyExtractor>::Type>;

// Left as it comes: what is never used costs nothing.
std::unique_ptr<std::uint8_t[]> untouched(std::uint64_t bytes) {
  return std::unique_ptr<std::uint8_t[]>(new std::uint8_t[bytes]);
}

// The extractors of all surfaces, in memory of their own.
template <class AnyExtractor>
class Scan {
 public:
  static constexpr bool learns = std::is_same_v<AnyExtractor, LearningExtractor>;

  Scan(const VolumeInfo& info, const Limits& limits, const Arena& arena,
       const std::vector<SurfaceRequest>& surfaces)
      : arena_(arena), extractors_(surfaces.size()) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      memory_.push_back(untouched(arena.bytes));
      if constexpr (holds_samples<AnyExtractor>) {
        const auto spacing = spacing_nm(info.spacing_mm);
        extractors_[i].set_spacing({spacing[0], spacing[1], spacing[2]});
      }
      if constexpr (learns) {
        learnt_.push_back(untouched(learnt_bytes));
        extractors_[i].learn_in({learnt_.back().get(), learnt_bytes});
      }
      const std::int32_t threshold = stored_threshold(info, surfaces[i].selection.low);
      const Status started = extractors_[i].start(
          limits, arena.capacities, threshold, {memory_[i].get(), arena.bytes}, surfaces[i].sink);
      if (started != Status::ok) throw std::invalid_argument(text(started));
    }
  }

  SurfaceGroup<AnyExtractor> group() {
    return {extractors_.data(), static_cast<std::uint32_t>(extractors_.size()),
            extractors_[0].limits().width};
  }

  std::vector<Extraction> results(const VolumeInfo& info, const std::optional<SlabRange>& slab,
                                  const BitSource& bits) const {
    const std::uint64_t slices = slab ? slab->slices : info.dims[2];
    const std::uint64_t voxels = slices * info.dims[0] * info.dims[1];
    std::vector<Extraction> results;
    for (std::size_t i = 0; i < extractors_.size(); ++i)
      results.push_back({extractors_[i].statistics(), voxels, bits.crossings(i), bits.not_numbers(),
                         bits.is_full(i), slab.has_value(), use_of(extractors_[i])});
    return results;
  }

 private:
  static constexpr std::uint64_t learnt_bytes = std::uint64_t{1} << 20;

  std::optional<MemoryUse> use_of(const AnyExtractor& extractor) const {
    if (learns) return std::nullopt;
    return MemoryUse{arena_.bytes, extractor.bytes_used(), arena_.capacities,
                     extractor.high_water()};
  }

  Arena arena_;
  std::vector<std::unique_ptr<std::uint8_t[]>> memory_, learnt_;
  std::vector<AnyExtractor> extractors_;
};

template <class AnyExtractor>
std::vector<Extraction> scan(VolumeReader& volume, const Limits& limits,
                             const ExtractionOptions& options, const Arena& arena,
                             const std::vector<SurfaceRequest>& surfaces) {
  const VolumeInfo& info = volume.info();
  Scan<AnyExtractor> scan(info, limits, arena, surfaces);
  auto all = scan.group();
  BitSource bits(info, limits, options, surfaces);
  const SliceSpan given = given_slices(limits, info.dims[2], options.slab);
  const SliceSpan read = slices_for(given, info.dims[2], options.takes_majority);
  std::uint64_t rows = std::uint64_t{read.first} * limits.height;
  const auto push_bits = [&](const std::uint8_t* row) {
    if (!given.holds(static_cast<std::uint32_t>(rows++ / limits.height))) return;
    if constexpr (!holds_samples<AnyExtractor>) require(all.push_bits(row).status);
    if (options.slices != nullptr) require(options.slices->push_bits(row).status);
  };
  std::optional<MaskBits> mask;
  if (options.mask != nullptr) mask.emplace(*options.mask);
  std::vector<std::uint8_t> slice(info.slice_bytes());
  for (std::uint32_t z = 0; z < read.end; ++z) {
    volume.read_slice(slice.data());
    const std::uint8_t* const mask_rows = mask ? mask->next_slice() : nullptr;
    if (z < read.first) continue;
    bits.add_slice(slice.data(), mask_rows, push_bits);
    for (const SurfaceRequest& surface : surfaces)
      if (surface.crossings != nullptr) surface.crossings->add_slice(slice.data(), mask_rows);
    if constexpr (holds_samples<AnyExtractor>) {
      using Sample = typename SampleOf<AnyExtractor>::Type;
      require(all.push(reinterpret_cast<const Sample*>(slice.data()), limits.width * limits.height)
                  .status);
    }
    if (options.progress) options.progress(z + 1);
  }
  bits.finish(push_bits);
  require(all.finish());
  if (options.slices != nullptr) require(options.slices->finish());
  return scan.results(info, options.slab, bits);
}

Limits limits_of(const VolumeInfo& info, const ExtractionOptions& options) {
  Limits limits{info.dims[0], info.dims[1], options.border};
  if (const auto& slab = options.slab)
    limits.slab = {slab->first, slab->first > 0, slab->end() < info.dims[2]};
  return limits;
}

template <class Normals>
std::vector<Extraction> extract_with(VolumeReader& volume, const ExtractionOptions& options,
                                     const std::vector<SurfaceRequest>& surfaces) {
  const Limits limits = limits_of(volume.info(), options);
  const Arena arena = arena_for<Normals>(limits, volume.info().dims[2], options);
  return arena.has_narrow_indices
             ? scan<Extractor<std::uint16_t, Normals>>(volume, limits, options, arena, surfaces)
             : scan<Extractor<std::uint32_t, Normals>>(volume, limits, options, arena, surfaces);
}

// On a host, with no device in mind.
std::vector<Extraction> extract_fast(VolumeReader& volume, const ExtractionOptions& options,
                                     const std::vector<SurfaceRequest>& surfaces) {
  const Limits limits = limits_of(volume.info(), options);
  const std::uint64_t bytes = generous_bytes_for<NoNormals>(limits);
  const Arena arena{false, bytes, default_capacities<std::uint32_t>(limits, bytes)};
  return scan<LearningExtractor>(volume, limits, options, arena, surfaces);
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
  header.threshold = stored_threshold(info, options.selection.low);
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
  const char* remedy =
      ": give the volume that the stream was made of, with the same --crop and --shrink";
  if (!has_extents)
    throw std::invalid_argument("the volume has " + list(info.dims, "x") +
                                " voxels, and the stream is of " + list(extents, "x") + remedy);
  if (!has_spacing)
    throw std::invalid_argument("the volume has the spacing " + list(info.spacing_mm, ",") +
                                " mm, and the stream is of " + list(spacing_mm(header), ",") +
                                " mm" + remedy);
}

Extraction extract(VolumeReader& volume, const ExtractionOptions& options, const Sink& sink) {
  return extract(volume, options, std::vector<SurfaceRequest>{{options.selection, sink}})[0];
}

std::vector<Extraction> extract(VolumeReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces) {
  if (!options.normals) {
    const bool is_of_device =
        options.measures_memory || options.memory > 0 || options.capacities.has_value();
    return is_of_device ? extract_with<NoNormals>(volume, options, surfaces)
                        : extract_fast(volume, options, surfaces);
  }
  return with_scanner_type(volume.info().type, [&](auto type) {
    return extract_with<GradientNormals<decltype(type)>>(volume, options, surfaces);
  });
}

}  // namespace discmc::host

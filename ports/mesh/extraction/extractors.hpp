// Extractors with memory of their own.
#ifndef DISCMC_MESH_EXTRACTION_EXTRACTORS_HPP
#define DISCMC_MESH_EXTRACTION_EXTRACTORS_HPP

#include <discmc/normal_extractor.hpp>
#include <discmc/surface_group.hpp>
#include "host/host_scan.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "bit_source.hpp"
#include "mask_bits.hpp"
#include "require.hpp"
#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"
#include "surfaces.hpp"

namespace discmc::meshing {

/// The memory of one extractor, and its capacities.
struct ArenaSize {
  bool has_narrow_indices;
  std::uint64_t bytes;
  Capacities capacities;
};

/// Returns the memory of an extractor of the given type. A HostExtractor needs memory only for rows
/// of bits.
template <class AnyExtractor>
ArenaSize arena_of(const Limits& limits) {
  if (std::is_same_v<AnyExtractor, HostExtractor>)
    return {false, detail::sizing::minimum_bytes<std::uint32_t>(limits), minimum_capacities()};
  const std::uint64_t bytes = generous_bytes_for(limits);
  return {false, bytes, Extractor32::default_capacities(limits, bytes)};
}

/// The type of samples of an extractor; void if it only accepts bits.
template <class AnyExtractor>
struct SampleOf {
  using Type = void;
};
template <class Index, class Sample>
struct SampleOf<NormalExtractor<Index, Sample>> {
  using Type = Sample;
};
template <class AnyExtractor>
constexpr bool holds_samples = !std::is_void_v<typename SampleOf<AnyExtractor>::Type>;

/// Returns uninitialised memory, whose unused pages cost nothing.
inline std::unique_ptr<std::uint8_t[]> uninitialised(std::uint64_t bytes) {
  return std::unique_ptr<std::uint8_t[]>(new std::uint8_t[bytes]);
}

/// A slice of samples, and the rows of its mask, if there is one.
struct SliceToExtract {
  const std::uint8_t* samples;
  const std::uint8_t* mask_rows;
};

/// The extractors of all surfaces, with their memory.
template <class AnyExtractor>
class Extractors {
 public:
  Extractors(const ArenaSize& arena, std::size_t surfaces) : arena_(arena), extractors_(surfaces) {
    for (std::size_t i = 0; i < surfaces; ++i) memory_.push_back(uninitialised(arena.bytes));
  }

  /// Extracts the surfaces of a volume. limits: with the slab of the spans. next_slice(): returns a
  /// SliceToExtract for each slice in spans.read.
  template <class NextSlice>
  std::vector<Extraction> extract(const SampleGrid& info, const Limits& limits,
                                  const SlabSpans& spans, const SurfaceOptions& options,
                                  const std::vector<SurfaceRequest>& surfaces,
                                  NextSlice next_slice) {
    start(info, limits, surfaces);
    SurfaceGroup<AnyExtractor> group{extractors_.data(),
                                     static_cast<std::uint32_t>(extractors_.size()), limits.width};
    BitSource bits(info, limits, spans, options.filters_by_majority, surfaces);
    const auto push_bits = [&](const std::uint8_t* row) {
      if constexpr (!holds_samples<AnyExtractor>) require(group.push_bits(row).status);
    };
    for (std::uint32_t z = spans.read.first; z < spans.read.end; ++z) {
      const SliceToExtract slice = next_slice();
      bits.add_slice(slice.samples, slice.mask_rows, push_bits);
      if (options.slices) options.slices(slice.samples, slice.mask_rows);
      for (const SurfaceRequest& surface : surfaces)
        if (surface.crossings != nullptr)
          surface.crossings->add_slice(slice.samples, slice.mask_rows);
      if constexpr (holds_samples<AnyExtractor>) {
        using Sample = typename SampleOf<AnyExtractor>::Type;
        const auto* samples = reinterpret_cast<const Sample*>(slice.samples);
        require(group.push(samples, limits.width * limits.height).status);
      }
      if (options.progress) options.progress(z + 1);
    }
    bits.finish(push_bits);
    require(group.finish());
    return results(info, spans, bits);
  }

 private:
  void start(const SampleGrid& info, const Limits& limits,
             const std::vector<SurfaceRequest>& surfaces) {
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      if constexpr (holds_samples<AnyExtractor>) {
        const auto spacing = spacing_nm(info.spacing_mm);
        extractors_[i].set_spacing({spacing[0], spacing[1], spacing[2]});
      }
      const std::int32_t threshold = stored_threshold(info, surfaces[i].selection.low);
      const Status started = extractors_[i].start(
          limits, arena_.capacities, threshold, {memory_[i].get(), arena_.bytes}, surfaces[i].sink);
      if (started != Status::ok) throw std::invalid_argument(to_string(started));
      if constexpr (std::is_same_v<AnyExtractor, HostExtractor>)
        extractors_[i].set_region_receiver(surfaces[i].regions);
    }
  }

  std::vector<Extraction> results(const SampleGrid& info, const SlabSpans& spans,
                                  const BitSource& bits) {
    const std::uint64_t voxels = std::uint64_t{spans.own.count()} * info.dims[0] * info.dims[1];
    const bool is_of_slab = spans.own.count() < info.dims[2];
    std::vector<Extraction> results;
    for (std::size_t i = 0; i < extractors_.size(); ++i) {
      results.push_back({extractors_[i].statistics(), voxels, bits.not_numbers(), bits.is_full(i),
                         is_of_slab, use_of(extractors_[i])});
      if constexpr (std::is_same_v<AnyExtractor, HostExtractor>)
        results.back().left_triangle_parts = extractors_[i].left_triangle_parts();
    }
    return results;
  }

  std::optional<MemoryUse> use_of(const AnyExtractor& extractor) const {
    if constexpr (std::is_same_v<AnyExtractor, HostExtractor>)
      return std::nullopt;
    else
      return MemoryUse{arena_.bytes, extractor.bytes_used(), arena_.capacities, extractor.peaks()};
  }

  ArenaSize arena_;
  std::vector<std::unique_ptr<std::uint8_t[]>> memory_;
  std::vector<AnyExtractor> extractors_;
};

inline Limits limits_of(const SampleGrid& info, const SurfaceOptions& options) {
  Limits limits{info.dims[0], info.dims[1], options.border};
  if (options.slab) limits.slab = slab_limits(*options.slab, info.dims[2]);
  return limits;
}

/// Reads the volume and its mask up to the end of the slab, and extracts the surfaces.
template <class AnyExtractor>
std::vector<Extraction> extract_by(SliceReader& volume, const Limits& limits,
                                   const SurfaceOptions& options, const ArenaSize& arena,
                                   const std::vector<SurfaceRequest>& surfaces) {
  const SampleGrid& info = volume.info();
  const SlabSpans spans =
      slab_spans(slices_of(options.slab, info.dims[2]), info.dims[2], options.filters_by_majority);
  std::optional<MaskBits> mask;
  if (options.mask != nullptr) mask.emplace(*options.mask);
  for (std::uint32_t z = 0; z < spans.read.first; ++z) {
    volume.skip_slice();
    if (mask) mask->skip_slice();
  }
  std::vector<std::uint8_t> slice(info.slice_bytes());
  Extractors<AnyExtractor> extractors(arena, surfaces.size());
  return extractors.extract(info, limits, spans, options, surfaces, [&] {
    volume.read_slice(slice.data());
    return SliceToExtract{slice.data(), mask ? mask->next_slice() : nullptr};
  });
}

}  // namespace discmc::meshing

#endif

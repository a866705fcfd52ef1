#include "extraction.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

#include "arena_memory.hpp"
#include "extraction/extractors.hpp"
#include "extraction/mask_bits.hpp"
#include "extraction/part_extraction.hpp"
#include "samples/iso_value.hpp"
#include "samples/spacing.hpp"

namespace discmc::command {
namespace {

template <class Normals>
ArenaSize arena_with(const Limits& limits, const Capacities& capacities) {
  if (detail::sizing::is_valid<std::uint16_t>(capacities))
    return {true, detail::sizing::bytes_for<std::uint16_t, Normals>(limits, capacities),
            capacities};
  if (detail::sizing::is_valid<std::uint32_t>(capacities))
    return {false, detail::sizing::bytes_for<std::uint32_t, Normals>(limits, capacities),
            capacities};
  throw std::invalid_argument(
      "--capacities " + std::to_string(capacities.slots) + "," + std::to_string(capacities.holes) +
      ": invalid number of slots; expected " + std::to_string(minimum_capacities().slots) + " to " +
      std::to_string(detail::sizing::max_slots<std::uint32_t>));
}

template <class Normals>
ArenaSize arena_of(const Limits& limits, std::uint64_t bytes) {
  const std::uint64_t min_bytes = detail::sizing::minimum_bytes<std::uint16_t, Normals>(limits);
  if (bytes < min_bytes) throw std::invalid_argument(too_little_memory(bytes, limits, min_bytes));
  if (fits_narrow_indices<Normals>(limits, bytes))
    return {true, bytes, detail::sizing::default_capacities<std::uint16_t, Normals>(limits, bytes)};
  return {false, bytes, detail::sizing::default_capacities<std::uint32_t, Normals>(limits, bytes)};
}

// Returns the requested arena, or a generous one. Throws if an extractor would refuse it.
template <class Normals>
ArenaSize arena_for(const Limits& limits, std::uint32_t slices, const ExtractionOptions& options) {
  if (options.capacities) return arena_with<Normals>(limits, *options.capacities);
  // The scan never touches more memory than its worst case needs.
  const std::uint64_t max_bytes = detail::sizing::bytes_for<std::uint32_t, Normals>(
      limits, worst_case_capacities(limits, slices));
  const std::uint64_t asked =
      options.memory > 0 ? options.memory : generous_bytes_for<Normals>(limits);
  return arena_of<Normals>(limits, std::min(asked, max_bytes));
}

template <class Normals, class Narrow, class Wide>
std::vector<Extraction> extract_with(SliceReader& volume, const ExtractionOptions& options,
                                     const std::vector<SurfaceRequest>& surfaces) {
  const Limits limits = limits_of(volume.info(), options);
  const ArenaSize arena = arena_for<Normals>(limits, volume.info().dims[2], options);
  return arena.has_narrow_indices ? extract_by<Narrow>(volume, limits, options, arena, surfaces)
                                  : extract_by<Wide>(volume, limits, options, arena, surfaces);
}

// Lists three numbers for people.
template <class Numbers>
std::string list(const Numbers& numbers, const char* separator) {
  std::ostringstream text;
  text.precision(9);
  text << numbers[0] << separator << numbers[1] << separator << numbers[2];
  return text.str();
}

}  // namespace

StreamHeader stream_header(const SampleGrid& info, const ExtractionOptions& options) {
  StreamHeader header;
  header.width = info.dims[0];
  header.height = info.dims[1];
  header.depth = info.dims[2];
  const auto spacing = spacing_nm(info.spacing_mm);
  std::copy(spacing.begin(), spacing.end(), header.spacing_nm);
  header.thresholds[0] = stored_threshold(info, options.selection.low);
  header.border = options.border;
  return header;
}

void require_same_volume(const SampleGrid& info, const StreamHeader& header) {
  const std::uint32_t extents[] = {header.width, header.height, header.depth};
  const auto spacing = spacing_nm(info.spacing_mm);
  bool has_extents = true, has_spacing = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (extents[axis] != 0 && extents[axis] != info.dims[axis]) has_extents = false;
    const std::int64_t declared = header.spacing_nm[axis];
    constexpr std::int64_t rounding = 1;
    if (declared != 0 && std::abs(declared - spacing[axis]) > rounding) has_spacing = false;
  }
  const char* remedy =
      "; give the volume that the stream was made of, with the same --crop and --shrink";
  if (!has_extents)
    throw std::invalid_argument("the volume has " + list(info.dims, "x") +
                                " voxels, and the stream has " + list(extents, "x") + remedy);
  if (!has_spacing)
    throw std::invalid_argument("the volume has the spacing " + list(info.spacing_mm, ",") +
                                " mm, and the stream has " + list(spacing_mm(header), ",") + " mm" +
                                remedy);
}

Extraction extract(SliceReader& volume, const ExtractionOptions& options, const Sink& sink) {
  return extract(volume, options, std::vector<SurfaceRequest>{{options.selection, sink}})[0];
}

std::vector<Extraction> extract(SliceReader& volume, const ExtractionOptions& options,
                                const std::vector<SurfaceRequest>& surfaces) {
  const bool is_of_device = options.normals || options.measures_memory || options.memory > 0 ||
                            options.capacities.has_value();
  if (options.jobs || !is_of_device) return extract_surfaces(volume, options, surfaces);
  if (!options.normals)
    return extract_with<detail::trace::BitIntake, Extractor16, Extractor32>(volume, options,
                                                                            surfaces);
  return with_scanner_type(volume.info().type, [&](auto type) {
    using Sample = decltype(type);
    return extract_with<detail::trace::GradientIntake<Sample>, NormalExtractor16<Sample>,
                        NormalExtractor32<Sample>>(volume, options, surfaces);
  });
}

}  // namespace discmc::command

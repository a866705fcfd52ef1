#include "volume_options.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include "named_values.hpp"
#include "option_checks.hpp"
#include "text/number_text.hpp"
#include "volumes/volume.hpp"

namespace discmc::command {
namespace {

std::optional<VoxelRange> voxel_range(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return std::nullopt;
  const std::string_view first = text.substr(0, dots), last = text.substr(dots + 2);
  VoxelRange range;
  if (!first.empty()) {
    const auto value = whole_number<std::uint32_t>(first);
    if (!value) return std::nullopt;
    range.first = *value;
  }
  if (!last.empty()) {
    range.last = whole_number<std::uint32_t>(last);
    if (!range.last || *range.last < range.first) return std::nullopt;
  }
  return range;
}

std::optional<Crop> crop_of(std::string_view text) {
  Crop crop;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t end = std::min(text.find(','), text.size());
    const bool is_last = axis == 2;
    const auto range = voxel_range(text.substr(0, end));
    if (!range || (end == text.size()) != is_last) return std::nullopt;
    crop[axis] = *range;
    if (!is_last) text.remove_prefix(end + 1);
  }
  return crop;
}

CLI::Validator usable_axes() {
  return CLI::Validator(
      [](std::string& text) {
        std::string sorted = text;
        std::sort(sorted.begin(), sorted.end());
        const bool is_usable = text.find_first_not_of("tczyx") == std::string::npos &&
                               std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() &&
                               text.find('x') != std::string::npos &&
                               text.find('y') != std::string::npos;
        return is_usable ? std::string()
                         : "invalid axes '" + text +
                               "'; expected letters of tczyx, each once, with x and y, as in zyx";
      },
      "");
}

void add_part_options(CLI::App& app, VolumeOptions& options) {
  app.add_option_function<std::string>(
         "--crop", [&options](const std::string& text) { options.crop = crop_of(text); },
         "read voxels A to B along x, C to D along y, E to F along z; the first is 0. Omit A or B "
         "for the first or last voxel: '..,..,100..' keeps the slices from 100 on. The mesh keeps "
         "its coordinates")
      ->check(CLI::Validator(
          [](std::string& text) {
            return crop_of(text)
                       ? std::string()
                       : "invalid range '" + text +
                             "'; expected A..B,C..D,E..F with A <= B; any number may be left out";
          },
          ""))
      ->option_text("A..B,C..D,E..F");
  app.add_option("--shrink", options.shrink,
                 "replace each block of N x N x N voxels by its mean, or by its most frequent "
                 "label, after --crop. The last block along an axis may be smaller")
      ->check(CLI::Range(2, 16))
      ->option_text("N");
}

// Options for headerless files.
void add_layout_options(CLI::App& app, VolumeOptions& options) {
  const auto layout = [&options]() -> RawLayout& {
    return options.layout ? *options.layout : options.layout.emplace();
  };
  CLI::Option* dims = app.add_option_function<std::vector<std::uint32_t>>(
                             "--dims",
                             [layout](const std::vector<std::uint32_t>& extents) {
                               std::copy_n(extents.begin(), 3, layout().dims.begin());
                             },
                             "extents of a headerless file, in voxels")
                          ->delimiter(',')
                          ->expected(3)
                          ->option_text("X,Y,Z");
  CLI::Option* type = add_named_option<SampleType>(
      app, "--type", [layout](SampleType sample_type) { layout().type = sample_type; },
      {std::begin(sample_types), std::end(sample_types)},
      "sample type of a headerless file: unsigned, signed or floating point, with its bits");
  dims->needs(type);
  type->needs(dims);
  app.add_flag_callback(
         "--big-endian", [layout] { layout().is_big_endian = true; },
         "read samples of a headerless file with the high byte first")
      ->needs(dims);
  app.add_option_function<std::uint64_t>(
         "--skip-bytes", [layout](std::uint64_t bytes) { layout().skipped_bytes = bytes; },
         "bytes to skip before the first sample of a headerless file")
      ->option_text("N")
      ->needs(dims);
}

}  // namespace

void add_volume_options(CLI::App& app, VolumeOptions& options) {
  app.option_defaults()->group(volume_group);
  add_layout_options(app, options);
  app.add_option(
         "--frame", options.frame,
         "read this volume of a file or DICOM series that holds several (4D); the first is 0")
      ->option_text("N");
  app.add_option("--channel", options.channel,
                 "read this channel of a file that holds several; the first is 0")
      ->option_text("N");
  app.add_option("--axes", options.axes,
                 "the axes of an array (NumPy, HDF5, Zarr), the slowest first: letters of tczyx. "
                 "--frame chooses t, --channel chooses c. The pages of a TIFF are along z, c or t: "
                 "zyx, cyx or tyx (default: the axes in the file, or zyx)")
      ->check(usable_axes())
      ->option_text("LETTERS");
  app.add_option(
         "--level", options.level,
         "read this resolution of OME-Zarr; the finest is 0 (default: the finest with at most "
         "32766 voxels along x and y)")
      ->option_text("N");
  app.add_option_function<std::vector<double>>(
         "--spacing",
         [&options](const std::vector<double>& spacing) {
           if (spacing.size() == 2)
             refuse("--spacing", "2 distances are given; give one for all axes, or X,Y,Z");
           auto& distances = options.spacing_mm.emplace();
           distances.fill(spacing[0]);
           std::copy(spacing.begin(), spacing.end(), distances.begin());
         },
         "distances between voxels in millimetres, or one for all axes (default: those in the "
         "file, otherwise 1)")
      ->delimiter(',')
      ->expected(1, 3)
      ->option_text("X,Y,Z")
      ->check(usable_spacing());
  app.add_option("--series", options.series,
                 "read this series or volume of several in DICOM: the UID of a series, or its "
                 "number in the list printed without this option")
      ->option_text("SERIES");
  app.add_flag("--merge-series", options.merges_series,
               "read DICOM slices of several series as one volume, for files that each have a "
               "series UID of their own");
  add_named_option(app, "--order", options.order,
                   NamedValues<SliceOrder>{{"position", SliceOrder::position},
                                           {"instance", SliceOrder::instance},
                                           {"name", SliceOrder::name}},
                   "order DICOM slices by position, by InstanceNumber or by file name");
  app.add_flag(
      "--allow-gaps", options.allow_gaps,
      "repeat the nearest slice if slices of DICOM or pictures are missing (default: fail)");
  add_part_options(app, options);
}

void add_other_files(const CLI::App& app, VolumeOptions& options) {
  const std::vector<std::string> others = app.remaining();
  if (!std::all_of(others.begin(), others.end(), [](const std::string& each) {
        return is_volume_name(each) && each.front() != '-';
      }))
    throw CLI::ExtrasError(app.get_name(), others);
  options.others.assign(others.begin(), others.end());
}

}  // namespace discmc::command

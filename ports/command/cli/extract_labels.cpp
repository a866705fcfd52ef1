// discmc extract --labels all: converts a segmentation to one mesh per label.
#include <algorithm>
#include <iomanip>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "extract.hpp"
#include "extract_files.hpp"
#include "extraction/labels.hpp"
#include "files/write_failure.hpp"
#include "jobs/ordered_pipeline.hpp"
#include "mesh_output.hpp"
#include "meshes/surface_normals.hpp"
#include "pictures/srgb.hpp"
#include "progress.hpp"
#include "segmentation.hpp"
#include "smoothing/smoothed_labels.hpp"
#include "text/message.hpp"
#include "volume_input.hpp"
#include "volumes/filters/filters.hpp"

namespace discmc::command {
namespace {

// A label with its surface.
struct FoundLabel {
  LabelledSurface surface;
  NamedSelection name;
  std::optional<CrossingFinder> crossings{};  // of a smoothed surface
};

// The requested labels by layer. For `all`, layers have no labels here. A region is one surface of
// several labels.
struct ChosenLabels {
  std::map<std::uint32_t, std::optional<std::set<LabelValue>>> labels;
  std::vector<NamedLabels> regions;
};

ChosenLabels chosen_labels(const ExtractArguments& arguments, const LabelNames& names) {
  ChosenLabels chosen;
  if (arguments.labels == "all") {
    for (const std::uint32_t layer : names.layers()) chosen.labels[layer];
    chosen.regions = names.regions();
    return chosen;
  }
  std::vector<NamedLabels> labels;
  try {
    labels = names.each(arguments.labels);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(display_name(arguments.volume) + ": " + error.what());
  }
  for (const NamedLabels& each : labels)
    for (const auto& [layer, values] : each.set) {
      if (values == std::vector<LabelValue>{0})
        throw std::invalid_argument(
            "--labels has 0, which is the background; leave it out, or give "
            "--label 0 for its surface");
      if (values.size() > 1) {
        chosen.regions.push_back(each);
        continue;
      }
      auto& labels_of_layer = chosen.labels[layer];
      if (values.empty()) continue;  // a mask, which has one label
      if (!labels_of_layer) labels_of_layer.emplace();
      labels_of_layer->insert(values[0]);
    }
  return chosen;
}

std::vector<FoundLabel> extracted_labels(VolumeReader& volume, const LabelOptions& options) {
  std::vector<FoundLabel> found;
  for (LabelledSurface& surface : extract_labels(volume, options))
    found.push_back({std::move(surface), {}});
  return found;
}

std::vector<FoundLabel> smoothed_labels_of(VolumeReader& volume, const LabelOptions& options,
                                           double deviation_mm, double tolerance) {
  std::optional<Progress> progress;
  const auto show = [&progress](std::size_t done, std::size_t all) {
    if (!progress) progress.emplace("smoothing", all);
    progress->show(done);
  };
  std::vector<FoundLabel> found;
  for (SmoothedLabel& label : smoothed_labels(volume, options, deviation_mm, tolerance, show))
    found.push_back({std::move(label.surface), {}, std::move(label.crossings)});
  return found;
}

// Returns surfaces without names; the caller names the labels.
std::vector<FoundLabel> surfaces_of(VolumeReader& volume, const ExtractArguments& arguments,
                                    std::optional<std::set<LabelValue>> chosen) {
  const auto deviation = smoothing_mm(arguments.reading, volume.info());
  Progress progress(deviation ? "reading" : "extracting", volume.info().dims[2]);
  const LabelOptions options{
      arguments.reading.border, arguments.reading.median > 0, std::move(chosen),
      [&progress](std::uint32_t slices) { progress.show(slices); }, jobs_of(arguments)};
  try {
    return deviation ? smoothed_labels_of(volume, options, *deviation, arguments.mesh.tolerance)
                     : extracted_labels(volume, options);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(display_name(arguments.volume) + ": " + error.what());
  }
}

// Example: "label 2 (bone)".
std::string title(const NamedSelection& label) {
  return "label " + label.given + (label.name == label.given ? "" : " (" + label.name + ")");
}

// Reports requested labels that have no voxel.
void check_missing(const ExtractArguments& arguments, const std::vector<std::string>& missing) {
  if (missing.empty()) return;
  std::string text = "no voxel has";
  for (const std::string& label : missing) text += (label == missing[0] ? " " : ", ") + label;
  if (arguments.labels != "all" && !arguments.reading.allows_empty)
    throw std::runtime_error(display_name(arguments.volume) + ": " + text +
                             "; leave out these labels, or give --allow-empty");
  print_message(arguments.volume, text);
}

NamedSelection selection_of(const LabelNames& names, std::uint32_t layer, LabelValue label) {
  const NamedLabels named = names.named(layer, label);
  NamedSelection selection{{}, label.text()};
  selection.name = named.name;
  selection.colour = named.colour ? named.colour : label_colour(label.rounded());
  return selection;
}

// Whether a label is part of a region and has no name of its own.
bool is_only_in_region(const std::vector<NamedLabels>& regions, std::uint32_t layer,
                       const FoundLabel& label) {
  if (label.name.name != label.name.given) return false;
  return std::any_of(regions.begin(), regions.end(), [&](const NamedLabels& region) {
    const auto found = region.set.find(layer);
    return found != region.set.end() &&
           std::count(found->second.begin(), found->second.end(), label.surface.label) > 0;
  });
}

// Reads the layers of a region again.
void add_region(const ExtractArguments& arguments, Segmentation& segmentation,
                const NamedLabels& region, std::vector<FoundLabel>& found,
                std::vector<std::string>& missing) {
  std::map<std::uint32_t, std::unique_ptr<VolumeReader>> layers;
  for (const auto& [layer, values] : region.set) layers.emplace(layer, segmentation.open(layer));
  std::unique_ptr<VolumeReader> volume = label_bits(std::move(layers), {region.set});
  if (auto mask = open_noted_mask(arguments.reading, volume->info()))
    volume = masked(std::move(volume), std::move(mask));
  auto surfaces = surfaces_of(*volume, arguments, std::set<LabelValue>{1});
  if (surfaces.empty()) missing.push_back("region '" + region.name + "'");
  for (FoundLabel& each : surfaces) {
    each.surface.label = region.set.begin()->second[0];
    each.name = {{}, each.surface.label.text()};
    each.name.name = region.name;
    each.name.colour = region.colour ? region.colour : label_colour(each.surface.label.rounded());
    found.push_back(std::move(each));
  }
}

// Reads each layer once, and the layers of a region once more. Returns labels in the order of the
// layers, then of their values.
std::vector<FoundLabel> find_labels(const ExtractArguments& arguments, Segmentation& segmentation) {
  const LabelNames& names = segmentation.names();
  std::vector<FoundLabel> found;
  std::vector<std::string> missing;
  const ChosenLabels all = chosen_labels(arguments, names);
  for (const NamedLabels& region : all.regions)
    add_region(arguments, segmentation, region, found, missing);
  for (const auto& [layer, chosen] : all.labels) {
    std::unique_ptr<VolumeReader> volume = segmentation.open(layer);
    if (auto mask = open_noted_mask(arguments.reading, volume->info()))
      volume = masked(std::move(volume), std::move(mask));
    std::vector<FoundLabel> surfaces = surfaces_of(*volume, arguments, chosen);
    std::set<LabelValue> with_voxels;
    for (const FoundLabel& each : surfaces) with_voxels.insert(each.surface.label);
    for (const LabelValue label : chosen.value_or(std::set<LabelValue>()))
      if (with_voxels.count(label) == 0)
        missing.push_back(title(selection_of(names, layer, label)));
    // An empty mask lacks its only label.
    if (!chosen && surfaces.empty() && names.layers().size() > 1)
      missing.push_back(names.named(layer, 1).name);
    for (FoundLabel& each : surfaces) {
      each.name = selection_of(names, layer, each.surface.label);
      if (is_only_in_region(all.regions, layer, each)) continue;
      found.push_back(std::move(each));
    }
  }
  check_missing(arguments, missing);
  return found;
}

std::vector<FoundLabel> labels_with_voxels(const ExtractArguments& arguments,
                                           Segmentation& segmentation) {
  std::vector<FoundLabel> labels = find_labels(arguments, segmentation);
  if (labels.empty() && !arguments.reading.allows_empty)
    throw std::runtime_error(display_name(arguments.volume) + ": the volume holds no label" +
                             (arguments.reading.mask.empty() ? "" : " within --mask") +
                             "; check --frame and --channel, or give --allow-empty");
  const bool has_name = std::any_of(labels.begin(), labels.end(), [](const FoundLabel& label) {
    return label.name.name != label.name.given;
  });
  if (!arguments.reading.label_table.empty() && !labels.empty() && !has_name)
    print_message(arguments.volume, "no label of the volume has a name in --label-table");
  return labels;
}

// target: the file, or the mesh's name in the common file.
void print_line(const LabelledSurface& label, std::uint64_t faces, const std::string& target,
                std::ostream& out) {
  out << std::setw(8) << label.label.text() << std::setw(14) << label.voxels << std::setw(12)
      << faces << "  " << target << '\n';
}

}  // namespace

std::vector<FileMesh> label_meshes(const ExtractArguments& arguments) {
  Segmentation segmentation(arguments.volume, arguments.reading);
  const auto placement =
      mesh_placement(arguments.volume, segmentation.info().placement, arguments.space);
  std::vector<FileMesh> meshes;
  for (FoundLabel& each : labels_with_voxels(arguments, segmentation)) {
    Surface& surface = each.surface.surface;
    keep_chosen(display_name(arguments.volume) + ": " + title(each.name), arguments.components,
                surface);
    FileMesh mesh = triangulated(surface, arguments.mesh);
    if (arguments.normals == Normals::surface) mesh.normals = surface_normals(mesh);
    place_in_file(mesh, placement, arguments.size);
    mesh.colour = each.name.colour;
    mesh.name = each.name.name;
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

int extract_label_meshes(const ExtractArguments& arguments) {
  MeshFiles files(arguments);
  Segmentation segmentation(arguments.volume, arguments.reading);
  files.set_placement(
      mesh_placement(arguments.volume, segmentation.info().placement, arguments.space));
  std::vector<FoundLabel> labels = labels_with_voxels(arguments, segmentation);
  const std::string volume = display_name(arguments.volume);

  std::vector<NamedSelection> selections;
  selections.reserve(labels.size());
  for (const FoundLabel& each : labels) selections.push_back(each.name);
  const std::vector<std::string> names = files.names_for(selections);
  std::ostream& table = table_stream(arguments.output);
  if (!arguments.is_quiet)
    table << "   label        voxels       faces  " << (files.are_one() ? "name" : "file") << '\n';
  std::vector<SurfaceOutput> outputs;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool moves = arguments.interpolates() && labels[i].crossings;
    outputs.push_back({labels[i].surface.surface, selections[i], names[i],
                       volume + ": " + title(selections[i]),
                       moves ? &labels[i].crossings->crossings() : nullptr});
    keep_chosen(outputs[i].title, arguments.components, outputs[i].surface);
  }
  const auto has_surface = [&](std::size_t i) {
    return !outputs[i].surface.polygons.empty() || arguments.reading.allows_empty;
  };
  bool has_mesh = false;
  struct Nothing {};
  run_in_order<Nothing>(
      jobs_of(arguments), names.size(), [](std::size_t, Nothing&) {},
      [&](std::size_t i, Nothing&) {
        if (has_surface(i)) files.make_ahead(outputs[i]);
      },
      [&](std::size_t i, Nothing&) {
        if (!has_surface(i))
          return print_message(arguments.volume,
                               title(selections[i]) + " has no surface; " + names[i] +
                                   (files.are_one() ? " does not contain it" : " is not written"));
        const MeshSummary mesh = files.add(std::move(outputs[i]));
        has_mesh = true;
        if (!arguments.is_quiet)
          print_line(labels[i].surface, mesh.face_count,
                     files.are_one() ? selections[i].name : names[i], table);
      });
  if (files.are_one() && !has_mesh && !arguments.reading.allows_empty)
    throw std::runtime_error(
        volume + ": no label has a surface left, so " + output_display_name(arguments.output) +
        " is not written; check --median, --mask and --min-volume, or give --allow-empty");
  files.finish();
  if (!arguments.is_quiet) require_written(table);
  return exit_ok;
}

}  // namespace discmc::command

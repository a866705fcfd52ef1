// discmc extract --labels all: a segmentation to meshes, one a label.
#include <iomanip>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "exit_codes.hpp"
#include "extract.hpp"
#include "extraction/labels.hpp"
#include "files/file_pattern.hpp"
#include "mesh_output.hpp"
#include "progress.hpp"
#include "require.hpp"
#include "volume_input.hpp"
#include "volumes/filters/mask_volume.hpp"

namespace discmc::command {
namespace {

LabelledSurfaces surfaces_of(VolumeReader& volume, const ExtractArguments& arguments) {
  Progress progress("extracting", volume.info().dims[2]);
  try {
    return extract_labels(volume, {arguments.reading.border, arguments.reading.median > 0,
                                   [&progress](std::uint32_t slices) { progress.show(slices); }});
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(arguments.volume + ": " + error.what());
  }
}

// As in "it holds no label, every voxel is 0".
std::string why_none(const ExtractArguments& arguments, std::uint64_t not_numbers) {
  if (!arguments.reading.mask.empty()) return " that --mask leaves";
  return not_numbers > 0 ? ", every voxel is 0 or not a number" : ", every voxel is 0";
}

// As in "label 2 (bone)".
std::string title(const LabelledSurface& label, const NamedSelection& selection) {
  const std::string number = std::to_string(label.label);
  return "label " + number + (selection.name == number ? "" : " (" + selection.name + ")");
}

// target: the file, or the name in it.
void write_line(const LabelledSurface& label, std::uint64_t faces, const std::string& target,
                std::ostream& out) {
  out << std::setw(8) << label.label << std::setw(14) << label.voxels << std::setw(12) << faces
      << "  " << target << '\n';
}

}  // namespace

int extract_label_meshes(const ExtractArguments& arguments) {
  const FilePattern pattern(arguments.output);
  const LabelTable given = label_table_of(arguments);
  std::unique_ptr<VolumeReader> volume = open_measured(arguments.volume, arguments.reading, true);
  if (auto mask = open_noted_mask(arguments.reading, volume->info()))
    volume = masked(arguments.volume, std::move(volume), std::move(mask));
  const VolumeInfo& info = volume->info();
  const LabelTable& table = given.empty() ? info.labels : given;
  const auto placement = mesh_placement(arguments.volume, info.placement, arguments.space);
  pattern.require_folder();
  LabelledSurfaces labels = surfaces_of(*volume, arguments);
  note_not_numbers(arguments, labels.not_numbers);
  if (labels.all.empty() && !arguments.reading.allows_empty)
    throw std::runtime_error(arguments.volume + ": it holds no label" +
                             why_none(arguments, labels.not_numbers) +
                             "; --allow-empty takes that");

  std::vector<NamedSelection> selections;
  for (const LabelledSurface& each : labels.all) {
    const auto value = static_cast<double>(each.label);
    selections.push_back({Selection(value, value), std::to_string(each.label)});
    describe(selections.back(), table);
  }
  const bool is_shared = shares_file(arguments);
  const std::vector<std::string> files = files_for(pattern, selections);
  if (!arguments.quiet)
    std::cout << "   label        voxels       faces  " << (is_shared ? "name" : "file") << '\n';
  std::vector<Mesh> parts;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const LabelledSurface& label = labels.all[i];
    Surface& surface = labels.all[i].surface;
    keep_chosen(arguments.volume + ": " + title(label, selections[i]), arguments.components,
                surface);
    if (surface.polygons.empty() && !arguments.reading.allows_empty) {
      std::cerr << "discmc: " << arguments.volume << ": " << title(label, selections[i])
                << " has no surface left, so "
                << (is_shared ? "it is not in " + files[i] : files[i] + " is not written") << '\n';
      continue;
    }
    const SurfaceOutput output{surface, selections[i], files[i]};
    if (is_shared) {
      parts.push_back(part_of(arguments, output, placement));
      surface = {};  // its memory is the next part's
      if (!arguments.quiet)
        write_line(label, parts.back().face_count(), parts.back().name, std::cout);
    } else {
      const MeshSummary mesh = write_mesh_of(arguments, output, placement);
      if (!arguments.quiet) write_line(label, mesh.face_count, files[i], std::cout);
    }
  }
  if (is_shared) {
    if (parts.empty() && !arguments.reading.allows_empty)
      throw std::runtime_error(arguments.volume + ": no label has a surface left, so " +
                               arguments.output + " is not written; --allow-empty takes that");
    write_parts(arguments, parts);
    if (!arguments.quiet) write_file(arguments.output, std::cout);
  }
  if (!arguments.quiet) require_written(std::cout);
  return exit_ok;
}

}  // namespace discmc::command

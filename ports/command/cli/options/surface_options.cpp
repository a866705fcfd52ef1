#include "volume_options.hpp"

#include "named_values.hpp"
#include "option_checks.hpp"

namespace discmc::command {

void add_label_options(CLI::App& app, std::string& labels, VolumeArguments& arguments,
                       const std::string& result) {
  app.option_defaults()->group(surface_group);
  CLI::Option* option =
      app.add_option("--labels", labels,
                     "extract a mesh of every value except 0, or of each label in a list of "
                     "numbers or names; " +
                         result)
          ->check(CLI::Validator(
              [](std::string& text) {
                return text.empty() ? std::string("no label is given; give all, or a list")
                                    : std::string();
              },
              ""))
          ->option_text("all|N|NAME,...");
  for (const char* other : {"--iso", "--range", "--label", "--memory", "--capacities"})
    option->excludes(app.get_option(other));
  app.add_option("--label-table", arguments.label_table,
                 "read the names and colours of labels (no colours in .stl). A table of 3D Slicer, "
                 "FreeSurfer, ITK-SNAP or BIDS, or dataset.json of nnU-Net. Default: those in the "
                 "file, as in .seg.nrrd; otherwise 21 colours by number")
      ->option_text("FILE");
}

void check_label_options(const std::string& labels, const VolumeArguments& arguments) {
  if (!arguments.label_table.empty() && labels.empty() && !arguments.selects_labels())
    refuse("--label-table", "names labels, and none is selected; add --label N or --labels all");
  if (!arguments.mask.empty() && !labels.empty() && arguments.median > 0)
    refuse("--mask",
           "cannot be combined with --median and --labels, as the filter would grow labels over "
           "the mask; leave out --median, or give each label by --label");
}

void add_surface_options(CLI::App& app, VolumeArguments& arguments) {
  add_selection_options(app, arguments.selections);
  add_named_option(
      app, "--border", arguments.border,
      NamedValues<Border>{{"closed", Border::closed}, {"open", Border::open}},
      "closed: voxels outside the volume are off; open: the surface ends at the outermost voxels");
  app.add_option("--median", arguments.median, "remove noise (majority of 3x3x3 voxels)")
      ->check(CLI::IsMember({3}))
      ->option_text("3");
  app.add_option("--mask", arguments.mask,
                 "a volume with a header and the same extents. A voxel is off if its mask is 0. "
                 "--crop and --shrink apply to the mask, too")
      ->check(CLI::Validator(
          [](std::string& text) {
            return text == "-"
                       ? std::string("a mask cannot be read from standard input; name a file")
                       : std::string();
          },
          ""))
      ->option_text("FILE");
  app.add_flag("--allow-empty", arguments.allows_empty, "succeed even if the surface is empty");
  CLI::Option* memory = add_memory_option(
      app, arguments.memory,
      "bytes of the extractor's memory, with K or M for 1024 and 1024^2 (default: as many as the "
      "surface needs)");
  app.add_option("--capacities", arguments.capacities,
                 "slots, and holes that wait in them, of the extractor, instead of --memory "
                 "(docs/memory.md)")
      ->delimiter(',')
      ->expected(2)
      ->option_text("SLOTS,HOLES")
      ->excludes(memory);
}

}  // namespace discmc::command

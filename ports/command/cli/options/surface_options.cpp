#include "surface_options.hpp"

#include "named_values.hpp"
#include "option_checks.hpp"
#include "selection_options.hpp"

namespace discmc::command {

void add_labels_option(CLI::App& app, std::string& labels, const std::string& result) {
  app.option_defaults()->group(surface_group);
  CLI::Option* option =
      app.add_option("--labels", labels,
                     "a surface of every value but 0, or of each label in a list, by numbers or "
                     "names: " +
                         result)
          ->check(CLI::Validator(
              [](std::string& text) {
                return text.empty() ? std::string("no label is given: give all, or a list")
                                    : std::string();
              },
              ""))
          ->option_text("all|N|NAME,...");
  for (const char* other : {"--iso", "--range", "--label", "--memory", "--capacities"})
    option->excludes(app.get_option(other));
}

void add_label_table_option(CLI::App& app, std::string& file) {
  app.option_defaults()->group(surface_group);
  app.add_option("--label-table", file,
                 "the names of labels, which {name} stands for, and their colours (not in .stl): a "
                 "table of 3D Slicer, FreeSurfer, ITK-SNAP or BIDS, or dataset.json of nnU-Net "
                 "(default: what the file has, as a .seg.nrrd of 3D Slicer; else 21 colours by "
                 "number)")
      ->option_text("FILE");
}

void add_surface_options(CLI::App& app, VolumeArguments& arguments) {
  add_selection_options(app, arguments.selections);
  add_named_option(
      app, "--border", arguments.border,
      NamedValues<Border>{{"closed", Border::closed}, {"open", Border::open}},
      "closed: with off voxels all around; open: the surface ends at the outermost voxels");
  app.add_option("--median", arguments.median,
                 "filter the bits: a voxel is on where most of the N x N x N around it are; noise "
                 "goes")
      ->check(CLI::IsMember({3}))
      ->option_text("3");
  app.add_option("--mask", arguments.mask,
                 "file of a volume with a header and the same extents: a voxel is off where it is "
                 "0, whatever else is said; --crop and --shrink take the same of it")
      ->check(CLI::Validator(
          [](std::string& text) {
            return text == "-" ? std::string("a mask is not read from standard input: name a file")
                               : std::string();
          },
          ""))
      ->option_text("FILE");
  app.add_flag("--allow-empty", arguments.allows_empty,
               "take a surface without polygons for no failure");
  CLI::Option* memory = add_memory_option(
      app, arguments.memory,
      "bytes that the extractor has, with K or M for 1024 and 1024^2 (default: plenty)");
  app.add_option("--capacities", arguments.capacities,
                 "records and holes that the extractor has room for, in place of --memory")
      ->delimiter(',')
      ->expected(2)
      ->option_text("SLOTS,HOLES")
      ->excludes(memory);
}

}  // namespace discmc::command

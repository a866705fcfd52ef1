#include "surface_options.hpp"

#include "named_values.hpp"
#include "option_checks.hpp"

namespace discmc::host {

void add_surface_options(CLI::App& app, VolumeArguments& arguments) {
  app.option_defaults()->group(surface_group);
  app.add_option("--iso", arguments.isos,
                 "the threshold, in the units of the file: a voxel is on if its value is >= ISO")
      ->check(finite())
      ->expected(1)
      ->option_text("ISO");
  add_named_option(
      app, "--border", arguments.border,
      NamedValues<Border>{{"closed", Border::closed}, {"open", Border::open}},
      "closed: with off voxels all around; open: the surface ends at the outermost voxels");
  CLI::Option* memory = add_memory_option(
      app, arguments.memory,
      "bytes that the extractor has, with K or M for 1024 and 1024^2 (default: plenty)");
  app.add_option("--capacities", arguments.capacities,
                 "records and holes that the extractor has room for, in place of --memory")
      ->delimiter(',')
      ->expected(2)
      ->option_text("RECORDS,HOLES")
      ->excludes(memory);
}

}  // namespace discmc::host

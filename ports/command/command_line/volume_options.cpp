#include "volume_options.hpp"

#include <iterator>

#include "named_values.hpp"
#include "option_checks.hpp"
#include "volumes/volume.hpp"

namespace discmc::host {

void add_layout_options(CLI::App& app, LayoutArguments& arguments) {
  app.option_defaults()->group(volume_group);
  CLI::Option* dims =
      app.add_option("--dims", arguments.dims, "extents of a headerless file, in voxels")
          ->delimiter(',')
          ->expected(3)
          ->option_text("X,Y,Z");
  CLI::Option* type = add_named_option(
      app, "--type", arguments.type,
      NamedValues<SampleType>(std::begin(sample_types), std::end(sample_types)),
      "samples of a headerless file: whole numbers without or with sign, or floating point");
  dims->needs(type);
  type->needs(dims);
  app.add_flag("--big-endian", arguments.big_endian,
               "a headerless file has the high byte of a sample first")
      ->needs(dims);
}

void add_volume_options(CLI::App& app, LayoutArguments& arguments) {
  add_layout_options(app, arguments);
  app.add_option("--spacing", arguments.spacing,
                 "distances of voxels in a headerless file, in millimetres")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z")
      ->default_str("1,1,1")
      ->check(usable_spacing())
      ->needs("--dims");
}

}  // namespace discmc::host

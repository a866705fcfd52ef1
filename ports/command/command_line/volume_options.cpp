#include "volume_options.hpp"

#include <iterator>

#include "named_values.hpp"
#include "option_checks.hpp"
#include "volumes/volume.hpp"

namespace discmc::host {

void add_volume_options(CLI::App& app, LayoutArguments& arguments) {
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
  app.add_option("--skip-bytes", arguments.skipped_bytes,
                 "what stands before the samples of a headerless file")
      ->option_text("N")
      ->needs(dims);
  app.add_option("--frame", arguments.frame,
                 "the volume to read of a file that holds several (4D), the first is 0")
      ->option_text("N");
  app.add_option("--spacing", arguments.spacing,
                 "distances of voxels in millimetres, in place of those of the file (default: "
                 "those of the file, or 1 where it tells none)")
      ->delimiter(',')
      ->expected(3)
      ->option_text("X,Y,Z")
      ->check(usable_spacing());
  app.add_option("--series", arguments.series,
                 "of a folder of DICOM with several: its UID, or its number in the list that is "
                 "shown without this")
      ->option_text("SERIES");
}

}  // namespace discmc::host

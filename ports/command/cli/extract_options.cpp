// The arguments of discmc extract.
#include <memory>

#include "cli/options/input_kind.hpp"
#include "cli/options/mesh_options.hpp"
#include "cli/options/named_values.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"
#include "files/file_pattern.hpp"
#include "mesh_files/file_format.hpp"
#include "text/number_text.hpp"

namespace discmc::command {
namespace {

constexpr unsigned max_jobs = 1024;

// Whether a file of this name holds at most one mesh.
bool is_one_mesh(const std::string& output) {
  return !FilePattern(output).has_name() && format_of(output) != Format::stream &&
         !traits_of(format_of(output)).holds_several;
}

void check_labels(const ExtractArguments& arguments) {
  if (is_one_mesh(arguments.output))
    refuse("--labels", "every label becomes a mesh of its own; give -o 'FOLDER/{name}.stl', or a " +
                           extensions(&FormatTraits::holds_several) +
                           " name, whose file holds all");
  if (format_of(arguments.output) == Format::stream)
    refuse("--labels", "a stream holds " + std::to_string(StreamHeader::max_surfaces) +
                           " surfaces at most; write meshes, or give --label");
  const bool is_smooth = arguments.reading.smooth_mm.has_value();
  if (arguments.surface == SurfaceKind::relaxed)
    refuse("--labels",
           "cannot be combined with --surface relaxed, as labels would not share their walls; add "
           "--smooth auto in its place");
  if (arguments.normals == Normals::gradient || (arguments.interpolates() && !is_smooth))
    refuse("--labels",
           "cannot be combined with --normals gradient, or with --surface interpolated without "
           "--smooth; leave one out, or add --smooth auto");
}

void check_selections(const ExtractArguments& arguments) {
  if (!arguments.labels.empty()) return check_labels(arguments);
  const std::vector<NamedSelection>& selections = arguments.reading.selections;
  const std::size_t surfaces = selections.size();
  if (surfaces == 0)
    refuse("--iso",
           "no threshold is given; add --iso auto, --iso ISO, --range LOW..HIGH, --label N or "
           "--labels all");
  const bool is_stream = format_of(arguments.output) == Format::stream;
  if (is_stream && surfaces > StreamHeader::max_surfaces)
    refuse("--iso", std::to_string(surfaces) + " surfaces are too many for a stream; give " +
                        std::to_string(StreamHeader::max_surfaces) + " at most");
  if (surfaces > 1 && is_one_mesh(arguments.output))
    refuse("--output",
           "every surface becomes a mesh of its own; put {name} in the name, as in -o "
           "'surface-{name}.stl', or give a " +
               extensions(&FormatTraits::holds_several) + " name, whose file holds all");
  for (const NamedSelection& each : selections)
    if (each.has_upper_end() && arguments.normals == Normals::gradient)
      refuse("--normals",
             "gradient normals need a threshold by --iso, not a range or label; give --normals "
             "surface");
}

void check_cleaning(const ExtractArguments& arguments) {
  check_closed(arguments.components, arguments.reading.border);
  const bool is_stream = format_of(arguments.output) == Format::stream;
  if (arguments.reading.median > 0 && is_stream && arguments.normals == Normals::gradient)
    refuse("--median",
           "cannot be combined with --normals gradient in a stream, as the samples are not "
           "filtered; leave one out");
}

void check_mask(const ExtractArguments& arguments) {
  if (!arguments.reading.mask.empty() && arguments.normals == Normals::gradient)
    refuse("--mask",
           "cannot be combined with --normals gradient, as the samples have no gradient at the "
           "edge of the mask; give --normals surface, or leave one out");
}

void check_smoothing(const ExtractArguments& arguments) {
  if (!arguments.reading.smooth_mm) return;
  if (arguments.reading.selections.size() > 1)
    refuse("--smooth", "accepts one surface, or --labels; run discmc once per surface");
  if (arguments.normals == Normals::gradient)
    refuse("--smooth",
           "cannot be combined with --normals gradient, as the samples are not smoothed; give "
           "--normals surface");
  if (arguments.reading.median > 0)
    refuse("--smooth", "cannot be combined with --median; leave one out");
  if (arguments.surface == SurfaceKind::relaxed)
    refuse("--smooth", "cannot be combined with --surface relaxed; leave one out");
  if (!arguments.interpolates())
    refuse("--smooth",
           "has no effect on merged polygons, whose vertices lie halfway between voxels; write a "
           "mesh of triangles, without --surface merged and --no-conforming");
}

void check_bodies(const ExtractArguments& arguments) {
  if (!arguments.lists_bodies) return;
  if (!traits_of(format_of(arguments.output)).holds_measures)
    refuse("--bodies", "holds measures only in .csv and .json; write one of them, or leave it out");
  if (arguments.reading.border == Border::open)
    refuse("--border", "an open surface encloses no bodies; leave out --bodies, or --border open");
}

void check_closing(const ExtractArguments& arguments) {
  if (arguments.reading.close_mm == 0) return;
  if (arguments.reading.selections.size() > 1 || !arguments.labels.empty())
    refuse("--close",
           "accepts one surface, as closed labels would overlap; run discmc once per surface");
  if (arguments.normals == Normals::gradient)
    refuse("--close",
           "cannot be combined with --normals gradient, as a closed gap has no samples; give "
           "--normals surface");
  if (arguments.reading.median > 0)
    refuse("--close", "cannot be combined with --median; leave one out");
  if (arguments.interpolates() && !arguments.reading.smooth_mm)
    refuse("--close",
           "a closed gap has no samples to interpolate; leave out --surface interpolated, or add "
           "--smooth auto");
}

void check_surface(const ExtractArguments& arguments) {
  check_surface_kind(arguments.surface, arguments.mesh, arguments.output);
  if (!arguments.interpolates()) return;
  if (arguments.reading.median > 0)
    refuse("--median",
           "cannot be combined with --surface interpolated, as the samples are not filtered; leave "
           "one out");
  if (arguments.reading.selects_labels() && !arguments.reading.smooth_mm)
    refuse("--surface", "labels have no values to interpolate; add --smooth auto");
}

void check_output(const std::string& output) {
  const std::string unknown = FilePattern(output).unknown_placeholder();
  if (!unknown.empty())
    refuse(
        "--output",
        unknown + " is an unknown placeholder; only {name} is supported, the name of the surface");
}

void check_wire(const ExtractArguments& arguments) {
  const bool is_of_slices = arguments.wire == Wire::slices;
  if (is_of_slices && format_of(arguments.output) != Format::stream)
    refuse("--wire", "slices are written to a stream; give -o FILE.dmc");
  if (is_of_slices && arguments.normals != Normals::none)
    refuse("--wire", "a stream of slices holds no normals; leave out --normals");
  if (is_of_slices && (arguments.reading.memory > 0 || !arguments.reading.capacities.empty()))
    refuse("--wire", "the memory of a slice encoder is fixed; leave out --memory and --capacities");
  if (!is_of_slices && arguments.levels > 0)
    refuse("--levels", "applies to streams of slices; add --wire slices");
  if (!is_of_slices && arguments.key_slices > 0)
    refuse("--key-slices", "applies to streams of slices; add --wire slices");
}

// Fractions need samples that only a threshold divides.
void check_levels(const ExtractArguments& arguments) {
  if (arguments.levels == 0) return;
  const VolumeArguments& reading = arguments.reading;
  const auto refuse_with = [](const std::string& option) {
    refuse("--levels", "cannot be combined with " + option +
                           ", as the surface is then not that of the samples; leave one out");
  };
  if (reading.median > 0) refuse_with("--median");
  if (reading.close_mm > 0) refuse_with("--close");
  if (reading.smooth_mm) refuse_with("--smooth");
  if (!reading.mask.empty()) refuse_with("--mask");
  for (const NamedSelection& each : reading.selections)
    if (each.has_upper_end()) refuse_with("--range or --label");
}

void check_slab(const ExtractArguments& arguments) {
  if (!arguments.slab) return;
  if (format_of(arguments.output) != Format::stream || arguments.wire == Wire::slices)
    refuse("--slab",
           "writes a stream of regions for discmc join; give -o FILE.dmc, without --wire slices");
  if (arguments.reading.selections.size() > 1)
    refuse("--slab",
           "discmc join accepts one surface per stream; give one --iso, --range or --label, and "
           "run discmc once per surface");
  if (arguments.normals == Normals::gradient)
    refuse("--slab",
           "cannot be combined with --normals gradient, as a slab lacks the slices beside it; "
           "leave out --normals, and give discmc decode --normals gradient --volume FILE");
}

void check_jobs(const ExtractArguments& arguments) {
  if (!arguments.jobs) return;
  if (arguments.reading.memory > 0 || !arguments.reading.capacities.empty())
    refuse("--jobs", "cannot be combined with --memory or --capacities; leave one out");
  if (format_of(arguments.output) == Format::stream && arguments.normals == Normals::gradient)
    refuse("--jobs",
           "cannot be combined with --normals gradient in a stream, whose normals need samples "
           "beside each part; leave one out");
}

// Vertices of a smoothed or decimated surface follow the interpolated surface, if there is one and
// the mesh can hold it. A decimated surface chooses among all crossings.
void choose_surface(ExtractArguments& arguments, const CLI::App& app) {
  const Format format = format_of(arguments.output);
  const bool is_triangles = arguments.mesh.faces == Faces::triangles &&
                            arguments.mesh.is_conforming && format != Format::stream &&
                            format != Format::jsonl;
  const bool is_decimated = arguments.decimation.is_wanted();
  const bool has_samples = arguments.reading.median == 0 && arguments.reading.close_mm == 0 &&
                           arguments.labels.empty() && !arguments.reading.selects_labels();
  const bool is_followed = arguments.reading.smooth_mm || (is_decimated && has_samples);
  if (is_followed && is_triangles && app.get_option("--surface")->count() == 0)
    arguments.surface = SurfaceKind::interpolated;
  if (is_decimated && app.get_option("--tolerance")->count() == 0) arguments.mesh.tolerance = 0;
}

void check(const ExtractArguments& arguments, const CLI::App& app) {
  check_output(arguments.output);
  check_faces(arguments.mesh.faces, arguments.output);
  check_components(arguments.components, arguments.output);
  check_bodies(arguments);
  check_cleaning(arguments);
  check_mask(arguments);
  check_label_options(arguments.labels, arguments.reading);
  check_space(arguments.space, arguments.output);
  check_size(arguments.size, arguments.output);
  check_normals(arguments.normals, arguments.output, true);
  check_selections(arguments);
  check_closing(arguments);
  check_smoothing(arguments);
  check_surface(arguments);
  check_decimation(arguments.decimation, arguments.mesh, arguments.output);
  check_tolerance(arguments.surface, app);
  check_wire(arguments);
  check_levels(arguments);
  check_slab(arguments);
  check_jobs(arguments);
}

// Parses "2/7". Throws if the text has another form.
SlabChoice slab_choice(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto number = whole_number<std::uint32_t>(text.substr(0, slash));
  const auto count = slash == std::string::npos
                         ? std::nullopt
                         : whole_number<std::uint32_t>(text.substr(slash + 1));
  if (!number || !count || *number == 0 || *number > *count)
    refuse("--slab", "invalid slab '" + text + "'; expected its number and their count, as in 2/7");
  return {*number, *count};
}

// Returns nothing if the text is neither "auto" nor a length.
std::optional<double> deviation(const std::string& text) {
  if (text == "auto") return 0;
  const auto length = finite_number(text);
  return length && *length >= 1e-6 && *length <= 1000 ? length : std::nullopt;
}

void add_smoothing_option(CLI::App& app, ExtractArguments& arguments) {
  app.option_defaults()->group(surface_group);
  app.add_option_function<std::string>(
         "--smooth",
         [&arguments](const std::string& text) { arguments.reading.smooth_mm = deviation(text); },
         "smooth the voxel steps of a mask or label by a Gaussian with a standard deviation of MM "
         "millimetres, keeping the volume of each body; auto: 1.5 voxels, or the largest distance "
         "between voxels if the distances differ")
      ->check(CLI::Validator(
          [](std::string& text) {
            return deviation(text) ? std::string()
                                   : "invalid deviation '" + text +
                                         "'; expected auto, or 1e-6 to 1000 millimetres";
          },
          ""))
      ->option_text("auto|MM");
}

void add_closing_option(CLI::App& app, ExtractArguments& arguments) {
  app.option_defaults()->group(surface_group);
  app.add_option("--close", arguments.reading.close_mm,
                 "close gaps between voxels that are on: dilate the voxels by MM millimetres, then "
                 "erode them")
      ->check(accepted([](double length) { return length > 0 && length <= 1000; },
                       "millimetres above 0 and up to 1000"))
      ->option_text("MM");
}

// Adds the options of streams.
void add_wire_options(CLI::App& app, ExtractArguments& arguments) {
  app.option_defaults()->group(stream_group);
  add_named_option(
      app, "--wire", arguments.wire,
      NamedValues<Wire>{{"regions", Wire::regions}, {"slices", Wire::slices}},
      "the kind of .dmc stream; regions: merged polygons, final as they arrive; slices: "
      "the thresholded voxels, in a tenth of the bytes");
  app.add_option("--key-slices", arguments.key_slices,
                 "with --wire slices: make every Nth slice a key slice that decodes alone, for "
                 "links that lose packets (default: the first slice only)")
      ->check(CLI::Range(std::uint32_t{1}, Limits::max_slices))
      ->option_text("N");
  add_named_option(
      app, "--levels", arguments.levels,
      NamedValues<std::uint8_t>{
          {"0", std::uint8_t{0}}, {"2", std::uint8_t{2}}, {"4", std::uint8_t{4}}},
      "with --wire slices: also send in which half (2) or quarter (4) of an edge between voxels "
      "the samples cross the threshold, for --surface interpolated");
  app.add_option("--scan", arguments.scan,
                 "number of the scan, which distinguishes streams on one link")
      ->option_text("N")
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--slab", [&arguments](const std::string& text) { arguments.slab = slab_choice(text); },
         "extract slab K of N along z, as a .dmc stream; discmc join joins all slabs")
      ->option_text("K/N");
}

}  // namespace

Command add_extract(CLI::App& app) {
  const auto arguments = std::make_shared<ExtractArguments>();
  CLI::App* extract =
      app.add_subcommand("extract", "Extract the surface of a volume as a mesh or a stream");
  extract
      ->add_option("VOLUME", arguments->volume,
                   "the volume. A file of NRRD, NIfTI, Analyze, MetaImage, MGH, MRC, VTK, NumPy, "
                   "HDF5 or InVesalius. A file or folder of DICOM or Zarr. A file, folder or "
                   "'pattern' of PNG, TIFF, JPEG or BMP slices, or of masks, one per label. A "
                   "headerless file with --dims and --type. - reads standard input")
      ->required();
  add_output_option(*extract, arguments->output, "the stream on standard output (default)");
  add_format_option(*extract, arguments->format);
  extract->add_flag("-q,--quiet", arguments->is_quiet, "do not print the table of results");
  add_volume_options(*extract, arguments->reading.options);
  add_surface_options(*extract, arguments->reading);
  for (const char* option : {"--iso", "--range", "--label"})
    extract->get_option(option)->expected(1, -1)->allow_extra_args(false);
  CLI::Option* iso = extract->get_option("--iso");
  iso->description(iso->get_description() +
                   ". Repeat --iso, --range or --label for more surfaces; a stream holds up to 4");
  add_closing_option(*extract, *arguments);
  add_smoothing_option(*extract, *arguments);
  add_label_options(*extract, arguments->labels, arguments->reading,
                    "-o with {name} writes a file per label; one " +
                        extensions(&FormatTraits::holds_several) + " file holds all");
  add_normals_option(*extract, arguments->normals,
                     "from the samples of the volume; also in a .dmc stream");
  extract
      ->add_option("-j,--jobs", arguments->jobs,
                   "work on N parts of the volume, or N labels, at once (default: for a mesh, the "
                   "number of cores; for a stream, one core). The mesh is the same for every N")
      ->check(CLI::Range(1U, max_jobs))
      ->option_text("N");
  add_mesh_options(*extract, arguments->mesh);
  add_component_options(*extract, arguments->components);
  extract->add_flag("--bodies", arguments->lists_bodies,
                    "write the measures of each body, with its cavities, the largest first");
  add_space_option(*extract, arguments->space);
  add_size_options(*extract, arguments->size);
  add_surface_kind_options(
      *extract, arguments->surface, arguments->mesh.tolerance,
      ", the default with --smooth, and of samples with --triangles or --max-error");
  add_decimation_options(*extract, arguments->decimation);
  add_wire_options(*extract, *arguments);
  extract->footer(
      "Examples:\n"
      "  discmc extract head.nii.gz --iso 300 -o head.stl\n"
      "  discmc extract head.nii.gz --iso 300 --iso=-300 -o 'head-{name}.stl'\n"
      "  discmc extract labels.nii.gz --labels all -o 'out/{name}.stl'\n"
      "  discmc extract series/ --iso 300 -o head.stl\n"
      "  discmc extract head.nii.gz --iso 300 --wire slices --levels 4 -o head.dmc\n"
      "  discmc extract ct.raw --dims 512,512,275 --type i16 --iso 200 -o ct.dmc");
  extract->allow_extras();
  extract->callback([arguments, extract] {
    add_other_files(*extract, arguments->reading.options);
    add_format_to_name(arguments->format, arguments->output);
    choose_surface(*arguments, *extract);
    check(*arguments, *extract);
  });
  return {extract, [arguments] { return run_extract(*arguments); }};
}

}  // namespace discmc::command

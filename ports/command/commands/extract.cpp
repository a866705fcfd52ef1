// discmc extract: a volume to a stream or a mesh.
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <discmc/shared_output.hpp>
#include <discmc/slice_encoder.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "extraction/extraction.hpp"
#include "mesh_output.hpp"
#include "meshes/vertex_normals.hpp"
#include "output_file.hpp"
#include "progress.hpp"
#include "require.hpp"
#include "summary.hpp"
#include "surface/counts.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"
#include "volume_input.hpp"

namespace discmc::host {
namespace {

// Gives every event to the encoder and, joined, to the surface.
struct Tee {
  NormalEncoder encoder;
  SurfaceBuilder builder;
  GrowingJoiner joiner{sink_to(builder)};
  Answer take(const Event& event) {
    if (encoder.take(event) != Answer::taken) return Answer::not_now;
    return joiner.take(event);
  }
};

// Tells the bits of a volume, in memory of its own.
class SliceWriter {
 public:
  void start(const StreamHeader& header, KeySlices key_slices, const ByteOutput& output) {
    memory_.resize(
        slice_encoder_bytes({header.width, header.height}, key_slices, header.surfaces()));
    require(encoder_.start(header, key_slices, {memory_.data(), memory_.size()}, output));
  }
  SliceEncoder& encoder() { return encoder_; }
  /// Units: bytes; 0 before a start.
  std::size_t memory() const { return memory_.size(); }

 private:
  std::vector<std::uint8_t> memory_;
  SliceEncoder encoder_;
};

// Samples that are narrowed for the gradient are counted from one iso value.
void require_one_surface(const VolumeArguments& arguments, const VolumeInfo& info) {
  if (arguments.isos.size() > 1)
    throw std::invalid_argument(
        "--normals gradient of several surfaces takes samples of u8, u16 "
        "or i16, and these are " +
        std::string(name(info.type)) + ": give one --iso");
}

void add_normals(const ExtractArguments& arguments, const Surface& surface, Mesh& mesh) {
  if (arguments.normals == Normals::none) return;
  set_polygon_normals(surface, mesh);
  if (arguments.normals == Normals::surface) return;
  const auto again = open_for_gradient(arguments.volume, raw_layout(arguments.reading.layout),
                                       arguments.reading.isos[0]);
  add_gradient_normals(*again.reader, mesh);
}

// The surfaces of a volume on their way to streams, and joined for the table or a mesh.
class Surfaces {
 public:
  Surfaces(const VolumeInfo& info, const std::vector<Selection>& selections)
      : selections_(selections) {
    for (const Selection& selection : selections) {
      thresholds_.push_back(stored_threshold(info, selection.low));
      tees_.push_back(std::make_unique<Tee>());
    }
  }

  /// Begins a stream of regions for each.
  void start(StreamLabel label, const ByteOutput& output) {
    link_.start(output);
    for (std::size_t i = 0; i < tees_.size(); ++i) {
      label.channel = static_cast<std::uint8_t>(i);
      require(tees_[i]->encoder.start(label, link_.output()));
    }
  }
  /// The header of a stream of slices that holds all of them. header: that of the first.
  StreamHeader header_of_all(StreamHeader header) const {
    header.further_surfaces = static_cast<std::uint8_t>(thresholds_.size() - 1);
    std::copy(thresholds_.begin() + 1, thresholds_.end(), header.further_thresholds);
    return header;
  }
  std::vector<SurfaceRequest> requests() {
    std::vector<SurfaceRequest> requests;
    for (std::size_t i = 0; i < tees_.size(); ++i)
      requests.push_back({selections_[i], sink_to(*tees_[i])});
    return requests;
  }

  std::size_t count() const { return tees_.size(); }
  Tee& operator[](std::size_t surface) { return *tees_[surface]; }

 private:
  std::vector<Selection> selections_;
  std::vector<std::int32_t> thresholds_;
  std::vector<std::unique_ptr<Tee>> tees_;
  SharedOutput link_;
};

}  // namespace

int run_extract(const ExtractArguments& arguments) {
  const Format format = format_of(arguments.output);
  if (arguments.output == "-" && isatty(STDOUT_FILENO) == 1)
    throw std::invalid_argument("a stream is not written to a terminal: give -o FILE, or a pipe");
  auto volume = open_noted_volume(arguments.volume, arguments.reading);
  const VolumeInfo info = volume->info();
  OutputFile file(arguments.output);
  StreamOutput output(format == Format::stream ? &file.stream() : nullptr);
  Progress progress("extracting", info.dims[2]);
  ExtractionOptions options = extraction_options(arguments.reading, progress);
  StreamHeader header = stream_header(info, options);
  header.scan = arguments.scan;
  std::vector<Selection> selections(arguments.reading.isos.begin(), arguments.reading.isos.end());
  options.normals = format == Format::stream && arguments.normals == Normals::gradient;
  if (options.normals && !is_scanner_type(info.type)) {
    require_one_surface(arguments.reading, info);
    GradientVolume narrow = open_for_gradient(
        arguments.volume, raw_layout(arguments.reading.layout), arguments.reading.isos[0]);
    volume = std::move(narrow.reader);
    selections = {narrow.selection};
  }
  Surfaces surfaces(info, selections);
  const bool tells_slices = format == Format::stream && arguments.wire == Wire::slices;
  StreamOutput no_output(nullptr);
  surfaces.start(header.label(), (tells_slices ? no_output : output).byte_output());
  SliceWriter slices;
  if (tells_slices) {
    slices.start(surfaces.header_of_all(header), {arguments.key_slices}, output.byte_output());
    options.slices = &slices.encoder();
  }
  const std::vector<Extraction> extractions = extract(*volume, options, surfaces.requests());
  if (format != Format::stream) {
    Surface& surface = surfaces[0].builder.surface();
    surface.spacing_mm = info.spacing_mm;
    write_surface(
        surface, format, arguments.mesh,
        [&](Mesh& mesh) {
          note_left_out(arguments.volume, surface, mesh);
          add_normals(arguments, surface, mesh);
        },
        file);
  }
  file.commit();
  if (extractions[0].not_numbers > 0)
    std::cerr << "discmc: " << arguments.volume << ": " << extractions[0].not_numbers
              << " samples are not a number (NaN), and taken as off\n";
  if (arguments.quiet) return exit_ok;
  std::ostream& out = arguments.output == "-" ? std::cerr : std::cout;
  for (std::size_t i = 0; i < surfaces.count(); ++i) {
    if (surfaces.count() > 1)
      out << "channel " << i << ", at " << arguments.reading.isos[i] << '\n';
    write_table(extractions[i], count(surfaces[i].builder.surface()),
                tells_slices ? output.bytes() : surfaces[i].encoder.bytes(), slices.memory(), out);
  }
  require_written(out);
  return exit_ok;
}

}  // namespace discmc::host

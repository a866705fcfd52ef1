// discmc extract -o FILE.dmc: a volume to a stream of its surfaces, or of its slices.
#include <algorithm>
#include <cstdint>
#include <discmc/byte_output.hpp>
#include <discmc/slice_encoder.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "exit_codes.hpp"
#include "extract.hpp"
#include "files/output_file.hpp"
#include "files/require_written.hpp"
#include "progress.hpp"
#include "samples/iso_value.hpp"
#include "streams/stream_output.hpp"
#include "summary.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

// Encodes the bits of a volume, in memory of its own.
class SliceWriter {
 public:
  void start(const SliceEncoderConfig& config, const ByteOutput& output) {
    memory_.resize(SliceEncoder::minimum_bytes(config));
    require(encoder_.start(config, {memory_.data(), memory_.size()}, output));
  }
  SliceEncoder& encoder() { return encoder_; }
  /// Units: bytes; 0 before a start.
  std::size_t memory() const { return memory_.size(); }

 private:
  std::vector<std::uint8_t> memory_;
  SliceEncoder encoder_;
};

// The header of a stream of slices that holds all surfaces. header: what they share.
SliceEncoderConfig config_of_all(const StreamHeader& header, std::uint32_t key_slice_interval,
                                 const VolumeInfo& info,
                                 const std::vector<NamedSelection>& selections) {
  SliceEncoderConfig config{{header.width, header.height, header.border},
                            {},
                            key_slice_interval,
                            static_cast<std::uint8_t>(selections.size()),
                            header.label()};
  std::transform(selections.begin(), selections.end(), config.thresholds,
                 [&info](const NamedSelection& surface) {
                   return stored_threshold(info, surface.selection.low);
                 });
  return config;
}

// No two slabs differ by more than a slice.
std::optional<SlabRange> slab_of(const ExtractArguments& arguments, std::uint32_t depth) {
  if (!arguments.slab || arguments.slab->count == 1) return std::nullopt;
  const auto [number, count] = *arguments.slab;
  if (count > depth)
    throw std::invalid_argument("--slab " + std::to_string(number) + "/" + std::to_string(count) +
                                ": the volume has " + std::to_string(depth) +
                                " slices; give that many slabs at most");
  const auto end_of = [depth, slabs = count](std::uint32_t slab) {
    return static_cast<std::uint32_t>(std::uint64_t{depth} * slab / slabs);
  };
  return SlabRange{end_of(number - 1), end_of(number) - end_of(number - 1), depth};
}

// Samples that are narrowed for the gradient have one threshold as their zero.
void require_one_surface(const VolumeArguments& arguments, const VolumeInfo& info) {
  if (arguments.selections.size() > 1)
    throw std::invalid_argument(
        "--normals gradient of several surfaces needs samples of u8, u16 or i16, and these are " +
        std::string(name(info.type)) + "; give one --iso, or run discmc once per surface");
}

}  // namespace

ExtractedStream write_stream(ExtractArguments& arguments, std::ostream& out) {
  const auto volume = open_measured(arguments.volume, arguments.reading);
  const VolumeInfo info = volume->info();
  const auto mask = open_noted_mask(arguments.reading, info);
  StreamOutput output(&out);
  Progress progress("extracting", info.dims[2]);
  ExtractionOptions options = extraction_options(arguments.reading, progress, mask.get());
  StreamHeader header = stream_header(info, options);
  const MendedVolume mended(arguments.reading, *volume, options);
  header.scan = arguments.scan;
  std::vector<NamedSelection> selections = arguments.reading.selections;
  if (mended.is_changed()) selections[0].selection = options.selection;
  options.slab = slab_of(arguments, info.dims[2]);
  options.normals = arguments.normals == Normals::gradient;
  options.jobs = arguments.jobs;
  // A slab in parts is faster to join.
  if (options.slab && is_divisible(arguments)) options.jobs = arguments.jobs.value_or(1);
  options.measures_memory = !arguments.quiet && !options.jobs;
  std::unique_ptr<SliceReader> narrow;
  if (options.normals && !is_scanner_type(info.type)) {
    require_one_surface(arguments.reading, info);
    narrow = narrowed_again(arguments.volume, arguments.reading.options,
                            selections[0].selection.low, *volume);
    selections[0].selection = {0};
  }

  ExtractedStream stream;
  stream.receivers =
      receivers_for(selections, arguments.quiet ? std::nullopt : std::optional(Kept::counts));
  SliceWriter slices;
  SharedOutput link;
  if (arguments.wire == Wire::slices) {
    slices.start(config_of_all(header, arguments.key_slices, info, selections),
                 output.byte_output());
    write_placement(info.placement, slices.encoder());
    options.slices = &slices.encoder();
  } else {
    link.start(output.byte_output());
    StreamLabel label = header.label();
    for (std::size_t i = 0; i < stream.receivers.size(); ++i) {
      label.channel = static_cast<std::uint8_t>(i);
      stream.receivers[i]->start_stream(label, info.placement, options.slab, link.output());
    }
  }

  SliceReader& samples = narrow ? *narrow : mended.samples();
  stream.extractions = extract(samples, options, requests_of(selections, stream.receivers));
  stream.slice_bytes = output.bytes();
  stream.slice_memory = slices.memory();
  note_not_numbers(arguments,
                   mended.is_changed() ? mended.not_numbers() : stream.extractions[0].not_numbers);
  if (!options.slab) check_surfaces(arguments, stream.extractions, *volume);
  return stream;
}

int extract_stream(ExtractArguments arguments) {
  require_no_terminal(arguments.output);
  OutputFile file(arguments.output);
  const ExtractedStream stream = write_stream(arguments, file.stream());
  file.commit();
  if (arguments.quiet) return exit_ok;
  std::ostream& out = table_stream(arguments.output);
  print_file(arguments.output, out);
  for (std::size_t i = 0; i < stream.receivers.size(); ++i) {
    SurfaceReceiver& receiver = *stream.receivers[i];
    if (stream.receivers.size() > 1)
      out << "channel " << i << ", at " << arguments.reading.selections[i].name << '\n';
    print_table(stream.extractions[i], receiver.counts(),
                arguments.wire == Wire::slices ? stream.slice_bytes : receiver.stream_bytes(),
                stream.slice_memory, out);
  }
  require_written(out);
  return exit_ok;
}

}  // namespace discmc::command

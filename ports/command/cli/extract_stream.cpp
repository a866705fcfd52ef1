// discmc extract -o FILE.dmc: converts a volume to a stream of its surfaces or of its slices.
#include <algorithm>
#include <cstdint>
#include <discmc/byte_output.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/slice_encoder.hpp>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "extract.hpp"
#include "extraction/bit_source.hpp"
#include "files/output_file.hpp"
#include "files/write_failure.hpp"
#include "progress.hpp"
#include "samples/iso_value.hpp"
#include "streams/stream_output.hpp"
#include "summary.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

// Encodes the bits or, with levels, the samples of a volume in memory of its own.
class SliceWriter {
 public:
  /// surfaces: of the extraction of the same slices.
  void start(const SliceEncoderConfig& config, const SampleGrid& info, bool filters_by_majority,
             const std::vector<SurfaceRequest>& surfaces, const ByteOutput& output) {
    if (config.levels == 0) {
      start<SliceEncoder>(config, output);
      const std::uint32_t depth = info.dims[2];
      bits_.emplace(info, config.limits, slab_spans({0, depth}, depth, filters_by_majority),
                    filters_by_majority, surfaces);
      return;
    }
    with_scanner_type(info.type, [&](auto sample) {
      using Sample = decltype(sample);
      auto& encoder = start<FractionSliceEncoder<Sample>>(config, output);
      const std::uint32_t count = config.limits.width * config.limits.height;
      push_samples_ = [&encoder, count](const void* slice) {
        require(encoder.push(static_cast<const Sample*>(slice), count).status);
      };
    });
  }
  SliceEncoder& encoder() { return *encoder_; }
  /// mask_rows: null without a mask.
  void add_slice(const void* samples, const std::uint8_t* mask_rows) {
    if (bits_)
      bits_->add_slice(samples, mask_rows, [this](const std::uint8_t* row) { push_bits(row); });
    else
      push_samples_(samples);
  }
  void finish() {
    if (bits_) bits_->finish([this](const std::uint8_t* row) { push_bits(row); });
    require(encoder_->finish());
  }
  /// Units: bytes; 0 before start().
  std::size_t memory() const { return memory_.size(); }

 private:
  template <class EncoderOfSlices>
  EncoderOfSlices& start(const SliceEncoderConfig& config, const ByteOutput& output) {
    memory_.resize(EncoderOfSlices::minimum_bytes(config));
    auto encoder = std::make_shared<EncoderOfSlices>();
    require(encoder->start(config, {memory_.data(), memory_.size()}, output));
    encoder_ = encoder;
    return *encoder;
  }

  void push_bits(const std::uint8_t* row) const { require(encoder_->push_bits(row).status); }

  std::vector<std::uint8_t> memory_;
  std::shared_ptr<SliceEncoder> encoder_;
  std::optional<BitSource> bits_;
  std::function<void(const void*)> push_samples_;
};

// Returns the configuration of a stream of slices with all surfaces. header: what the surfaces
// share.
SliceEncoderConfig config_of_all(const StreamHeader& header, const ExtractArguments& arguments,
                                 const VolumeInfo& info,
                                 const std::vector<NamedSelection>& selections) {
  SliceEncoderConfig config;
  config.limits = {header.width, header.height, header.border};
  config.key_slice_interval = arguments.key_slices;
  config.surface_count = static_cast<std::uint8_t>(selections.size());
  config.label = header.label();
  config.levels = arguments.levels;
  std::transform(selections.begin(), selections.end(), config.thresholds,
                 [&info](const NamedSelection& surface) {
                   return stored_threshold(info, surface.selection.low);
                 });
  return config;
}

// The sizes of two slabs differ by at most one slice.
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

void choose_extraction(const ExtractArguments& arguments, std::uint32_t depth,
                       ExtractionOptions& options) {
  options.slab = slab_of(arguments, depth);
  options.normals = arguments.normals == Normals::gradient;
  options.jobs = arguments.jobs;
  // A slab that is extracted in parts is faster to join.
  if (options.slab && is_divisible(arguments)) options.jobs = arguments.jobs.value_or(1);
  options.measures_memory = !arguments.is_quiet && !options.jobs;
}

// Returns samples of a type that has gradients, with their own selection; null if the volume has
// such samples. Narrowed samples have one threshold as their zero.
std::unique_ptr<SliceReader> narrowed_for_gradient(const ExtractArguments& arguments,
                                                   MeasuredVolume& volume,
                                                   std::vector<NamedSelection>& selections) {
  const SampleType type = volume.info().type;
  if (is_scanner_type(type)) return nullptr;
  if (selections.size() > 1)
    throw std::invalid_argument(
        "--normals gradient of several surfaces needs samples of u8, u16 or i16, and these are " +
        std::string(name(type)) + "; give one --iso, or run discmc once per surface");
  auto narrow = narrowed_again(arguments.volume, arguments.reading.options,
                               selections[0].selection.low, volume);
  selections[0].selection = {0};
  return narrow;
}

void require_encodable(const ExtractArguments& arguments, const VolumeInfo& info) {
  if (arguments.levels > 0 && !is_scanner_type(info.type))
    throw std::invalid_argument("--levels needs samples of u8, u16 or i16, and these are " +
                                std::string(name(info.type)) +
                                "; convert the volume, or leave out --levels");
}

// Starts a stream of regions per surface. Their channels on the link count from that of the label.
void start_regions(StreamLabel label, const std::optional<VolumePlacement>& placement,
                   const std::optional<SlabRange>& slab, const SurfaceReceivers& receivers,
                   const ByteOutput& link) {
  for (const auto& receiver : receivers) {
    receiver->start_stream(label, placement, slab, link);
    ++label.channel;
  }
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
  choose_extraction(arguments, info.dims[2], options);
  const auto narrow =
      options.normals ? narrowed_for_gradient(arguments, *volume, selections) : nullptr;
  SliceReader& samples = narrow ? *narrow : mended.samples();
  ExtractedStream stream;
  stream.receivers =
      receivers_for(selections, arguments.is_quiet ? std::nullopt : std::optional(Kept::counts));
  SliceWriter slices;
  SharedOutput link;
  if (arguments.wire == Wire::slices) {
    require_encodable(arguments, info);
    slices.start(config_of_all(header, arguments, info, selections), samples.info(),
                 options.filters_by_majority, requests_of(selections, stream.receivers),
                 output.byte_output());
    write_placement(info.placement, slices.encoder());
    options.slices = [&slices](const std::uint8_t* slice, const std::uint8_t* mask_rows) {
      slices.add_slice(slice, mask_rows);
    };
  } else {
    link.start(output.byte_output());
    start_regions(header.label(), info.placement, options.slab, stream.receivers, link.output());
  }

  stream.extractions = extract(samples, options, requests_of(selections, stream.receivers));
  if (arguments.wire == Wire::slices) slices.finish();
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
  if (arguments.is_quiet) return exit_ok;
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

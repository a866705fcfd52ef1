// discmc tune: estimates RAM, stream size and CPU time of a device for a volume.
#include <algorithm>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "empty_surface.hpp"
#include "extraction/arena_memory.hpp"
#include "extraction/extractors.hpp"
#include "files/write_failure.hpp"
#include "progress.hpp"
#include "text/number_text.hpp"
#include "tuning/firmware_code.hpp"
#include "tuning/trial.hpp"
#include "tuning/tuning_report.hpp"
#include "volume_input.hpp"

namespace discmc::command {
namespace {

constexpr std::uint32_t key_slice_intervals[] = {16, 1};

// The trials of a volume.
struct Trials {
  Trial plenty;                   // with memory for everything
  std::optional<Trial> no_loose;  // smallest arena without loose fragments
  std::vector<Trial> regions;     // one per size of the arena
  std::size_t chosen = 0;         // index in `regions`
  std::vector<Trial> slices;      // one per key_slice_intervals
};

bool shows(const TuneArguments& arguments, Wire wire) {
  const auto& asked = arguments.wires;
  return asked.empty() || std::find(asked.begin(), asked.end(), wire) != asked.end();
}

std::string bytes_text(std::uint64_t bytes) {
  return grouped(bytes) + " bytes";
}

// Returns the arena of --memory or --capacities. Throws if the device would reject it.
std::optional<std::uint64_t> given_arena(const VolumeArguments& arguments, const Limits& limits) {
  if (!arguments.capacities.empty()) {
    const Capacities capacities{arguments.capacities[0], arguments.capacities[1]};
    if (!detail::sizing::is_valid<std::uint16_t>(capacities))
      throw std::invalid_argument(
          "--capacities " + std::to_string(capacities.slots) + "," +
          std::to_string(capacities.holes) +
          ": invalid number of slots; expected 4 to 32759, the range of 16-bit indices");
    return Extractor16::bytes_for(limits, capacities);
  }
  if (arguments.memory == 0) return std::nullopt;
  const std::uint64_t min_bytes = Extractor16::minimum_bytes(limits);
  if (arguments.memory < min_bytes)
    throw std::invalid_argument(too_little_memory(arguments.memory, limits, min_bytes) +
                                ", or send slices with --wire slices, which need " +
                                std::to_string(SliceEncoder::minimum_bytes({limits, {}, 1})) +
                                " bytes if every slice is a key slice");
  const std::uint64_t max_bytes = max_arena_bytes(limits);
  if (arguments.memory > max_bytes)
    throw std::invalid_argument("--memory " + std::to_string(arguments.memory) +
                                " is too much; give at most " + std::to_string(max_bytes) +
                                " bytes, the range of 16-bit indices");
  return arguments.memory;
}

Trial try_given(const VolumeBits& volume, const VolumeArguments& arguments, std::uint64_t bytes) {
  if (arguments.capacities.empty()) return try_regions(volume, bytes);
  return try_regions<std::uint16_t>(volume, {arguments.capacities[0], arguments.capacities[1]});
}

void try_all_regions(const VolumeBits& volume, const TuneArguments& arguments,
                     std::optional<std::uint64_t> given, Progress& progress, Trials& trials) {
  std::uint64_t done = 0;
  const auto step = [&] { progress.show(++done); };
  const Limits& limits = volume.limits();
  trials.no_loose = min_without_loose_pieces(volume, trials.plenty, step);
  const std::uint64_t max_bytes =
      trials.no_loose ? trials.no_loose->memory : max_arena_bytes(limits);
  for (const std::uint64_t size : arena_sizes(limits, max_bytes)) {
    trials.regions.push_back(try_regions(volume, size));
    step();
  }
  trials.regions.push_back(trials.no_loose ? *trials.no_loose : try_regions(volume, max_bytes));
  const std::uint64_t chosen = given.value_or(max_bytes);
  const auto place = std::lower_bound(
      trials.regions.begin(), trials.regions.end(), chosen,
      [](const Trial& trial, std::uint64_t bytes) { return trial.memory < bytes; });
  trials.chosen = static_cast<std::size_t>(place - trials.regions.begin());
  if (!given) return;
  const Trial trial = try_given(volume, arguments.reading, chosen);
  if (place != trials.regions.end() && place->memory == chosen)
    *place = trial;
  else
    trials.regions.insert(place, trial);
}

Trials try_all(const VolumeBits& volume, const TuneArguments& arguments,
               std::optional<std::uint64_t> given) {
  constexpr std::uint64_t usual_count = 16;
  Progress progress("trying arenas", usual_count);
  Trials trials;
  const std::uint64_t plenty = generous_bytes_for(volume.limits());
  trials.plenty =
      try_regions<std::uint32_t>(volume, Extractor32::default_capacities(volume.limits(), plenty));
  if (trials.plenty.work.cells == 0) return trials;
  if (shows(arguments, Wire::regions)) try_all_regions(volume, arguments, given, progress, trials);
  if (shows(arguments, Wire::slices))
    for (const std::uint32_t interval : key_slice_intervals)
      trials.slices.push_back(try_slices(volume, interval));
  return trials;
}

void print_needs(const VolumeBits& volume, const Trials& trials, std::ostream& out) {
  const Peaks& peaks = trials.plenty.peaks;
  out << "  peak                " << grouped(peaks.slots) << " slots of 8 bytes, "
      << grouped(peaks.holes) << " holes\n"
      << "  least arena         " << bytes_text(Extractor16::minimum_bytes(volume.limits())) << '\n'
      << "  no fragments from   ";
  if (trials.no_loose)
    out << bytes_text(trials.no_loose->memory) << '\n';
  else
    out << "more than the " << bytes_text(max_arena_bytes(volume.limits()))
        << " of 16-bit indices\n";
}

void print_regions(const Trials& trials, const Device& device, std::ostream& out) {
  out << "\nRegions: the arena of the extractor\n";
  std::vector<TriedRow> rows;
  for (std::size_t i = 0; i < trials.regions.size(); ++i)
    rows.push_back({grouped(trials.regions[i].memory), &trials.regions[i], i == trials.chosen});
  print_trials(rows, Wire::regions, device, out);
}

void print_slices(const Trials& trials, const Device& device, std::ostream& out) {
  out << "\nSlices: the memory of the slice encoder\n";
  std::vector<TriedRow> rows;
  for (std::size_t i = 0; i < trials.slices.size(); ++i)
    rows.push_back({(key_slice_intervals[i] == 1
                         ? std::string("every slice is a key slice")
                         : "key slice every " + std::to_string(key_slice_intervals[i])) +
                        "  " + grouped(trials.slices[i].memory),
                    &trials.slices[i], i == 0});
  print_trials(rows, Wire::slices, device, out);
}

std::string comment_of(const Trial& trial, Wire wire, const Device& device) {
  std::string text = wire == Wire::slices ? bytes_text(trial.memory)
                                          : grouped(trial.loose_pieces) + " loose fragments in " +
                                                bytes_text(trial.memory);
  return text + ": a stream of " + bytes_text(trial.stream_bytes()) + ", " +
         seconds_text(seconds_on_link(trial, device)) + " s on the link.";
}

// Returns the options that the printed code does not express, or an empty string.
std::string left_out(const VolumeBits& volume, const VolumeArguments& arguments) {
  std::vector<std::string> omissions;
  const NamedSelection& surface = arguments.selections[0];
  if (volume.is_floating())
    omissions.emplace_back("the threshold in the whole numbers of the device");
  if (surface.is_label)
    omissions.emplace_back("which voxels have the label");
  else if (surface.has_upper_end())
    omissions.push_back("voxels above " + value_text(surface.selection.high) + " are off");
  if (arguments.median > 0) omissions.emplace_back("a MajorityFilter and its memory");
  if (!arguments.mask.empty()) omissions.emplace_back("the mask");
  std::string text;
  for (const std::string& each : omissions)
    text += (text.empty() ? "Not in this code: " : "; ") + each;
  return text.empty() ? text : text + ".";
}

// Returns a comment if the values of the file differ from its samples, otherwise an empty string.
std::string scaled_threshold_text(const VolumeBits& volume, const Selection& selection) {
  const std::int32_t threshold = volume.header().thresholds[0];
  if (volume.is_floating() || selection.low == threshold) return "";
  return "The threshold of the stored samples is " + std::to_string(threshold) + " for the value " +
         value_text(selection.low) + ".";
}

// Returns the comments above the code. trial: its results.
std::vector<std::string> comments(const VolumeBits& volume, const VolumeArguments& arguments,
                                  const std::string& trial) {
  std::vector<std::string> comments{trial};
  for (const std::string& text : {scaled_threshold_text(volume, arguments.selections[0].selection),
                                  left_out(volume, arguments)})
    if (!text.empty()) comments.push_back(text);
  return comments;
}

// Returns the user's text, after the number that a rule has found.
std::string surface_text(const NamedSelection& surface) {
  if (!surface.rule) return surface.name;
  return value_text(surface.selection.low) + " (" + surface.name + ")";
}

void print_code(const FirmwareChoice& choice, const char* wire, std::ostream& out) {
  out << "\n---- " << wire << ", C++ ----\n" << cpp_code(choice);
  out << "\n---- " << wire << ", C ----\n" << c_code(choice);
}

void print_all_code(const VolumeBits& volume, const TuneArguments& arguments, const Trials& trials,
                    const Device& device, std::ostream& out) {
  FirmwareChoice choice;
  choice.limits = volume.limits();
  choice.threshold = volume.header().thresholds[0];
  if (!trials.regions.empty()) {
    const Trial& chosen = trials.regions[trials.chosen];
    choice.comments =
        comments(volume, arguments.reading, comment_of(chosen, Wire::regions, device));
    choice.arena_bytes = chosen.memory;
    if (const auto& capacities = arguments.reading.capacities; !capacities.empty())
      choice.capacities = Capacities{capacities[0], capacities[1]};
    print_code(choice, "regions", out);
  }
  if (!trials.slices.empty()) {
    choice.comments =
        comments(volume, arguments.reading, comment_of(trials.slices[0], Wire::slices, device));
    choice.arena_bytes = 0;
    choice.capacities.reset();
    choice.key_slices = key_slice_intervals[0];
    print_code(choice, "slices", out);
  }
}

void print_report(const VolumeBits& volume, const TuneArguments& arguments, const Trials& trials,
                  std::ostream& out) {
  const Device device{arguments.baud, arguments.clock_hz, arguments.core, volume.sample_bytes()};
  const NamedSelection& surface = arguments.reading.selections[0];
  out << arguments.volume << ", " << volume.limits().width << "x" << volume.limits().height << "x"
      << volume.slices() << " voxels, at " << surface_text(surface) << "\n"
      << name(device.core) << " at " << value_text(device.clock_hz / 1e6) << " MHz, UART at "
      << grouped(static_cast<std::uint64_t>(device.baud)) << " baud\n";
  if (!trials.regions.empty()) {
    print_needs(volume, trials, out);
    print_regions(trials, device, out);
  }
  if (!trials.slices.empty()) print_slices(trials, device, out);
  out << "\nlink: time on the UART, 10 bits per byte. CPU: time of the library, with an error of "
         "about a\nquarter, without wait states of the flash (docs/memory.md). rows/s: average "
         "sustainable\nrate; at worst: CPU-limited rate in the slowest slice.\n";
  print_all_code(volume, arguments, trials, device, out);
}

}  // namespace

int run_tune(const TuneArguments& arguments) {
  TuneArguments found = arguments;
  found.reading.selections = with_thresholds(arguments.volume, arguments.reading);
  const auto volume = open_measured(found.volume, found.reading);
  const VolumeInfo& info = volume->info();
  const auto given = given_arena(found.reading, {info.dims[0], info.dims[1], found.reading.border});
  const auto mask = open_noted_mask(found.reading, info);
  std::optional<VolumeBits> bits;
  {
    Progress progress("reading", info.dims[2]);
    bits.emplace(*volume, extraction_options(found.reading, progress, mask.get()));
  }
  const Trials trials = try_all(*bits, found, given);
  if (trials.plenty.work.cells == 0)
    throw std::runtime_error(why_empty(found.volume, found.reading, found.reading.selections[0],
                                       *volume, bits->is_full()));
  print_report(*bits, found, trials, std::cout);
  require_written(std::cout);
  return exit_ok;
}

}  // namespace discmc::command

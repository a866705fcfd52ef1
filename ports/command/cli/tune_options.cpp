// The arguments of discmc tune.
#include <memory>

#include "cli/options/named_values.hpp"
#include "cli/options/option_checks.hpp"
#include "cli/options/volume_options.hpp"
#include "command_line.hpp"
#include "commands.hpp"

namespace discmc::command {
namespace {

// Parses "48M", "48MHz" or "32768" as hertz; returns nothing for other text.
std::optional<double> frequency(std::string text) {
  if (text.size() > 2 && text.substr(text.size() - 2) == "Hz") text.resize(text.size() - 2);
  double unit = 1;
  if (!text.empty() && (text.back() == 'k' || text.back() == 'K')) unit = 1e3;
  if (!text.empty() && text.back() == 'M') unit = 1e6;
  if (!text.empty() && text.back() == 'G') unit = 1e9;
  if (unit > 1) text.pop_back();
  const auto value = finite_number(text);
  if (!value || *value * unit < 1 || *value * unit > 1e12) return std::nullopt;
  return *value * unit;
}

void check(const TuneArguments& arguments) {
  const std::vector<NamedSelection>& selections = arguments.reading.selections;
  if (selections.empty())
    refuse("--iso", "no threshold is given; add --iso auto, or the threshold of the device");
  const bool sends_slices_alone = arguments.wires == std::vector<Wire>{Wire::slices};
  if (sends_slices_alone && (arguments.reading.memory > 0 || !arguments.reading.capacities.empty()))
    refuse("--wire", "the memory of a slice encoder is fixed; leave out --memory and --capacities");
}

void add_device_options(CLI::App& app, TuneArguments& arguments) {
  app.option_defaults()->group("Device");
  app.add_option("--baud", arguments.baud,
                 "bits per second of the UART; a byte needs 10 bits (8N1)")
      ->check(accepted([](double baud) { return baud >= 1 && baud <= 1e12; },
                       "bits per second, as in 921600"))
      ->option_text("BAUD")
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--clock",
         [&arguments](const std::string& text) { arguments.clock_hz = *frequency(text); },
         "clock of the processor in Hertz, with k or M for 1000 and 1000^2")
      ->check(CLI::Validator(
          [](std::string& text) {
            return frequency(text) ? std::string()
                                   : "invalid clock '" + text + "'; expected Hertz, as in 48M";
          },
          ""))
      ->option_text("HZ")
      ->default_str("48M");
  add_named_option(app, "--core", arguments.core,
                   NamedValues<Core>{{"cortex-m0plus", Core::cortex_m0plus},
                                     {"cortex-m4", Core::cortex_m4},
                                     {"cortex-m7", Core::cortex_m7}},
                   "the processor; give cortex-m0plus for an M0, and cortex-m4 for an M3 or M33");
  const NamedValues<Wire> wires{{"regions", Wire::regions}, {"slices", Wire::slices}};
  app.add_option_function<std::vector<std::string>>(
         "--wire",
         [&arguments, wires](const std::vector<std::string>& names) {
           for (const auto& [name, wire] : wires)
             if (std::find(names.begin(), names.end(), name) != names.end())
               arguments.wires.push_back(wire);
         },
         "the kind of stream; may be given twice (default: both)")
      ->check(CLI::IsMember({"regions", "slices"}))
      ->expected(1, -1)
      ->allow_extra_args(false)
      ->option_text("regions|slices");
}

}  // namespace

Command add_tune(CLI::App& app) {
  const auto arguments = std::make_shared<TuneArguments>();
  CLI::App* tune =
      app.add_subcommand("tune", "Estimate RAM, stream size and CPU time for a device");
  tune->add_option("VOLUME", arguments->volume,
                   "a volume as for extract, of the size and detail of the scans to come; - reads "
                   "standard input")
      ->required();
  add_device_options(*tune, *arguments);
  add_volume_options(*tune, arguments->reading.options);
  add_surface_options(*tune, arguments->reading);
  tune->remove_option(tune->get_option("--allow-empty"));
  tune->get_option("--memory")
      ->description(
          "bytes of the memory, with K or M for 1024 and 1024^2 (default: the least without loose "
          "fragments)");
  tune->footer(
      "Examples:\n"
      "  discmc tune head.nii.gz --iso 300\n"
      "  discmc tune head.nii.gz --iso 300 --memory 24K --baud 115200 --core cortex-m0plus");
  tune->callback([arguments] { check(*arguments); });
  return {tune, [arguments] { return run_tune(*arguments); }};
}

}  // namespace discmc::command

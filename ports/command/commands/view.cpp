// discmc view: a page that shows a volume or a stream.
#include <cstdint>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "commands.hpp"
#include "exit_codes.hpp"
#include "extract.hpp"
#include "input_content.hpp"
#include "input_name.hpp"
#include "mesh_output.hpp"
#include "output_file.hpp"
#include "pages/browser.hpp"
#include "pages/page.hpp"
#include "progress.hpp"
#include "require.hpp"
#include "stream_input.hpp"
#include "summary.hpp"
#include "thresholds.hpp"
#include "volume_input.hpp"
#include "volumes/nifti_writer.hpp"

namespace discmc::host {
namespace {

// Of the input, for people.
std::string name_of(const std::string& input) {
  return input == "-" ? "standard input" : input_name(input);
}

// Browsers hold no text of 2^29 characters, and three bytes that do not shrink are four of them.
void require_size(const std::string& input, const VolumeInfo& info) {
  constexpr std::uint64_t most = std::uint64_t{1} << 28;
  const std::uint64_t bytes = info.slice_bytes() * info.dims[2];
  if (bytes > most)
    throw std::runtime_error(input + ": its samples are " + std::to_string(bytes >> 20) +
                             " MiB, and a page holds 256: give --iso VALUE, --shrink N or --crop");
}

void write_page_of_samples(const ViewArguments& arguments, std::ostream& out) {
  const auto volume = open_volume(arguments.input, volume_options(arguments.reading.layout));
  require_size(arguments.input, volume->info());
  Progress progress("writing", volume->info().dims[2]);
  write_page(
      name_of(arguments.input),
      [&](std::ostream& data) {
        write_nifti(
            *volume, [&progress](std::uint32_t slices) { progress.show(slices); }, data);
      },
      out);
}

void write_page_of_threshold(const ViewArguments& arguments, std::ostream& out) {
  ExtractArguments extraction;
  extraction.volume = arguments.input;
  extraction.reading = arguments.reading;
  extraction.reading.selections = with_thresholds(arguments.input, arguments.reading);
  extraction.wire = Wire::slices;
  extraction.quiet = true;
  const std::string name =
      name_of(arguments.input) + " at " + extraction.reading.selections[0].name + ".dmc";
  write_page(
      name, [&](std::ostream& data) { write_stream(extraction, data); }, out);
}

int write_page_of_stream(const ViewArguments& arguments, std::ostream& out) {
  const std::string bytes = stream_bytes(arguments.input);
  std::istringstream in(bytes);
  const DecodedStream decoded = decode_surface(arguments.input, in, {});
  const Progress progress("writing");
  write_page(
      name_of(arguments.input), [&bytes](std::ostream& data) { data << bytes; }, out);
  return completeness(arguments.input, decoded.report);
}

int write_page_of(const ViewArguments& arguments, std::ostream& out) {
  std::optional<ReplayedInput> replayed;
  const bool is_volume =
      arguments.is_volume ? *arguments.is_volume : begins_like_volume(arguments.input, replayed);
  if (!is_volume) return write_page_of_stream(arguments, out);
  if (arguments.reading.selections.empty())
    write_page_of_samples(arguments, out);
  else
    write_page_of_threshold(arguments, out);
  return exit_ok;
}

}  // namespace

int run_view(const ViewArguments& arguments) {
  OutputFile file(arguments.output);
  const int code = write_page_of(arguments, file.stream());
  file.commit();
  if (arguments.output == "-") return code;
  write_file(arguments.output, std::cout);
  require_written(std::cout);
  if (arguments.opens && !open_in_browser(arguments.output))
    std::cerr << "discmc: no browser was found: open " << arguments.output << " in one\n";
  return code;
}

}  // namespace discmc::host

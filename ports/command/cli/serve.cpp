// discmc view --serve: serves the page and its data.
#include <cstdint>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "commands.hpp"
#include "files/write_failure.hpp"
#include "input_content.hpp"
#include "pages/browser.hpp"
#include "pages/live_file.hpp"
#include "pages/page_server.hpp"
#include "view.hpp"
#include "volume_input.hpp"
#include "volumes/byte_source.hpp"
#include "volumes/formats/nifti/writer.hpp"
#include "volumes/volume_info.hpp"

namespace discmc::command {
namespace {

// Reads slices in turn, because not every library can read in two threads. A slow client delays no
// other.
class ReadInTurn final : public VolumeFilter {
 public:
  ReadInTurn(std::unique_ptr<VolumeReader> volume, std::mutex& turn)
      : VolumeFilter(std::move(volume)), turn_(turn) {}
  void read_slice(void* samples) override {
    const std::lock_guard<std::mutex> lock(turn_);
    VolumeFilter::read_slice(samples);
  }

 private:
  std::mutex& turn_;
};

constexpr std::uint64_t served_bytes = std::uint64_t{1} << 30;  // most that the page accepts

void serve(const ViewArguments& arguments, const ServedFile& file) {
  serve_page(file, arguments.port, [&](const std::string& address) {
    std::cout << "Open " << address << " (stop with Ctrl-C)" << std::endl;
    require_written(std::cout);
    if (arguments.opens && !open_in_browser(address))
      std::cerr << "discmc: no browser was found; open " << address << " in a browser\n";
  });
}

// Reads the samples again for every page, to keep none in memory.
void serve_samples(const ViewArguments& arguments) {
  require_second_pass(arguments.input, "each served page reads the volume again");
  std::mutex turn;
  const auto open = [&] {
    const std::lock_guard<std::mutex> lock(turn);
    return open_noted(arguments.input, arguments.reading.options);
  };
  const VolumeInfo info = open()->info();
  require_size(arguments.input, info, served_bytes);
  const auto write = [&](std::ostream& out) {
    ReadInTurn volume(open(), turn);
    write_nifti(
        volume, [](std::uint32_t) {}, out);
  };
  serve(arguments, {name_of(arguments.input), false, nifti_bytes(info), write});
}

void serve_bytes(const ViewArguments& arguments, const NamedBytes& file) {
  serve(arguments,
        {file.name, false, file.bytes.size(), [&file](std::ostream& out) { out << file.bytes; }});
}

void serve_live(const ViewArguments& arguments) {
  LiveFile live(arguments.input);
  serve(arguments, {name_of(arguments.input), true, std::nullopt,
                    [&live](std::ostream& out) { live.copy_to(out); }});
}

// An input from a pipe counts as a stream unless an option is for volumes only, because its first
// bytes may arrive late.
bool is_volume(const ViewArguments& arguments) {
  if (arguments.kind) return arguments.kind == InputKind::volume;
  std::optional<ReplayedInput> replayed;
  return !is_read_once(arguments.input) && begins_like_volume(arguments.input, replayed);
}

}  // namespace

int serve_view(const ViewArguments& arguments) {
  if (shows_meshes(arguments))
    serve_bytes(arguments, meshes_to_show(arguments, served_bytes));
  else if (!is_volume(arguments) && is_read_once(arguments.input))
    serve_live(arguments);
  else if (!is_volume(arguments))
    serve_bytes(arguments, stream_in_file(arguments));
  else if (arguments.reading.selections.empty())
    serve_samples(arguments);
  else
    serve_bytes(arguments, stream_of_threshold(arguments));
  return exit_ok;
}

}  // namespace discmc::command

// The cost of short frames, and the losses of frames of 20 bytes on a lossy link.
//
//   bench_short_frames cthead.nrrd:500

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <discmc/discmc.hpp>
#include <exception>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "volumes/volume.hpp"

using namespace discmc;
using namespace discmc::command;

namespace {

constexpr const char* usage =
    R"(usage: bench_short_frames FILE:THRESHOLD

Encodes a volume as regions (96 KiB) and as slices (a key slice every 16) with frames of several
lengths, and decodes both after a loss of 1 % of the link's frames of 20 bytes. FILE as discmc
extract takes it; THRESHOLD is on stored samples.

Exit status: 0, or 1 if a file could not be read or scanned, or 2 for wrong arguments.
)";

using Bytes = std::vector<uint8_t>;

void check(Status status) {
  if (status != Status::ok && status != Status::finished)
    throw std::runtime_error(to_string(status));
}

ByteOutput output_to(Bytes& stream, uint16_t max_frame) {
  ByteOutput output{&stream, [](void* context, const uint8_t* bytes, size_t count) {
                      auto& all = *static_cast<Bytes*>(context);
                      all.insert(all.end(), bytes, bytes + count);
                      return count;
                    }};
  output.max_frame = max_frame;
  return output;
}

template <class Sample>
void scan(const std::string& path, int32_t threshold, uint16_t max_frame, Bytes& regions,
          Bytes& slices) {
  const auto reader = open_volume(path);
  const VolumeInfo& info = reader->info();
  const Limits limits{info.dims[0], info.dims[1]};
  const SliceEncoderConfig config{limits, {threshold}, 16};
  Bytes memory(96 * 1024), bits(SliceEncoder::minimum_bytes(config));
  const auto extractor = std::make_unique<Extractor16>();
  Encoder encoder;
  SliceEncoder slice_encoder;
  check(encoder.start({info.dims[2]}, output_to(regions, max_frame)));
  check(extractor->start(limits, threshold, {memory.data(), memory.size()}, make_sink(encoder)));
  check(slice_encoder.start(config, {bits.data(), bits.size()}, output_to(slices, max_frame)));
  std::vector<Sample> slice(info.slice_bytes() / sizeof(Sample));
  for (uint32_t z = 0; z < info.dims[2]; ++z) {
    reader->read_slice(slice.data());
    check(extractor->push(slice.data(), static_cast<uint32_t>(slice.size())).status);
    check(slice_encoder.push(slice.data(), static_cast<uint32_t>(slice.size())).status);
  }
  check(extractor->finish());
  check(slice_encoder.finish());
}

// The stream without 1 % of its pieces of 20 bytes.
Bytes with_losses(const Bytes& stream) {
  std::mt19937 random(1);
  Bytes rest;
  for (size_t at = 0; at < stream.size(); at += 20) {
    const auto begin = stream.begin() + static_cast<std::ptrdiff_t>(at);
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min<size_t>(20, stream.size() - at));
    if (random() % 100 != 0) rest.insert(rest.end(), begin, end);
  }
  return rest;
}

struct Ignore {
  SinkResult accept(const Event&) { return SinkResult::accepted; }
};

StreamReport report_of(const Bytes& stream) {
  Ignore sink;
  Bytes memory(64 << 20);
  Receiver receiver;
  check(receiver.start({memory.data(), memory.size()}, make_sink(sink)));
  Decoded decoded{Status::suspended, 0};
  for (size_t at = 0; decoded.status == Status::suspended; at += decoded.bytes)
    decoded = receiver.push(stream.data() + at, stream.size() - at);
  check(decoded.status);
  check(receiver.finish());
  return receiver.report();
}

double percent(uint64_t part, uint64_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string file = argc == 2 ? argv[1] : "";
  const size_t colon = file.rfind(':');
  int32_t threshold = 0;
  const auto parsed =
      colon == std::string::npos
          ? std::from_chars_result{nullptr, std::errc::invalid_argument}
          : std::from_chars(file.data() + colon + 1, file.data() + file.size(), threshold);
  if (parsed.ec != std::errc() || parsed.ptr != file.data() + file.size()) {
    std::fputs(usage, stderr);
    return 2;
  }
  std::printf(
      "| max_frame | bytes, regions | polygons lost, %% | bytes, slices | rows lost, %% |\n");
  std::printf("|--:|--:|--:|--:|--:|\n");
  for (const uint16_t max_frame : std::initializer_list<uint16_t>{256, 128, 96, 64, 48}) {
    Bytes regions, slices;
    const std::string path = file.substr(0, colon);
    with_scanner_type(open_volume(path)->info().type, [&](auto type) {
      scan<decltype(type)>(path, threshold, max_frame, regions, slices);
    });
    const StreamReport whole = report_of(regions), rows = report_of(slices);
    const StreamReport some = report_of(with_losses(regions));
    const StreamReport some_rows = report_of(with_losses(slices));
    std::printf("| %d | %zu | %.1f | %zu | %.1f |\n", max_frame, regions.size(),
                100 - percent(some.regions + some.fragments, whole.regions + whole.fragments),
                slices.size(), 100 - percent(some_rows.rows, rows.rows));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_short_frames: %s\n", error.what());
  return 1;
}

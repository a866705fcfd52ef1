// The bytes that volumes take as regions and as slices, and what a lost packet takes with it:
//   payloads [FOLDER SAMPLES]
// Prints one figure per line: group, name, column and value, separated by tabs. Given a folder with
// cthead.nrrd and engine.nii.gz it includes these, and writes the samples of the first to a file
// for payload_work.cpp.
#include <array>
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>
#include <string>

#include "oracle/slice_stream.hpp"
#include "volumes/volume.hpp"

namespace {

using namespace discmc;
using reference::BitVolume;
using test::Bytes;

// As on the board. Units: bytes.
constexpr size_t arena = 88 * 1024;

struct Payload {
  const char* name;
  Bytes (*encode)(const BitVolume&);
};

Bytes encode_regions(const BitVolume& volume) {
  test::Line line;
  Encoder encoder;
  reference::require_ok(encoder.start(test::header_of(volume).label(), line.output()));
  reference::scan_into<uint16_t>(encoder, volume, {}, arena);
  return line.bytes;
}
template <uint32_t interval>
Bytes encode_slices(const BitVolume& volume) {
  return test::encode_slices(volume, {{interval}});
}

constexpr Payload payloads[] = {{"regions", encode_regions},
                                {"slices, first is key", encode_slices<0>},
                                {"every 16th is key", encode_slices<16>},
                                {"every slice is key", encode_slices<1>}};

void print(const std::string& name, const char* column, const std::string& value) {
  std::printf("Kinds of stream\t%s\t%s\t%s\n", name.c_str(), column, value.c_str());
}

void print_bytes(const std::string& name, const BitVolume& volume) {
  for (const Payload& payload : payloads)
    print("bytes: " + name, payload.name, std::to_string(payload.encode(volume).size()));
}

// ---- losses ----

SinkResult ignore(void*, const RowEvent&) {
  return SinkResult::accepted;
}

// The share of a volume's rows that do not arrive. Units: percent.
double lost_rows(const std::vector<Bytes>& frames, size_t lost, const BitVolume& volume) {
  reference::Block block(SliceDecoder::minimum_bytes({volume.width, volume.height}));
  SliceDecoder decoder;
  reference::require_ok(decoder.start(block.memory(), {nullptr, ignore}));
  for (size_t i = 0; i < frames.size(); ++i)
    if (i != lost) reference::require_ok(decoder.push(frames[i].data(), frames[i].size()).status);
  reference::require_ok(decoder.finish());
  return 100.0 * static_cast<double>(decoder.report().lost_rows) / (volume.height * volume.depth);
}

// The share of the data that a lost packet costs, in percent, on average over packets other than
// headers and trailers. A packet of regions costs only its own records.
double mean_loss(const Bytes& stream, const BitVolume& volume) {
  const std::vector<Bytes> frames = test::frames_of(stream);
  double rows = 0;
  size_t packets_of_records = 0, packets_of_slices = 0;
  for (size_t i = 0; i < frames.size(); ++i) {
    const test::Packet packet = test::packet_of(frames[i]);
    if (packet.is(detail::wire::PacketKind::records)) ++packets_of_records;
    if (packet.kind < static_cast<uint8_t>(detail::wire::PacketKind::slices)) continue;
    ++packets_of_slices;
    rows += lost_rows(frames, i, volume);
  }
  if (packets_of_records > 0) return 100.0 / static_cast<double>(packets_of_records);
  return rows / static_cast<double>(packets_of_slices);
}

void print_losses(const std::string& name, const BitVolume& volume) {
  for (const Payload& payload : payloads) {
    std::array<char, 32> value{};
    std::snprintf(value.data(), value.size(), "%.2f", mean_loss(payload.encode(volume), volume));
    print(name, payload.name, value.data());
  }
}

// ---- real scans ----

template <class Sample>
BitVolume read(const std::string& file, int32_t threshold,
               const std::function<void(const std::vector<Sample>&)>& pass_on = {}) {
  const auto reader = command::open_volume(file);
  const auto [width, height, depth] = reader->info().dims;
  BitVolume volume({width, height, depth});
  std::vector<Sample> slice(size_t{width} * height);
  auto voxel = volume.on.begin();
  for (uint32_t z = 0; z < depth; ++z) {
    reader->read_slice(slice.data());
    for (const Sample sample : slice) *voxel++ = sample >= threshold ? 1 : 0;
    if (pass_on) pass_on(slice);
  }
  return volume;
}

// The samples go to a file, too.
BitVolume read_head(const std::string& folder, const std::string& samples) {
  std::ofstream file(samples, std::ios::binary);
  const auto pass_on = [&](const std::vector<uint16_t>& slice) {
    file.write(reinterpret_cast<const char*>(slice.data()),
               static_cast<std::streamsize>(slice.size() * sizeof slice[0]));
  };
  BitVolume head = read<uint16_t>(folder + "/cthead.nrrd", 500, pass_on);
  file.close();
  if (!file) throw std::runtime_error("cannot write " + samples);
  return head;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 1 && count != 3) {
    std::fputs("usage: payloads [FOLDER SAMPLES]\n", stderr);
    return 2;
  }
  print_bytes("ball, 100x100x100", reference::ball({100, 100, 100}, {100, 100, 100}, 1002));
  std::optional<BitVolume> head;
  if (count == 3) {
    const std::string folder = arguments[1];
    head = read_head(folder, arguments[2]);
    print_bytes("CT head (Stanford), 256x256x113, at 500", *head);
    print_bytes("CT engine, 256x256x128, at 80", read<uint8_t>(folder + "/engine.nii.gz", 80));
  }
  print_bytes("noise, 64x64x64, half on", reference::random({64, 64, 64}, 128, 1));
  if (head) print_losses("% of CT head (Stanford) lost per lost packet", *head);
}

// Prints the bytes of volumes as regions and as slices, and the cost of a lost packet:
//   payloads [FOLDER COUNTED]
// Each line has one figure: group, name, column and value, separated by tabs. FOLDER has real
// scans, two of which are included. All volumes are written to folders in COUNTED, for
// volume_work.cpp.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "bench/comparison/volumes.hpp"
#include "oracle/slice_stream.hpp"

namespace {

using namespace discmc;
using reference::BitVolume;
using test::Bytes;

// The same as on the board. Units: bytes.
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

// The part of a volume's rows that do not arrive. Units: percent.
double lost_rows(const std::vector<Bytes>& frames, size_t lost, const BitVolume& volume) {
  reference::Block block(SliceDecoder::minimum_bytes({volume.width, volume.height}));
  SliceDecoder decoder;
  reference::require_ok(decoder.start(block.memory(), {nullptr, ignore}));
  for (size_t i = 0; i < frames.size(); ++i)
    if (i != lost) reference::require_ok(decoder.push(frames[i].data(), frames[i].size()).status);
  reference::require_ok(decoder.finish());
  return 100.0 * static_cast<double>(decoder.report().lost_rows) / (volume.height * volume.depth);
}

// The part of the data that a lost packet costs, on average over packets other than headers and
// trailers. A packet of regions costs only its own records. Units: percent.
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

// ---- volumes whose instructions are counted ----

bench::Volume read(const std::string& name, const std::string& file, int32_t threshold) {
  bench::Volume volume = bench::read_volume(file);
  volume.name = name;
  volume.threshold = threshold;
  return volume;
}

std::vector<bench::Volume> real_scans(const std::string& folder) {
  return {read("CT head (Stanford), at 500", folder + "/cthead.nrrd", 500),
          read("CT engine, at 80", folder + "/engine.nii.gz", 80),
          read("MRI head, at 40", folder + "/mri_head_seg3d.nii.gz", 40),
          read("CT head of VTK, a quarter, at 500", folder + "/ct_quarter.nrrd", 500),
          read("fuel injection, at 20", folder + "/fuel.mha", 20),
          read("bucky ball, at 80", folder + "/bucky32.nrrd", 80)};
}

std::vector<bench::Volume> generated() {
  return {bench::ball(128), bench::noisy_ball(128), bench::gyroid(128), bench::smooth_noise(64)};
}

BitVolume voxels_of(const bench::Volume& volume) {
  BitVolume voxels({volume.width, volume.height, volume.depth});
  voxels.on = bench::voxels_on(volume);
  return voxels;
}

// The folder of each volume is its number; a file in it has its name.
class CountedFolders {
 public:
  explicit CountedFolders(std::string folder) : folder_(std::move(folder)) {}

  void write(const bench::Volume& volume) {
    const std::filesystem::path folder = folder_ / std::to_string(count_++);
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "name.txt") << volume.name << '\n';
    std::ofstream file(folder / "volume.raw", std::ios::binary);
    std::visit([&](const auto& samples) { write(volume, samples, file); }, volume.samples);
    file.close();
    if (!file) throw std::runtime_error("cannot write into " + folder.string());
  }

 private:
  template <class Sample>
  static void write(const bench::Volume& volume, const std::vector<Sample>& samples,
                    std::ostream& file) {
    const std::array<uint32_t, 5> header{volume.width, volume.height, volume.depth,
                                         static_cast<uint32_t>(volume.threshold), sizeof(Sample)};
    file.write(reinterpret_cast<const char*>(header.data()), sizeof header);
    file.write(reinterpret_cast<const char*>(samples.data()),
               static_cast<std::streamsize>(samples.size() * sizeof(Sample)));
  }

  std::filesystem::path folder_;
  int count_ = 0;
};

}  // namespace

int main(int count, char** arguments) {
  if (count != 1 && count != 3) {
    std::fputs("usage: payloads [FOLDER COUNTED]\n", stderr);
    return 2;
  }
  print_bytes("ball, 100x100x100", reference::ball({100, 100, 100}, {100, 100, 100}, 1002));
  std::optional<BitVolume> head;
  if (count == 3) {
    const std::vector<bench::Volume> scans = real_scans(arguments[1]);
    head = voxels_of(scans[0]);
    print_bytes("CT head (Stanford), 256x256x113, at 500", *head);
    print_bytes("CT engine, 256x256x128, at 80", voxels_of(scans[1]));
    CountedFolders folders(arguments[2]);
    for (const bench::Volume& volume : scans) folders.write(volume);
    for (const bench::Volume& volume : generated()) folders.write(volume);
  }
  print_bytes("noise, 64x64x64, half on", reference::random({64, 64, 64}, 128, 1));
  if (head) print_losses("% of CT head (Stanford) lost per lost packet", *head);
}

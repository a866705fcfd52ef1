// Real scans, where there are any: the environment variable DISCMC_DATA names a folder with volumes
// and, beside each, a JSON file of the same name that gives "file" and "iso", a list of thresholds
// on stored samples. Without it these tests say so and pass.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "reference/agreement.hpp"
#include "reference/scan.hpp"
#include "volume.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

namespace fs = std::filesystem;

struct Scan {
  fs::path file;
  std::vector<int32_t> thresholds;
};

// What follows "key": up to the end of the value; the files are flat but for the list.
std::string value_of(const std::string& json, const std::string& key) {
  const size_t at = json.find('"' + key + '"');
  if (at == std::string::npos) return {};
  const size_t begin = json.find(':', at) + 1;
  const size_t first = json.find_first_not_of(" \n\r\t", begin);
  if (json[first] == '[') return json.substr(first + 1, json.find(']', first) - first - 1);
  if (json[first] == '"') return json.substr(first + 1, json.find('"', first + 1) - first - 1);
  return json.substr(first, json.find_first_of(",}", first) - first);
}

Scan read_description(const fs::path& file) {
  std::ifstream stream(file);
  const std::string json{std::istreambuf_iterator<char>(stream), {}};
  Scan scan{file.parent_path() / value_of(json, "file"), {}};
  std::string list = value_of(json, "iso");
  std::replace(list.begin(), list.end(), ',', ' ');
  std::istringstream thresholds(list);
  for (int32_t threshold = 0; thresholds >> threshold;) scan.thresholds.push_back(threshold);
  return scan;
}

std::vector<Scan> scans() {
  std::vector<Scan> scans;
  const char* folder = std::getenv("DISCMC_DATA");
  if (folder == nullptr) {
    MESSAGE("skipped: DISCMC_DATA names no folder with volumes");
    return scans;
  }
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") scans.push_back(read_description(entry.path()));
  std::sort(scans.begin(), scans.end(),
            [](const Scan& a, const Scan& b) { return a.file < b.file; });
  CHECK_MESSAGE(!scans.empty(), "no description of a volume in ", folder);
  return scans;
}

template <class Sample>
void threshold_slices(host::VolumeReader& reader, int32_t threshold, BitVolume& volume) {
  std::vector<Sample> slice(size_t{volume.width} * volume.height);
  auto voxel = volume.on.begin();
  for (uint32_t z = 0; z < volume.depth; ++z) {
    reader.read_slice(slice.data());
    for (const Sample sample : slice) *voxel++ = sample >= threshold ? 1 : 0;
  }
}

BitVolume read(const fs::path& file, int32_t threshold) {
  const auto reader = host::open_volume(file);
  const host::VolumeInfo& info = reader->info();
  BitVolume volume({info.dims[0], info.dims[1], info.dims[2]});
  switch (info.type) {
    case host::SampleType::u8:
      threshold_slices<uint8_t>(*reader, threshold, volume);
      break;
    case host::SampleType::u16:
      threshold_slices<uint16_t>(*reader, threshold, volume);
      break;
    case host::SampleType::i16:
      threshold_slices<int16_t>(*reader, threshold, volume);
      break;
  }
  return volume;
}

// Feeds the samples themselves, slice by slice, as they come from the file.
template <class Index, class Sample>
void push_slices(Extractor<Index>& extractor, host::VolumeReader& reader) {
  std::vector<Sample> slice(size_t{extractor.limits().width} * extractor.limits().height);
  for (uint32_t z = 0; z < reader.info().dims[2]; ++z) {
    reader.read_slice(slice.data());
    push_all(extractor, slice);
  }
}

template <class Index>
Collector sweep(const fs::path& file, int32_t threshold, Border border, uint64_t bytes) {
  const auto reader = host::open_volume(file);
  const host::VolumeInfo& info = reader->info();
  Collector collector;
  Block block(bytes);
  Extractor<Index> extractor;
  require_ok(extractor.start({info.dims[0], info.dims[1], border}, threshold, block.memory(),
                             collector.sink()));
  if (info.type == host::SampleType::u8) push_slices<Index, uint8_t>(extractor, *reader);
  if (info.type == host::SampleType::u16) push_slices<Index, uint16_t>(extractor, *reader);
  if (info.type == host::SampleType::i16) push_slices<Index, int16_t>(extractor, *reader);
  finish_all(extractor);
  CHECK(block.is_intact());
  return collector;
}

// The CT head of the known answers, or an empty path.
fs::path ct_head() {
  for (const Scan& scan : scans())
    if (scan.file.stem() == "cthead") return scan.file;
  MESSAGE("skipped: no volume named cthead");
  return {};
}

constexpr int32_t skin = 500;
constexpr Border borders[] = {Border::closed, Border::open};

}  // namespace

TEST_CASE("real volumes are swept as the paper merges them, at every threshold") {
  for (const Scan& scan : scans())
    for (const int32_t threshold : scan.thresholds) {
      const BitVolume volume = read(scan.file, threshold);
      for (const Border border : borders) {
        CAPTURE(scan.file.string());
        CAPTURE(threshold);
        const Collector collector = sweep<uint32_t>(scan.file, threshold, border, 64 << 20);
        CHECK(unlike_merge(collector.regions(), volume, border == Border::closed) == "");
      }
    }
}

TEST_CASE("the CT head's skin gives the known counts without a cut in 256 kB") {
  const fs::path file = ct_head();
  if (file.empty()) return;
  for (const Border border : borders) {
    const bool closed = border == Border::closed;
    const Collector collector = sweep<uint16_t>(file, skin, border, 262144 - 256);
    const Statistics& statistics = collector.statistics();
    CHECK(statistics.classic_triangles == (closed ? 633688 : 608680));
    CHECK(statistics.facets == (closed ? 848514 : 804551));
    CHECK(statistics.regions == (closed ? 62384 : 61407));
    CHECK(statistics.links == (closed ? 600778 : 592106));
    size_t rings = 0;
    for (const Region& region : simple_rings(collector.regions())) rings += region.rings.size();
    CHECK(rings == (closed ? 62465 : 61486));
  }
}

TEST_CASE("the CT head's skin in 64 kB has at most a quarter more regions, and the same surface") {
  const fs::path file = ct_head();
  if (file.empty()) return;
  const BitVolume volume = read(file, skin);
  for (const Border border : borders) {
    const bool closed = border == Border::closed;
    const Collector collector = sweep<uint16_t>(file, skin, border, 65536 - 256);
    CHECK(collector.regions().size() * 4 <= (closed ? 62384 : 61407) * 5);
    CHECK(unlike_surface(collector.regions(), volume, closed) == "");
  }
}

TEST_CASE("real volumes keep their surface in very little memory") {
  for (const Scan& scan : scans()) {
    if (scan.thresholds.empty()) continue;
    const BitVolume volume = read(scan.file, scan.thresholds[0]);
    for (const uint64_t extra : {0U, 1000U, 10000U}) {
      const uint64_t bytes = minimum_bytes<uint16_t>(limits_of(volume, Border::closed)) + extra;
      const Collector collector =
          sweep<uint16_t>(scan.file, scan.thresholds[0], Border::closed, bytes);
      CAPTURE(scan.file.string());
      CAPTURE(extra);
      CHECK(unlike_surface(collector.regions(), volume, true) == "");
    }
  }
}

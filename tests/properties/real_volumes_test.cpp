// Real scans, where there are any: the environment variable DISCMC_DATA names a folder as
// described_volumes.hpp describes it. Without it these tests say so and pass.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>

#include "host/described_volumes.hpp"
#include "oracle/agreement.hpp"
#include "oracle/scan.hpp"
#include "volume.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

namespace fs = std::filesystem;

std::vector<host::DescribedVolume> scans() {
  const char* folder = std::getenv("DISCMC_DATA");
  if (folder == nullptr) {
    MESSAGE("skipped: DISCMC_DATA names no folder with volumes");
    return {};
  }
  const auto scans = host::described_volumes(folder);
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
  for (const host::DescribedVolume& scan : scans())
    if (scan.file.stem() == "cthead") return scan.file;
  MESSAGE("skipped: no volume named cthead");
  return {};
}

constexpr int32_t skin = 500;
constexpr Border borders[] = {Border::closed, Border::open};

}  // namespace

TEST_CASE("real volumes are swept as the paper merges them, at every threshold") {
  for (const host::DescribedVolume& scan : scans())
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
  for (const host::DescribedVolume& scan : scans()) {
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

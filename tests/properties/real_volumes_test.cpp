// Real scans. The environment variable DISCMC_DATA names their folder, described in
// described_volumes.hpp. Without it these tests print a message and pass.
#include <cstdlib>
#include <filesystem>

#include "bench/comparison/volumes.hpp"
#include "command/described_volumes.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "oracle/stream.hpp"
#include "test.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

namespace fs = std::filesystem;

std::vector<command::DescribedVolume> scans() {
  const char* folder = std::getenv("DISCMC_DATA");
  if (folder == nullptr || *folder == 0) {
    MESSAGE("skipped: DISCMC_DATA names no folder with volumes");
    return {};
  }
  const auto scans = command::described_volumes(folder);
  CHECK_MESSAGE(!scans.empty(), "no description of a volume in ", folder);
  return scans;
}

BitVolume read(const fs::path& file, int32_t threshold) {
  bench::Volume samples = bench::read_volume(file);
  samples.threshold = threshold;
  BitVolume volume({samples.width, samples.height, samples.depth});
  volume.on = bench::voxels_on(samples);
  return volume;
}

template <class Index>
Collector sweep(const fs::path& file, int32_t threshold, Border border, uint64_t bytes) {
  const bench::Volume volume = bench::read_volume(file);
  Collector collector;
  Block block(bytes);
  Extractor<Index> extractor;
  require_ok(extractor.start({volume.width, volume.height, border}, threshold, block.memory(),
                             collector.sink()));
  std::visit([&](const auto& samples) { push_all(extractor, samples); }, volume.samples);
  finish_all(extractor);
  CHECK(block.is_intact());
  return collector;
}

struct StreamSize {
  uint64_t bytes;
  uint64_t fragments;
};

StreamSize stream_size(const BitVolume& volume, uint64_t memory_bytes) {
  struct Counter {
    SinkResult accept(const Event& event) {
      fragments += event.kind == Event::Kind::fragment;
      return encoder.accept(event);
    }
    static size_t encode_all(void*, const uint8_t*, size_t count) { return count; }

    Encoder encoder;
    uint64_t fragments = 0;
  } counter;
  require_ok(
      counter.encoder.start(test::header_of(volume).label(), {nullptr, Counter::encode_all}));
  scan_into<uint16_t>(counter, volume, {}, memory_bytes);
  return {counter.encoder.bytes(), counter.fragments};
}

// Returns CT head, whose results are known, or an empty path.
fs::path ct_head() {
  for (const command::DescribedVolume& scan : scans())
    if (scan.file.stem() == "cthead") return scan.file;
  MESSAGE("skipped: no volume named cthead");
  return {};
}

constexpr int32_t skin = 500;
constexpr uint64_t kib = 1024;
constexpr Border borders[] = {Border::closed, Border::open};

}  // namespace

TEST_CASE("real volumes are swept as in the paper at every threshold") {
  for (const command::DescribedVolume& scan : scans())
    for (const int32_t threshold : scan.thresholds) {
      const BitVolume volume = read(scan.file, threshold);
      for (const Border border : borders) {
        const bool is_closed = border == Border::closed;
        INFO(scan.file.string(), ", threshold ", threshold);
        const Collector collector = sweep<uint32_t>(scan.file, threshold, border, 64 << 20);
        CHECK(collector.loose().empty());
        CHECK(unlike_merge(collector.regions(), volume, is_closed) == "");
        CHECK(miscounted(collector, volume, is_closed) == "");
      }
    }
}

TEST_CASE("the CT head's skin in 96 KiB yields the recorded counts and no loose fragments") {
  const fs::path file = ct_head();
  if (file.empty()) return;
  for (const Border border : borders) {
    const bool is_closed = border == Border::closed;
    const Collector collector = sweep<uint16_t>(file, skin, border, 96 * kib - sizeof(Extractor16));
    CHECK(collector.loose().empty());
    const Statistics& statistics = collector.statistics();
    CHECK(statistics.classic_triangles == (is_closed ? 633688 : 608680));
    CHECK(statistics.facets == (is_closed ? 848514 : 804551));
    CHECK(statistics.regions == (is_closed ? 62384 : 61407));
    CHECK(statistics.links == (is_closed ? 600778 : 592106));
    size_t rings = 0;
    for (const Region& region : simple_rings(collector.regions())) rings += region.rings.size();
    CHECK(rings == (is_closed ? 62465 : 61486));
  }
}

TEST_CASE("the CT head's skin needs only slightly more bytes with little memory") {
  const fs::path file = ct_head();
  if (file.empty()) return;
  const BitVolume volume = read(file, skin);
  const auto whole = static_cast<double>(stream_size(volume, 256 * kib).bytes);
  const auto in = [&](uint64_t memory) {
    const uint64_t bytes = memory * kib - sizeof(Extractor16);
    return static_cast<double>(stream_size(volume, bytes).bytes) / whole;
  };
  CHECK(in(64) <= 1.1);
  CHECK(in(48) <= 1.25);
  CHECK(in(32) <= 2);
  CHECK(in(24) <= 2.6);
}

TEST_CASE("surfaces of real volumes are the same in any memory after joining") {
  for (const command::DescribedVolume& scan : scans()) {
    if (scan.thresholds.empty()) continue;
    const BitVolume volume = read(scan.file, scan.thresholds[0]);
    const std::vector<Region> merged = merge(volume, true);
    const uint64_t minimum = Extractor16::minimum_bytes(limits_of(volume, Border::closed));
    for (const uint64_t extra : {0U, 1000U, 10000U, 40000U}) {
      INFO(scan.file.string(), ", extra ", extra);
      Collector loose;
      scan_into<uint16_t>(loose, volume, {}, minimum + extra);
      CHECK(unlike_joined({loose}, merged) == "");
      CHECK(miscounted(loose, volume, true) == "");
    }
  }
}

TEST_CASE("slabs of real volumes join to the whole surface") {
  for (const command::DescribedVolume& scan : scans()) {
    if (scan.thresholds.empty()) continue;
    const BitVolume volume = read(scan.file, scan.thresholds[0]);
    for (const Border border : borders) {
      const std::vector<Region> merged = merge(volume, border == Border::closed);
      for (const uint32_t slices : {1U, 2U, 3U, 7U}) {
        INFO(scan.file.string(), ", slices ", slices);
        const auto slabs = scan_slabs<uint32_t>(volume, border, slices, 1 << 20);
        CHECK(unlike_joined(slabs, merged) == "");
      }
    }
  }
}

TEST_CASE("more memory yields no more loose fragments of a real volume and hardly more bytes") {
  for (const command::DescribedVolume& scan : scans()) {
    if (scan.thresholds.empty()) continue;
    const BitVolume volume = read(scan.file, scan.thresholds[0]);
    uint64_t bytes = Extractor16::minimum_bytes(limits_of(volume, Border::closed));
    StreamSize before = stream_size(volume, bytes);
    while (before.fragments > 0 && bytes < 256 * kib) {
      bytes += 2 * kib;
      INFO(scan.file.string(), ", bytes ", bytes);
      const StreamSize size = stream_size(volume, bytes);
      // The coder learns in another order.
      CHECK(size.bytes <= before.bytes + before.bytes / 2500);
      CHECK(size.fragments <= before.fragments + before.fragments / 10000);
      before = size;
    }
  }
}

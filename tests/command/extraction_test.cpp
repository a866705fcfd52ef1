// Volumes extracted as by `extract`: counts, memory, sample types.
#include "extraction/extraction.hpp"

#include <stdexcept>

#include "command.hpp"
#include "hand_made.hpp"
#include "oracle/stream.hpp"
#include "sample_reader.hpp"
#include "surface/growing_joiner.hpp"

namespace {

using command_tests::contains;
using discmc::Border;
using discmc::command::ExtractionOptions;
using discmc::meshing::Extraction;
using discmc::meshing::SampleType;
using discmc::meshing::SurfaceBuilder;
using namespace discmc::reference;
using hand_made::regions_of;
using sample_reader::SampleReader;

constexpr std::int32_t threshold = 100;

const discmc::meshing::Point spacing_mm = {0.5, -2, 1.25};

ExtractionOptions options(Border border = Border::closed, std::uint64_t memory = 0) {
  ExtractionOptions options{{threshold}, border};
  options.memory = memory;
  options.measures_memory = true;
  return options;
}

struct Extracted {
  Extraction extraction;
  discmc::test::Events events;
  discmc::meshing::Surface surface;
};

Extracted extracted(const BitVolume& volume, const ExtractionOptions& options,
                    SampleType type = SampleType::u8) {
  SampleReader reader(volume, spacing_mm, type);
  discmc::test::EventLog log;
  const Extraction extraction = extract(reader, options, discmc::make_sink(log));
  SurfaceBuilder builder;
  discmc::meshing::GrowingJoiner joiner(discmc::make_sink(builder));
  for (const auto& recorded : log.events) joiner.accept(recorded.event());
  CHECK(builder.incomplete_regions() == 0);
  builder.surface().spacing_mm = reader.info().spacing_mm;
  return {extraction, std::move(log.events), std::move(builder.surface())};
}

std::string refusal(const BitVolume& volume, std::uint64_t memory) {
  SampleReader reader(volume, spacing_mm);
  discmc::test::EventLog log;
  try {
    extract(reader, options(Border::closed, memory), discmc::make_sink(log));
  } catch (const std::invalid_argument& error) {
    CHECK(log.events.empty());
    return error.what();
  }
  FAIL("not refused");
  return {};
}

}  // namespace

TEST_CASE("an extraction reports each slice, the number of voxels and the statistics") {
  const BitVolume volume = ball({9, 8, 7}, {8, 7, 6}, 9);
  ExtractionOptions with_progress = options();
  std::vector<std::uint32_t> slices;
  with_progress.progress = [&slices](std::uint32_t done) { slices.push_back(done); };
  const Extraction extraction = extracted(volume, with_progress).extraction;
  CHECK(slices == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7});
  CHECK(extraction.voxels == 9 * 8 * 7);
  CHECK(extraction.statistics.fragments == 0);
}

TEST_CASE("extraction gives the same events for samples of every type") {
  const BitVolume volume = discmc::reference::random({8, 8, 8}, 128, 4);
  const Extracted bytes = extracted(volume, options());
  for (const auto& [called, type] : discmc::command::sample_types) {
    if (type == SampleType::i8) continue;  // lacks the value 150
    const Extracted others = extracted(volume, options(), type);
    CHECK(others.events == bytes.events);
  }
}

TEST_CASE("a threshold outside the range of samples selects all voxels or none") {
  const BitVolume volume = checkerboard({5, 5, 5});
  using Limits = std::numeric_limits<std::int32_t>;
  ExtractionOptions all = options(), none = options();
  all.selection = {Limits::min()};
  none.selection = {Limits::max()};
  CHECK(extracted(volume, all).surface.polygons.size() == 26);
  CHECK(extracted(volume, none).surface.polygons.empty());
}

TEST_CASE("the default memory suffices, and a scan uses no more than its memory") {
  for (const BitVolume& volume : {checkerboard({20, 20, 6}), ball({30, 30, 30}, {29, 29, 29}, 196),
                                  discmc::reference::spiral({30, 30, 3})}) {
    const Extraction extraction = extracted(volume, options()).extraction;
    CHECK(extraction.statistics.fragments == 0);
    CHECK(extraction.memory->arena_bytes_used > 0);
    CHECK(extraction.memory->arena_bytes_used <= extraction.memory->arena_bytes);
  }
}

TEST_CASE("measuring memory does not change the events") {
  for (const Border border : {Border::closed, Border::open})
    for (const BitVolume& volume :
         {checkerboard({20, 20, 6}), ball({30, 30, 30}, {29, 29, 29}, 196),
          discmc::reference::random({16, 16, 16}, 128, 6), BitVolume({3, 3, 3})}) {
      ExtractionOptions fast = options(border);
      fast.measures_memory = false;
      const Extracted a = extracted(volume, fast), b = extracted(volume, options(border));
      CHECK(a.events == b.events);
      CHECK(a.extraction.statistics.facets == b.extraction.statistics.facets);
      CHECK_FALSE(a.extraction.memory);
      CHECK(b.extraction.memory);
    }
}

TEST_CASE("memory grows with the open fragments, not with the surface") {
  const auto used = [](std::uint32_t depth) {
    const auto last = static_cast<std::int32_t>(depth) - 2;
    const BitVolume column = box({12, 12, depth}, {3, 3, 1}, {8, 8, last});
    return extracted(column, options()).extraction.memory->arena_bytes_used;
  };
  CHECK(used(100) == used(10));
}

TEST_CASE("the minimum that the message for too little memory names suffices") {
  const BitVolume volume = discmc::reference::random({20, 20, 5}, 128, 3);
  const std::string text = refusal(volume, 7);
  INFO(text);
  CHECK(contains(text, "--memory 7 "));
  CHECK(contains(text, "20x20"));
  const std::uint64_t minimum = command_tests::count_after(text, "at least ");
  refusal(volume, minimum - 1);
  const Extracted small = extracted(volume, options(Border::closed, minimum));
  CHECK(small.extraction.memory->arena_bytes == minimum);
  CHECK(small.extraction.memory->arena_bytes_used <= minimum);
  CHECK(small.extraction.statistics.fragments > 0);
  CHECK(regions_of(small.surface) == regions_of(extracted(volume, options()).surface));
}

TEST_CASE("an extraction has exactly the requested capacities") {
  const BitVolume volume = discmc::reference::random({20, 20, 5}, 128, 3);
  const auto whole = regions_of(extracted(volume, options()).surface);
  for (const discmc::Capacities capacities :
       {discmc::minimum_capacities(), {300, 0}, {300, 7}, {32759, 2}, {40000, 3000}}) {
    ExtractionOptions with_capacities = options();
    with_capacities.capacities = capacities;
    const Extracted scan = extracted(volume, with_capacities);
    CHECK(scan.extraction.memory->capacities.slots == capacities.slots);
    CHECK(scan.extraction.memory->capacities.holes == capacities.holes);
    CHECK(scan.extraction.memory->peaks.slots > 0);
    CHECK(scan.extraction.memory->peaks.slots <= capacities.slots);
    CHECK(scan.extraction.memory->peaks.holes <= capacities.holes);
    CHECK(scan.extraction.memory->arena_bytes_used <= scan.extraction.memory->arena_bytes);
    CHECK(regions_of(scan.surface) == whole);
  }
}

TEST_CASE("capacities that no scan can have are refused") {
  for (const std::uint32_t slots : {0U, 3U, 0x80000000U}) {
    ExtractionOptions with_capacities = options();
    with_capacities.capacities = discmc::Capacities{slots, 0};
    CHECK_THROWS_AS(extracted(box({2, 2, 2}, {0, 0, 0}, {1, 1, 1}), with_capacities),
                    std::invalid_argument);
  }
}

TEST_CASE("narrow and wide indices give the same surface") {
  constexpr std::uint64_t narrow = std::uint64_t{1} << 19, wide = std::uint64_t{1} << 20;
  for (const BitVolume& volume :
       {ball({24, 24, 24}, {23, 23, 23}, 110), discmc::reference::random({16, 16, 16}, 128, 6)})
    for (const Border border : {Border::closed, Border::open}) {
      const Extracted a = extracted(volume, options(border, narrow));
      const Extracted b = extracted(volume, options(border, wide));
      CHECK(a.events == b.events);
      CHECK(a.extraction.memory->arena_bytes_used < b.extraction.memory->arena_bytes_used);
    }
}

TEST_CASE("the header of a stream describes the volume") {
  const BitVolume volume({9, 8, 7});
  const SampleReader reader(volume, spacing_mm);
  const auto header = discmc::command::stream_header(reader.info(), options(Border::open));
  CHECK(header.width == 9);
  CHECK(header.height == 8);
  CHECK(header.depth == 7);
  CHECK(header.spacing_nm[0] == 500000);
  CHECK(header.spacing_nm[1] == -2000000);
  CHECK(header.spacing_nm[2] == 1250000);
  CHECK(header.thresholds[0] == threshold);
  CHECK(header.border == Border::open);
}

TEST_CASE("a stream matches a volume if the header's extents and spacing equal the volume's") {
  const SampleReader reader(BitVolume({9, 8, 7}), spacing_mm);
  const auto header = discmc::command::stream_header(reader.info(), options());
  const auto complaint = [&reader](const discmc::StreamHeader& other) -> std::string {
    try {
      require_same_volume(reader.info(), other);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  CHECK(complaint(header).empty());
  CHECK(complaint({}).empty());
  for (int axis = 0; axis < 3; ++axis) {
    discmc::StreamHeader other = header;
    (axis == 0 ? other.width : axis == 1 ? other.height : other.depth) += 1;
    CHECK(contains(complaint(other), "9x8x7"));
    other = header;
    other.spacing_nm[axis] += 1;  // rounded differently
    CHECK(complaint(other).empty());
    other.spacing_nm[axis] += 1;
    CHECK(contains(complaint(other), "0.5,-2,1.25"));
    other.spacing_nm[axis] = 0;
    CHECK(complaint(other).empty());
    other.spacing_nm[axis] = -header.spacing_nm[axis];
    CHECK(contains(complaint(other), "0.5,-2,1.25"));
  }
}

// How much processor time each step of an extraction takes, from samples in memory, on one thread.
//
//   bench
//   bench cthead.raw:256x256x113:u16:500 engine.nii:256x256x128:u8:80:352
//
// The steps are cumulative, so that a difference is the cost of what came on top:
//
//   pack     samples are compared with the threshold and packed into rows of bits
//   scan     and active cells are found, their facets counted: the least any extraction must do
//   extract  and regions are merged and handed to a sink that only counts them
//   stream   and are written as a stream to an output that only counts its bytes

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <discmc/discmc.hpp>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "reference/volume.hpp"

using namespace discmc;

namespace {

constexpr const char* usage =
    R"(usage: bench [OPTION...] [FILE:WxHxD:TYPE:THRESHOLD[:OFFSET]...]

Times packing, scanning, extracting and streaming of four generated volumes and of the raw volumes
named: little-endian samples of TYPE u8, u16 or i16 from byte OFFSET of FILE on, x fastest.

  --repeat N     repetitions, of which the best counts (default 5); the steps take turns in each
  --only-files   no generated volumes
  --only STEP    no table: run pack, scan, extract or stream alone, once a repetition (to profile)
  --help         this text

Exit status: 0, or 1 if a file could not be read or an extraction failed, or 2 for an argument that
is not understood.
)";

enum class Step : uint8_t { pack, scan, extract, stream };

constexpr std::array step_names = {"pack", "scan", "extract", "stream"};
constexpr size_t steps = step_names.size();

// ---- volumes ----

using Samples = std::variant<std::vector<uint8_t>, std::vector<uint16_t>, std::vector<int16_t>>;

struct Volume {
  std::string name;
  uint32_t width = 0, height = 0, depth = 0;
  int32_t threshold = 0;
  Samples samples;

  Limits limits() const { return {width, height}; }
  size_t voxels() const { return size_t{width} * height * depth; }
  uint32_t slice_voxels() const { return width * height; }
};

Volume generated(const char* name, reference::BitVolume&& bits) {
  return {name, bits.width, bits.height, bits.depth, 1, std::move(bits.on)};
}

std::vector<Volume> generated_volumes() {
  std::vector<Volume> volumes;
  volumes.push_back(
      generated("ball 256", reference::ball({256, 256, 256}, {255, 255, 255}, 120 * 120)));
  volumes.push_back(generated("noise 64", reference::random({64, 64, 64}, 128, 1)));
  volumes.push_back(generated("checkerboard 64", reference::checkerboard({64, 64, 64})));
  volumes.push_back(generated("empty 256", reference::BitVolume({256, 256, 256})));
  return volumes;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (;;) {
    const size_t end = text.find(separator);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
  return value;
}

// Samples of an integer type from the little-endian bytes of a file.
template <class Sample>
std::vector<Sample> samples_from(const std::vector<char>& bytes, size_t offset, size_t count) {
  if (offset > bytes.size() || (bytes.size() - offset) / sizeof(Sample) < count)
    throw std::runtime_error("the file is shorter than its extents say");
  std::vector<Sample> samples(count);
  for (size_t i = 0; i < samples.size(); ++i) {
    unsigned value = 0;
    for (size_t byte = 0; byte < sizeof(Sample); ++byte)
      value |= unsigned{static_cast<uint8_t>(bytes[offset + i * sizeof(Sample) + byte])}
               << 8 * byte;
    samples[i] = static_cast<Sample>(value);
  }
  return samples;
}

// What a command line says of a raw file.
struct RawFile {
  std::string path;
  std::string type;
  size_t offset = 0;
  Volume volume;
};

std::optional<RawFile> parsed_file(std::string_view argument) {
  const auto fields = split(argument, ':');
  if (fields.size() != 4 && fields.size() != 5) return std::nullopt;
  const auto extents = split(fields[1], 'x');
  if (extents.size() != 3) return std::nullopt;
  const auto width = parsed<uint32_t>(extents[0]);
  const auto height = parsed<uint32_t>(extents[1]);
  const auto depth = parsed<uint32_t>(extents[2]);
  const auto threshold = parsed<int32_t>(fields[3]);
  const auto offset = fields.size() == 5 ? parsed<size_t>(fields[4]) : size_t{0};
  if (!width || !height || !depth || !threshold || !offset) return std::nullopt;
  if (fields[2] != "u8" && fields[2] != "u16" && fields[2] != "i16") return std::nullopt;
  const std::string path(fields[0]);
  const std::string name = path.substr(path.rfind('/') + 1) + " " + std::string(fields[3]);
  return RawFile{path, std::string(fields[2]), *offset,
                 Volume{name, *width, *height, *depth, *threshold, {}}};
}

Volume read(const RawFile& raw) {
  std::ifstream file(raw.path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::runtime_error("the file cannot be read");
  Volume volume = raw.volume;
  if (raw.type == "u8") volume.samples = samples_from<uint8_t>(bytes, raw.offset, volume.voxels());
  if (raw.type == "u16")
    volume.samples = samples_from<uint16_t>(bytes, raw.offset, volume.voxels());
  if (raw.type == "i16") volume.samples = samples_from<int16_t>(bytes, raw.offset, volume.voxels());
  return volume;
}

// ---- the steps ----

// Packs all samples, a row at a time, and calls after_row(rows, y) for each row of cells that is
// then complete.
template <class Sample, class AfterRow>
void pack(const Volume& volume, const std::vector<Sample>& samples, std::vector<uint32_t>& words,
          AfterRow after_row) {
  const Limits limits = volume.limits();
  words.resize(size_t{limits.row_words()} * (limits.height + 3) + 1);
  Arena arena({words.data(), sizeof(uint32_t) * words.size()});
  BitRows rows;
  rows.start(arena, limits);
  rows.clear();
  const Sample* next = samples.data();
  for (uint32_t z = 0; z < volume.depth; ++z) {
    for (uint32_t y = 0; y < volume.height; ++y, next += volume.width) {
      rows.append(next, volume.width, 1, volume.threshold);
      rows.next_row();
      after_row(rows, int64_t{y} - 1);
    }
    after_row(rows, int64_t{volume.height} - 1);
    rows.next_slice();
  }
  for (int64_t y = -1; y < int64_t{volume.height}; ++y) after_row(rows, y);
}

// Facets of a row of cells.
uint64_t scan_row(const BitRows& rows, int64_t y, uint32_t columns) {
  const uint32_t words = rows.words();
  const RowQuad quad = rows.around(static_cast<int32_t>(y));
  uint64_t facets = 0;
  for (uint32_t word = 0; word * 32 < columns; ++word) {
    uint32_t active = active_cells(quad, word, words);
    if (columns - word * 32 < 32) active &= (uint32_t{1} << (columns - word * 32)) - 1;
    for (; active != 0; active &= active - 1) {
      const auto bit = static_cast<uint32_t>(__builtin_ctz(active));
      facets += cell_facts.facets[configuration_at(quad, word, bit)];
    }
  }
  return facets;
}

struct Counter {
  uint64_t links = 0;
  Answer take(const Event& event) {
    if (event.kind == Event::Kind::run) links += event.run.length();
    return Answer::taken;
  }
};

size_t count_bytes(void* context, const uint8_t*, size_t count) {
  *static_cast<uint64_t*>(context) += count;
  return count;
}

void require_ok(Status status) {
  if (status != Status::ok) throw std::runtime_error(text(status));
}

// What is known of an extraction afterwards.
struct Outcome {
  Statistics statistics{};
  HighWater high_water{};
  uint64_t arena_bytes = 0;
  uint64_t stream_bytes = 0;
};

// One volume and all that its steps need, so that no repetition allocates.
class Course {
 public:
  explicit Course(Volume volume)
      : volume_(std::move(volume)),
        bytes_(worst_case_bytes<uint32_t>(volume_.limits())),
        arena_(new uint8_t[bytes_]) {}

  const Volume& volume() const { return volume_; }
  const Outcome& outcome() const { return outcome_; }

  void run(Step step) {
    std::visit([&](const auto& samples) { run(step, samples); }, volume_.samples);
  }

 private:
  template <class Sample>
  void run(Step step, const std::vector<Sample>& samples) {
    switch (step) {
      case Step::pack:
        return pack(volume_, samples, words_, [](const BitRows&, int64_t) {});
      case Step::scan:
        return scan(samples);
      case Step::extract: {
        Counter counter;
        return extract(samples, sink_to(counter));
      }
      case Step::stream: {
        StreamHeader header;
        header.width = volume_.width;
        header.height = volume_.height;
        header.depth = volume_.depth;
        header.threshold = volume_.threshold;
        outcome_.stream_bytes = 0;
        require_ok(encoder_.start(header, {&outcome_.stream_bytes, count_bytes}));
        return extract(samples, sink_to(encoder_));
      }
    }
  }

  template <class Sample>
  void scan(const std::vector<Sample>& samples) {
    const uint32_t columns = volume_.limits().columns();
    uint64_t facets = 0;
    pack(volume_, samples, words_,
         [&](const BitRows& rows, int64_t y) { facets += scan_row(rows, y, columns); });
    if (outcome_.statistics.cells != 0 && facets != outcome_.statistics.facets)
      throw std::runtime_error("scan and extraction count different facets");
  }

  template <class Sample>
  void extract(const std::vector<Sample>& samples, const Sink& sink) {
    const Limits limits = volume_.limits();
    require_ok(extractor_.start(limits, worst_case_capacities(limits), volume_.threshold,
                                {arena_.get(), bytes_}, sink));
    const Sample* next = samples.data();
    for (uint32_t z = 0; z < volume_.depth; ++z, next += volume_.slice_voxels())
      require_ok(extractor_.push(next, volume_.slice_voxels()).status);
    require_ok(extractor_.finish());
    outcome_.statistics = extractor_.statistics();
    outcome_.high_water = extractor_.high_water();
    outcome_.arena_bytes = extractor_.bytes_used();
  }

  Volume volume_;
  size_t bytes_;
  std::unique_ptr<uint8_t[]> arena_;
  std::vector<uint32_t> words_;
  Extractor32 extractor_;
  Encoder encoder_;
  Outcome outcome_;
};

// ---- measuring and printing ----

using Nanoseconds = std::array<double, steps>;

// Processor time, which other programs on the machine disturb less than the time of day.
double nanoseconds_now() {
  return static_cast<double>(std::clock()) * (1e9 / static_cast<double>(CLOCKS_PER_SEC));
}

// The best of the repetitions; the steps take turns, so that a slow spell hits them all.
Nanoseconds measure(Course& course, int repetitions) {
  Nanoseconds best;
  best.fill(std::numeric_limits<double>::infinity());
  for (int i = 0; i < repetitions; ++i)
    for (size_t step = 0; step < steps; ++step) {
      const double begin = nanoseconds_now();
      course.run(static_cast<Step>(step));
      best[step] = std::min(best[step], nanoseconds_now() - begin);
    }
  return best;
}

struct Row {
  Volume volume;  // without its samples
  Nanoseconds time;
  Outcome outcome;
};

void print_times(const char* unit, const std::vector<Row>& rows, uint64_t (*count)(const Row&)) {
  std::printf("%-20s %12s", unit, "count");
  for (const char* name : step_names) std::printf(" %8s", name);
  std::printf("\n");
  for (const Row& row : rows) {
    const uint64_t units = count(row);
    std::printf("%-20s %12llu", row.volume.name.c_str(), static_cast<unsigned long long>(units));
    for (const double time : row.time)
      if (units > 0)
        std::printf(" %8.2f", time / static_cast<double>(units));
      else
        std::printf(" %8s", "-");
    std::printf("\n");
  }
  std::printf("\n");
}

// What extraction may cost beyond a scan; above it a ratio is marked.
constexpr double max_ratio = 25;

void print_ratios(const std::vector<Row>& rows) {
  std::printf("%-20s %13s %14s %15s\n", "ratios", "extract/pack", "extract/scan", "stream/extract");
  for (const Row& row : rows) {
    const auto ratio = [&](Step step, Step to) {
      return row.time[static_cast<size_t>(step)] / row.time[static_cast<size_t>(to)];
    };
    const double beyond_scan = ratio(Step::extract, Step::scan);
    std::printf("%-20s %13.2f %14.2f %15.2f%s\n", row.volume.name.c_str(),
                ratio(Step::extract, Step::pack), beyond_scan, ratio(Step::stream, Step::extract),
                beyond_scan > max_ratio ? "  extract/scan is above 25" : "");
  }
  std::printf("\n");
}

// The memory that would just have done: capacities equal to the marks, with 16-bit indices where
// they suffice.
uint64_t least_bytes(const Row& row) {
  const HighWater& most = row.outcome.high_water;
  const Capacities least = minimum_capacities();
  const Capacities capacities = {std::max(least.edges, most.edges), std::max(least.runs, most.runs),
                                 std::max(least.rings, most.rings),
                                 std::max(least.regions, most.regions),
                                 std::max(least.slots, most.slots)};
  const Limits limits = row.volume.limits();
  return are_valid<uint16_t>(capacities) ? bytes_for<uint16_t>(limits, capacities)
                                         : bytes_for<uint32_t>(limits, capacities);
}

void print_memory(const std::vector<Row>& rows) {
  std::printf("%-20s %8s %8s %8s %8s %8s %12s %12s\n", "high-water marks", "edges", "runs", "rings",
              "regions", "slots", "their bytes", "arena bytes");
  for (const Row& row : rows) {
    const HighWater& most = row.outcome.high_water;
    std::printf("%-20s %8u %8u %8u %8u %8u %12llu %12llu\n", row.volume.name.c_str(), most.edges,
                most.runs, most.rings, most.regions, most.slots,
                static_cast<unsigned long long>(least_bytes(row)),
                static_cast<unsigned long long>(row.outcome.arena_bytes));
  }
  std::printf("\n%-20s %9s %9s %9s %9s %9s %10s\n", "results", "facets", "regions", "rings",
              "links", "fragments", "stream");
  for (const Row& row : rows) {
    const Statistics& sum = row.outcome.statistics;
    std::printf("%-20s", row.volume.name.c_str());
    for (const uint64_t count : {sum.facets, sum.regions, sum.rings, sum.links, sum.fragments})
      std::printf(" %9llu", static_cast<unsigned long long>(count));
    std::printf(" %10llu\n", static_cast<unsigned long long>(row.outcome.stream_bytes));
  }
}

void print_table(const std::vector<Row>& rows) {
  print_times("ns per voxel", rows, [](const Row& row) { return row.volume.voxels(); });
  print_times("ns per active cell", rows,
              [](const Row& row) { return row.outcome.statistics.cells; });
  print_ratios(rows);
  print_memory(rows);
}

// ---- the command line ----

struct Options {
  int repetitions = 5;
  bool with_generated = true;
  std::optional<Step> only;
  std::vector<RawFile> files;
};

std::optional<Step> parsed_step(std::string_view name) {
  for (size_t step = 0; step < steps; ++step)
    if (name == step_names[step]) return static_cast<Step>(step);
  return std::nullopt;
}

std::optional<Options> parsed_options(const std::vector<std::string_view>& arguments) {
  Options options;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const bool has_next = i + 1 < arguments.size();
    if (arguments[i] == "--only-files") {
      options.with_generated = false;
    } else if (arguments[i] == "--repeat" && has_next) {
      const auto number = parsed<int>(arguments[++i]);
      if (!number || *number < 1) return std::nullopt;
      options.repetitions = *number;
    } else if (arguments[i] == "--only" && has_next) {
      options.only = parsed_step(arguments[++i]);
      if (!options.only) return std::nullopt;
    } else {
      auto file = parsed_file(arguments[i]);
      if (!file) return std::nullopt;
      options.files.push_back(std::move(*file));
    }
  }
  return options;
}

void run(const Options& options) {
  std::vector<Row> rows;
  const auto take = [&](Volume volume) {
    Course course(std::move(volume));
    if (options.only) {
      for (int i = 0; i < options.repetitions; ++i) course.run(*options.only);
      return;
    }
    const Nanoseconds time = measure(course, options.repetitions);
    const Volume& done = course.volume();
    rows.push_back({{done.name, done.width, done.height, done.depth, done.threshold, {}},
                    time,
                    course.outcome()});
  };
  if (options.with_generated)
    for (Volume& volume : generated_volumes()) take(std::move(volume));
  for (const RawFile& file : options.files) take(read(file));
  if (!options.only) print_table(rows);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string_view> arguments(argv + (argc > 0 ? 1 : 0), argv + argc);
  if (std::find(arguments.begin(), arguments.end(), "--help") != arguments.end()) {
    std::printf("%s", usage);
    return 0;
  }
  const auto options = parsed_options(arguments);
  if (!options) {
    std::fprintf(stderr, "%s", usage);
    return 2;
  }
  try {
    run(*options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench: %s\n", error.what());
    return 1;
  }
  return 0;
}

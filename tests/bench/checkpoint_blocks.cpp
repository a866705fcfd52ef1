// What it would save to write only those blocks of a checkpoint that have changed.
//
//   bench_checkpoint_blocks cthead.nrrd:500 32768 98304

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <discmc/discmc.hpp>
#include <exception>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "volumes/volume.hpp"

using namespace discmc;
using namespace discmc::command;

namespace {

constexpr const char* usage =
    R"(usage: bench_checkpoint_blocks FILE:THRESHOLD BYTES...

Scans a volume in so many bytes of memory, with checkpoints in two slots in turn, and tells how many
of the memory's blocks differ from those that the slot held before, and how often the block does
that differs most often. FILE as discmc extract takes it; THRESHOLD is on stored samples.

Exit status: 0, or 1 if a file could not be read or scanned, or 2 for wrong arguments.
)";

constexpr uint32_t block_bytes[] = {256, 1024, 4096};
constexpr size_t sizes = std::size(block_bytes);

/// Two slots that are written in turn, each time after a number of rows.
class Slots {
 public:
  explicit Slots(uint64_t rows) : rows_(rows) {}

  bool is_due(uint64_t row) const { return row % rows_ == 0; }

  void save(const uint8_t* memory, size_t bytes) {
    std::vector<uint8_t>& slot = slots_[saves_++ % 2];
    used_ += bytes;
    if (!slot.empty())
      for (size_t size = 0; size < sizes; ++size) compare(slot, memory, bytes, size);
    slot.assign(memory, memory + bytes);
  }

  void print(const std::string& name) const {
    if (saves_ < 3) return;
    std::printf("| %s | %llu | %llu |", name.c_str(), static_cast<unsigned long long>(rows_),
                static_cast<unsigned long long>(used_ / saves_));
    for (size_t size = 0; size < sizes; ++size) {
      const auto& changes = changes_[size];
      const uint64_t most = *std::max_element(changes.begin(), changes.end());
      std::printf(" %.0f, %.0f |", percent(changed_[size], blocks_[size]),
                  percent(most, saves_ - 2));
    }
    std::printf("\n");
  }

 private:
  static double percent(uint64_t part, uint64_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(whole);
  }

  void compare(const std::vector<uint8_t>& slot, const uint8_t* memory, size_t bytes, size_t size) {
    for (size_t begin = 0; begin < bytes; begin += block_bytes[size]) {
      const size_t end = std::min<size_t>(bytes, begin + block_bytes[size]);
      const size_t block = begin / block_bytes[size];
      if (changes_[size].size() <= block) changes_[size].resize(block + 1);
      ++blocks_[size];
      if (end <= slot.size() && std::equal(memory + begin, memory + end, slot.data() + begin))
        continue;
      ++changed_[size];
      ++changes_[size][block];
    }
  }

  uint64_t rows_;
  std::vector<uint8_t> slots_[2];
  uint64_t saves_ = 0, used_ = 0;
  uint64_t blocks_[sizes] = {}, changed_[sizes] = {};
  std::vector<uint64_t> changes_[sizes];
};

void check(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

size_t drop(void*, const uint8_t*, size_t count) {
  return count;
}

template <class Sample>
void scan(VolumeReader& reader, int32_t threshold, size_t bytes) {
  const VolumeInfo& info = reader.info();
  std::vector<uint8_t> memory(bytes);
  const auto extractor = std::make_unique<Extractor16>();
  Encoder encoder;
  check(encoder.start({info.dims[2]}, {nullptr, drop}));
  check(extractor->start({info.dims[0], info.dims[1]}, threshold, {memory.data(), bytes},
                         make_sink(encoder)));
  Slots slots[] = {Slots(1), Slots(16), Slots(info.dims[1]), Slots(uint64_t{10} * info.dims[1])};
  std::vector<Sample> slice(reader.info().slice_bytes() / sizeof(Sample));
  uint64_t rows = 0;
  for (uint32_t z = 0; z < info.dims[2]; ++z) {
    reader.read_slice(slice.data());
    for (uint32_t y = 0; y < info.dims[1]; ++y) {
      check(extractor->push(&slice[size_t{y} * info.dims[0]], info.dims[0]).status);
      ++rows;
      for (Slots& some : slots)
        if (some.is_due(rows)) some.save(memory.data(), extractor->bytes_used());
    }
  }
  for (const Slots& some : slots) some.print(std::to_string(bytes));
}

bool parse(const std::string& digits, int64_t& number) {
  const char* const end = digits.data() + digits.size();
  const auto result = std::from_chars(digits.data(), end, number);
  return result.ec == std::errc() && result.ptr == end;
}

int fail_usage() {
  std::fputs(usage, stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) try {
  const std::string file = argc > 2 ? argv[1] : "";
  const size_t colon = file.rfind(':');
  int64_t threshold = 0;
  if (colon == std::string::npos || !parse(file.substr(colon + 1), threshold)) return fail_usage();
  std::printf("| memory | rows between checkpoints | bytes used |");
  for (const uint32_t bytes : block_bytes) std::printf(" blocks of %u: changed, most %% |", bytes);
  std::printf("\n|--:|--:|--:|--:|--:|--:|\n");
  for (int i = 2; i < argc; ++i) {
    int64_t bytes = 0;
    if (!parse(argv[i], bytes) || bytes < 0) return fail_usage();
    const auto reader = open_volume(file.substr(0, colon));
    with_scanner_type(reader->info().type, [&](auto type) {
      scan<decltype(type)>(*reader, static_cast<int32_t>(threshold), static_cast<size_t>(bytes));
    });
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench_checkpoint_blocks: %s\n", error.what());
  return 1;
}

// What the fuzz targets of the C API share: calls are made in C and in C++, and come to the same.
#ifndef DISCMC_FUZZ_BOTH_SIDES_HPP
#define DISCMC_FUZZ_BOTH_SIDES_HPP

#include <discmc/discmc.h>

#include <discmc/decoder.hpp>
#include <discmc/row_input.hpp>
#include <vector>

#include "input.hpp"
#include "oracle/c_events.hpp"
#include "oracle/scan.hpp"
#include "require.hpp"

/// Refuses at random, but on both sides alike.
class Refusals {
 public:
  void set(uint32_t of_256, uint32_t seed) {
    of_256_ = of_256;
    seed_ = seed;
  }
  bool refuses() {
    seed_ = seed_ * 1664525 + 1013904223;
    return seed_ >> 24 < of_256_;
  }

 private:
  uint32_t of_256_ = 0;
  uint32_t seed_ = 0;
};

/// Who takes the bytes of an encoder: some at a time.
struct RefusingLine {
  std::vector<uint8_t> bytes;
  Refusals refusals;
  size_t most = SIZE_MAX;

  static size_t write(void* context, const uint8_t* data, size_t count) {
    RefusingLine& line = *static_cast<RefusingLine*>(context);
    if (line.refusals.refuses()) return 0;
    const size_t taken = count < line.most ? count : line.most;
    line.bytes.insert(line.bytes.end(), data, data + taken);
    return taken;
  }
};

inline Refusals read_refusals(Input& input) {
  Refusals refusals;
  const uint32_t of_256 = input.byte();
  refusals.set(of_256, input.byte());
  return refusals;
}

/// A block of so many samples, whatever the input has left.
template <class Sample>
std::vector<Sample> read_samples(Input& input, size_t count) {
  std::vector<Sample> samples(count);
  for (Sample& sample : samples) sample = static_cast<Sample>(input.byte());
  return samples;
}

/// Some of a stream from a byte on, now and then with a bit that is wrong; all for a `what` of 0.
inline std::vector<uint8_t> some_of(const std::vector<uint8_t>& stream, size_t from, uint32_t what,
                                    Input& input) {
  const size_t there = stream.size() - from;
  const size_t most = what == 0 ? SIZE_MAX : size_t{4} * input.byte();
  const size_t count = there < most ? there : most;
  const auto begin = stream.begin() + static_cast<std::ptrdiff_t>(from);
  std::vector<uint8_t> bytes(begin, begin + static_cast<std::ptrdiff_t>(count));
  if (what >= 228 && count > 0) {
    uint8_t& damaged = bytes[input.byte() % count];
    damaged = static_cast<uint8_t>(damaged ^ 1U << what % 8);
  }
  return bytes;
}

/// Memory of one size for either side.
struct BothBlocks {
  explicit BothBlocks(uint64_t bytes)
      : c(bytes, discmc::reference::Block::Kind::exact),
        cpp(bytes, discmc::reference::Block::Kind::exact) {}
  discmc_memory memory_c() {
    const discmc::Memory memory = c.memory();
    return {memory.data, memory.bytes};
  }
  discmc::reference::Block c, cpp;
};

inline void require_same(discmc_status in_c, discmc::Status in_cpp) {
  require(in_c == static_cast<discmc_status>(in_cpp), "another status than in C++");
}
inline void require_same(discmc_push_result in_c, discmc::PushResult in_cpp) {
  require_same(in_c.status, in_cpp.status);
  require(in_c.samples == in_cpp.samples, "another number of samples taken than in C++");
}
inline void require_same(discmc_decoded in_c, discmc::Decoded in_cpp) {
  require_same(in_c.status, in_cpp.status);
  require(in_c.bytes == in_cpp.bytes, "another number of bytes taken than in C++");
}

inline void require_same(const discmc_stream_report& in_c, const discmc::StreamReport& in_cpp) {
  using discmc::reference::counts;
  require(in_c.is_complete == in_cpp.is_complete() && in_c.has_header == in_cpp.has_header &&
              in_c.has_trailer == in_cpp.has_trailer && in_c.abandoned == in_cpp.abandoned &&
              in_c.is_mixed == in_cpp.is_mixed && in_c.is_unreadable == in_cpp.is_unreadable &&
              in_c.holds_slices == in_cpp.holds_slices && in_c.slices == in_cpp.slices,
          "another report than in C++");
  require(in_c.bytes == in_cpp.bytes && in_c.packets == in_cpp.packets &&
              in_c.repeated_packets == in_cpp.repeated_packets &&
              in_c.damaged_packets == in_cpp.damaged_packets &&
              in_c.foreign_packets == in_cpp.foreign_packets &&
              in_c.lost_packets == in_cpp.lost_packets && in_c.regions == in_cpp.regions &&
              in_c.fragments == in_cpp.fragments && in_c.lost_pieces == in_cpp.lost_pieces &&
              in_c.rows == in_cpp.rows && in_c.lost_rows == in_cpp.lost_rows &&
              in_c.total_rows == in_cpp.total_rows,
          "other counts reported than in C++");
  require(counts(discmc::reference::from_c(in_c.totals)) == counts(in_cpp.totals),
          "other totals reported than in C++");
}

inline void require_same(const discmc_stream_header& in_c, const discmc::StreamHeader& in_cpp) {
  const discmc::StreamHeader same = discmc::reference::from_c(in_c);
  require(same.width == in_cpp.width && same.height == in_cpp.height &&
              same.depth == in_cpp.depth && same.spacing_nm[2] == in_cpp.spacing_nm[2] &&
              same.threshold == in_cpp.threshold && same.border == in_cpp.border &&
              same.scan == in_cpp.scan && same.channel == in_cpp.channel &&
              same.surfaces() == in_cpp.surfaces() &&
              same.further_thresholds[0] == in_cpp.further_thresholds[0],
          "another header than in C++");
}

#endif

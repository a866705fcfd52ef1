// Hashes the library's output for a fixed set of volumes: events, bytes of the streams, and decoded
// events. Every machine must print the same numbers (golden.txt).
//
// It runs in 16 KiB of RAM without a C library: see scripts/check/portability.
#include <board.hpp>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/normal_extractor.hpp>
#include <discmc/receiver.hpp>
#include <discmc/slice_encoder.hpp>

using namespace discmc;

namespace {

// ---- volumes: values from 0 to 255; on means at least `threshold` ----

constexpr uint32_t width = 33, height = 6, depth = 4;  // a row of bits has two words
constexpr int32_t threshold = 128;

struct Voxel {
  int32_t x, y, z;
};
using Volume = int32_t (*)(Voxel);

int32_t ball(Voxel v) {
  const Vertex from_centre{2 * v.x - 8, 2 * v.y - 5, 2 * v.z - 3};
  return dot_product(from_centre, from_centre) <= 49 ? 200 : 20;
}

// Blocks, one of them with a slanted corner.
int32_t bricks(Voxel v) {
  return (v.x / 9 + v.y / 4 + v.z / 5) % 2 == 0 && v.x + v.y + v.z > 7 ? 255 : 0;
}

int32_t checkerboard(Voxel v) {
  return (v.x + v.y + v.z) % 2 == 0 ? 128 : 127;
}

int32_t columns(Voxel v) {
  return (v.x + v.y) % 2 == 0 ? 255 : 0;
}

// Repeats one cell, one of those with the most links.
int32_t tiling(Voxel v) {
  return (61 >> (v.x % 2 + 2 * (v.y % 2) + 4 * (v.z % 2)) & 1) != 0 ? 129 : 1;
}

int32_t noise(Voxel v) {
  uint32_t mixed = static_cast<uint32_t>(v.x + 64 * v.y + 4096 * v.z) * 0x9E3779B9;
  mixed = (mixed ^ mixed >> 16) * 0x85EBCA6B;
  return static_cast<int32_t>(mixed >> 24);
}

constexpr Volume volumes[] = {ball, bricks, checkerboard, columns, tiling, noise};

// The same values as each type of sample.
template <class Sample>
constexpr Sample sample_of(int32_t value) {
  return static_cast<Sample>(value * 256);
}
template <>
constexpr uint8_t sample_of(int32_t value) {
  return static_cast<uint8_t>(value);
}
template <>
constexpr int16_t sample_of(int32_t value) {
  return static_cast<int16_t>((value - 128) * 256);
}

// ---- hashes ----

// FNV-1a, 64 bits, over bytes, and over words in little-endian order.
class Hash {
 public:
  void add(uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001B3; }
  void add_word(uint64_t word) {
    for (int i = 0; i < 8; ++i) add(static_cast<uint8_t>(word >> 8 * i));
  }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xCBF29CE484222325;
};

Hash golden;
uint32_t scans, events, fragments;

// A sink that hashes the members of each kind of event.
class EventHash {
 public:
  SinkResult accept(const Event& event) {
    add(static_cast<uint32_t>(event.kind));
    switch (event.kind) {
      case Event::Kind::region:
        add(event.incidence);
        break;
      case Event::Kind::ring:
        add(static_cast<uint32_t>(event.start.x));
        add(static_cast<uint32_t>(event.start.y));
        add(static_cast<uint32_t>(event.start.z));
        add(event.is_hole);
        break;
      case Event::Kind::run:
        add(event.run.code());
        add(event.normal.u);
        add(event.normal.v);
        break;
      case Event::Kind::fragment:
        add(event.incidence);
        add(event.incoming_direction);
        add(static_cast<uint32_t>(event.start.x));
        add(static_cast<uint32_t>(event.start.y));
        add(static_cast<uint32_t>(event.start.z));
        break;
      case Event::Kind::skipped:
        add(event.slice);
        add(event.row);
        add(event.is_repeated);
        break;
      case Event::Kind::layer:
        add(event.slice);
        break;
      case Event::Kind::finish:
        add(event.slice);
        add(event.is_abandoned);
        for (const auto total : detail::wire::trailer_totals) add(event.statistics->*total);
        break;
      case Event::Kind::start:  // an extractor sends fewer members of the header than a decoder
        return SinkResult::accepted;
      case Event::Kind::region_end:
      case Event::Kind::fragment_end:
      case Event::Kind::application:
      case Event::Kind::lost:
      case Event::Kind::fractions:
        break;
    }
    ++events_;
    return SinkResult::accepted;
  }
  uint64_t value() const { return hash_.value(); }
  uint32_t events() const { return events_; }

 private:
  void add(uint64_t word) { hash_.add_word(word); }

  Hash hash_;
  uint32_t events_ = 0;
};

// A line to a decoder that is busy every third time. Hashes its bytes, and the decoded events.
template <class Decoding>
class BusyLine {
 public:
  void start() {
    received_ = EventHash();
    good_ = true;
  }
  ByteOutput output() { return {this, write}; }
  Decoding& decoder() { return decoder_; }
  Sink sink() { return make_sink(received_); }
  /// Whether all bytes have arrived, and decode to these events.
  bool finish(uint64_t expected) {
    return decoder_.finish() == Status::ok && good_ && decoder_.report().is_complete() &&
           received_.value() == expected;
  }

 private:
  static size_t write(void* context, const uint8_t* bytes, size_t count) {
    return static_cast<BusyLine*>(context)->write(bytes, count);
  }
  size_t write(const uint8_t* bytes, size_t count) {
    if (++calls_ % 3 == 0) return 0;
    if (count > 13) count = 13;
    for (size_t i = 0; i < count; ++i) golden.add(bytes[i]);
    good_ = good_ && decoder_.push(bytes, count).status == Status::ok;
    return count;
  }

  Decoding decoder_;
  EventHash received_;
  uint32_t calls_ = 0;
  bool good_ = false;
};

// The sink of an extractor: hashes its events, and the events after an encoder and a decoder.
class Wire {
 public:
  bool start(const StreamHeader& header) {
    sent_ = EventHash();
    line_.start();
    encoder_.encode_normals();
    return encoder_.start(header.label(), line_.output()) == Status::ok &&
           line_.decoder().start(line_.sink()) == Status::ok;
  }
  SinkResult accept(const Event& event) {
    const SinkResult answer = encoder_.accept(event);
    if (answer == SinkResult::accepted) (void)sent_.accept(event);
    return answer;
  }
  bool finish() { return line_.finish(sent_.value()); }
  const EventHash& sent() const { return sent_; }

 private:
  Encoder encoder_;
  BusyLine<Decoder> line_;
  EventHash sent_;
};

// ---- scans ----

// Memory sizes: the minimum; enough for a part, so some fragments are loose; enough for most scans.
constexpr Capacities rooms[] = {minimum_capacities(), {100, 4}, {200, 0}, {400, 30}};
constexpr Limits sizes[] = {{width, height, Border::closed}, {width, height, Border::open}};

alignas(8) uint8_t memory[Extractor32::bytes_for(sizes[0], rooms[3])];
Wire wire_between;

template <class AnyExtractor, class Sample, bool has_normals>
class Scan {
 public:
  bool start(const Limits& limits, const Capacities& capacities) {
    if constexpr (has_normals) extractor_.set_spacing({1, -2, 3});
    const int32_t on_from = sample_of<Sample>(threshold);
    return wire_between.start({width, height, depth, {1, -2, 3}, {on_from}, limits.border}) &&
           is_done(extractor_.start(limits, capacities, on_from, memory_of(memory),
                                    make_sink(wire_between)));
  }

  // Pushes a row in one of the possible ways.
  bool push_row(Volume volume, int32_t y, int32_t z) {
    const auto value = [&](uint32_t x) { return volume({static_cast<int32_t>(x), y, z}); };
    switch (y % 4) {
      case 1: {
        if (has_normals) return push_samples(value, 7, 1);
        uint8_t bits[(width + 7) / 8] = {};
        for (uint32_t x = 0; x < width; ++x)
          if (value(x) >= threshold) bits[x / 8] = static_cast<uint8_t>(bits[x / 8] | 1 << x % 8);
        return push_bits(bits);
      }
      case 2:
        return push_samples(value, width, 2);
      case 3:
        if (z % 4 == 3)
          return is_done(
              extractor_.skip_row(y == 3 ? Substitute::off : Substitute::previous_row).status);
        return push_samples(value, 5, 1);
      default:
        return push_samples(value, width, 1);
    }
  }

  bool end(bool abandons) {
    const Status status = abandons ? extractor_.abandon() : extractor_.finish();
    if (!is_done(status) || !wire_between.finish()) return false;
    fragments += static_cast<uint32_t>(extractor_.statistics().fragments);
    return true;
  }

 private:
  bool is_done(Status status) {
    while (status == Status::suspended) status = extractor_.resume();
    return status == Status::ok;
  }

  bool push_bits([[maybe_unused]] const uint8_t* bits) {
    if constexpr (has_normals)
      return false;
    else
      return is_done(extractor_.push_bits(bits).status);
  }

  template <class Value>
  bool push_samples(const Value& value, uint32_t portion, uint32_t stride) {
    Sample row[2 * width] = {};
    for (uint32_t x = 0; x < width; ++x) row[x * stride] = sample_of<Sample>(value(x));
    for (uint32_t x = 0; x < width;) {
      const uint32_t left = width - x;
      const PushResult pushed =
          extractor_.push(row + x * stride, left < portion ? left : portion, stride);
      if (!is_done(pushed.status)) return false;
      x += pushed.samples;
    }
    return true;
  }

  AnyExtractor extractor_;
};

// Scans a volume. Fails if the hash of the events is not `expected`, unless that is 0. Not inlined,
// because all scans in one function need more stack than the smallest board has.
template <class AnyExtractor, class Sample, bool has_normals = false>
[[gnu::noinline]] bool scan(Volume volume, const Limits& limits, const Capacities& capacities,
                            uint64_t& expected) {
  static Scan<AnyExtractor, Sample, has_normals> scan;
  if (!scan.start(limits, capacities)) return false;
  // Scans of an open volume are abandoned in the middle of the last slice.
  const bool abandons = limits.border == Border::open;
  const uint32_t rows = height * depth - (abandons ? height / 2 : 0);
  for (uint32_t i = 0; i < rows; ++i)
    if (!scan.push_row(volume, static_cast<int32_t>(i % height), static_cast<int32_t>(i / height)))
      return false;
  if (!scan.end(abandons)) return false;
  ++scans;
  events += wire_between.sent().events();
  golden.add_word(wire_between.sent().value());
  if (expected == 0) expected = wire_between.sent().value();
  return wire_between.sent().value() == expected;
}

// Scans with normals. They depend on the samples, so these scans are not compared with others.
template <class Index, class Sample>
bool scan_with_normals(Volume volume, const Limits& limits) {
  uint64_t hash = 0;
  return scan<NormalExtractor<Index, Sample>, Sample, true>(volume, limits, rooms[1], hash);
}

// ---- slices ----

// Constructs an object in given memory. A freestanding system may lack the header <new>.
template <class Object>
struct InPlace : Object {
  static void* operator new(size_t, void* place) { return place; }
};

// A slice encoder, and a decoder that extracts the surface.
class SlicesBetween {
 public:
  bool start(const Limits& limits, Memory arena) {
    line_.start();
    return line_.decoder().start(arena, line_.sink()) == Status::ok &&
           encoder_.start({limits, {threshold}, 2, 1, {depth}}, memory_of(rows_), line_.output()) ==
               Status::ok;
  }
  SliceEncoder& encoder() { return encoder_; }
  bool finish(uint64_t expected) { return line_.finish(expected); }

 private:
  SliceEncoder encoder_;
  BusyLine<SurfaceDecoder> line_;
  uint8_t rows_[SliceEncoder::minimum_bytes({sizes[0], {}, 2})];
};

// Pushes a volume to an extractor or a slice encoder, with one row skipped, and ends the scan.
template <class Scanner>
bool push_volume(Scanner& scanner, Volume volume, bool abandons) {
  const auto is_done = [&](Status status) {
    while (status == Status::suspended) status = scanner.resume();
    return status == Status::ok;
  };
  const uint32_t rows = height * depth - (abandons ? height / 2 : 0);
  for (uint32_t i = 0; i < rows; ++i) {
    uint8_t row[width];
    for (uint32_t x = 0; x < width; ++x)
      row[x] =
          static_cast<uint8_t>(volume({static_cast<int32_t>(x), static_cast<int32_t>(i % height),
                                       static_cast<int32_t>(i / height)}));
    for (uint32_t pushed = 0; pushed == 0;) {  // a busy line may refuse the header first
      const PushResult result =
          i == height + 3 ? scanner.skip_row(Substitute::previous_row) : scanner.push(row, width);
      if (!is_done(result.status)) return false;
      pushed = result.samples;
    }
  }
  return is_done(abandons ? scanner.abandon() : scanner.finish());
}

// Compares the surface from slices with that of an extractor with the same memory. The objects lie
// in the memory of the other scans, because the smallest board has no more.
[[gnu::noinline]] bool scan_slices(Volume volume, const Limits& limits) {
  constexpr size_t of_rows = size_t{SliceDecoder::minimum_bytes(sizes[0])};
  constexpr size_t of_sweep = size_t{Extractor32::minimum_bytes(sizes[0])} + 900;
  static_assert(sizeof(SlicesBetween) + of_rows + of_sweep <= sizeof memory &&
                    sizeof(Extractor32) <= sizeof(SlicesBetween),
                "there is room");
  uint8_t* const arena = memory + sizeof(SlicesBetween);
  static EventHash alone;
  alone = EventHash();
  const bool abandons = limits.border == Border::open;
  auto* const extractor = new (memory) InPlace<Extractor32>;
  if (extractor->start(limits, threshold, {arena, of_sweep}, make_sink(alone)) != Status::ok ||
      !push_volume(*extractor, volume, abandons))
    return false;
  auto* const between = new (memory) InPlace<SlicesBetween>;
  if (!between->start(limits, {arena, of_rows + of_sweep}) ||
      !push_volume(between->encoder(), volume, abandons) || !between->finish(alone.value()))
    return false;
  ++scans;
  golden.add_word(alone.value());
  return true;
}

// ---- fractions ----

// The stream with fractions, in the memory of the other scans.
struct Stored {
  uint8_t bytes[1600];
  size_t count;

  ByteOutput output() {
    return {this, [](void* context, const uint8_t* from, size_t given) {
              auto& stored = *static_cast<Stored*>(context);
              for (size_t i = 0; i < given && stored.count < sizeof stored.bytes; ++i) {
                golden.add(from[i]);
                stored.bytes[stored.count++] = from[i];
              }
              return given;
            }};
  }
};

// Hashes the contents of a row event.
SinkResult hash_row(void*, const RowEvent& event) {
  golden.add_word(static_cast<uint64_t>(event.kind));
  if (event.kind == RowEvent::Kind::row)
    for (uint32_t i = 0; i < (width + 7) / 8; ++i) golden.add(event.bits[i]);
  if (event.kind == RowEvent::Kind::fractions)
    for (uint32_t x = 0; x < width; ++x) golden.add_word(event.fractions[x]);
  return SinkResult::accepted;
}

template <uint8_t levels>
[[gnu::noinline]] bool scan_fractions(Volume volume) {
  using Slices = FractionSliceEncoder<uint8_t>;
  constexpr SliceEncoderConfig config{sizes[0], {threshold}, 2, 1, {depth}, levels};
  constexpr size_t of_encoder = Slices::minimum_bytes(config);
  constexpr size_t of_decoder = SliceDecoder::minimum_bytes(sizes[0], 1, levels);
  static_assert(sizeof(Stored) + sizeof(Slices) + of_encoder <= sizeof memory &&
                    sizeof(Stored) + sizeof(SliceDecoder) + of_decoder <= sizeof memory,
                "there is room");
  auto* const stored = new (memory) InPlace<Stored>;
  stored->count = 0;
  uint8_t* const rest = memory + sizeof(Stored);
  auto* const encoder = new (rest) InPlace<Slices>;
  if (encoder->start(config, {rest + sizeof(Slices), of_encoder}, stored->output()) != Status::ok ||
      !push_volume(*encoder, volume, false))
    return false;
  auto* const decoder = new (rest) InPlace<SliceDecoder>;
  if (decoder->start({rest + sizeof(SliceDecoder), of_decoder}, {nullptr, hash_row}) !=
          Status::ok ||
      decoder->push(stored->bytes, stored->count).status != Status::ok ||
      decoder->finish() != Status::ok || !decoder->report().is_complete())
    return false;
  ++scans;
  return true;
}

// Scans every volume in every memory, with alternating borders.
bool scan_all() {
  uint32_t turn = 0;
  for (const Volume volume : volumes) {
    ++turn;
    for (const Capacities& capacities : rooms) {
      const Limits limits = sizes[turn++ % 2];
      uint64_t hash = 0;
      if (!scan<Extractor16, uint8_t>(volume, limits, capacities, hash) ||
          !scan<Extractor32, uint16_t>(volume, limits, capacities, hash) ||
          !scan<Extractor16, int16_t>(volume, limits, capacities, hash))
        return false;
    }
    if (!scan_with_normals<uint16_t, uint8_t>(volume, sizes[turn % 2]) ||
        !scan_with_normals<uint32_t, uint16_t>(volume, sizes[turn % 2]) ||
        !scan_with_normals<uint16_t, int16_t>(volume, sizes[turn % 2]))
      return false;
    if (!scan_slices(volume, sizes[0]) || !scan_slices(volume, sizes[1])) return false;
    if (!scan_fractions<2>(volume) || !scan_fractions<4>(volume)) return false;
  }
  return true;
}

}  // namespace

int main() {
  const bool good = scan_all();
  board::report("scans", scans);
  board::report("events", events);
  board::report("fragments", fragments);
  board::report("hash_high", static_cast<uint32_t>(golden.value() >> 32));
  board::report("hash_low", static_cast<uint32_t>(golden.value()));
  board::stop(good);
}

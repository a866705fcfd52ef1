// Fuzz target. The promise: whatever is called through C, in whatever order, on objects and memory
// of exactly their size, comes to the statuses, events and bytes that the same calls come to in
// C++, and touches nothing else; the rings of the extractor come apart into simple ones of the same
// area.
//
//   fuzz_c_api -max_len=800 corpus/c_api      with libFuzzer
//   fuzz_c_api corpus/c_api                   with replay_main.cpp

#include <discmc/discmc.h>

#include <discmc/discmc.hpp>
#include <memory>

#include "input.hpp"
#include "oracle/c_events.hpp"
#include "oracle/scan.hpp"
#include "require.hpp"

using namespace discmc;
using reference::Block;
using reference::counts;
using reference::Events;
using reference::from_c;

namespace {

/// Refuses at random, but on both sides alike.
class Mood {
 public:
  void set(uint32_t refusals, uint32_t seed) {
    refusals_ = refusals;
    seed_ = seed;
  }
  bool refuses() {
    seed_ = seed_ * 1664525 + 1013904223;
    return seed_ >> 24 < refusals_;
  }

 private:
  uint32_t refusals_ = 0;
  uint32_t seed_ = 0;
};

/// Who takes the bytes of an encoder: some at a time.
struct Line {
  std::vector<uint8_t> bytes;
  Mood mood;
  size_t most = SIZE_MAX;

  static size_t write(void* context, const uint8_t* data, size_t count) {
    Line& line = *static_cast<Line*>(context);
    if (line.mood.refuses()) return 0;
    const size_t taken = count < line.most ? count : line.most;
    line.bytes.insert(line.bytes.end(), data, data + taken);
    return taken;
  }
};

// ---- geometry, in arrays of exactly their size ----

void check_ring(uint8_t incidence, discmc_vertex start, std::vector<discmc_run> runs) {
  const auto count = static_cast<uint32_t>(runs.size());
  require(discmc_is_closed(incidence, runs.data(), count) == 1, "a ring that is not closed");
  const int64_t area = discmc_twice_area(incidence, runs.data(), count);
  const auto links = static_cast<uint32_t>(discmc_link_count(runs.data(), count));
  std::vector<discmc_vertex> vertices(links);
  discmc_unfold(incidence, start, runs.data(), count, vertices.data());
  require(discmc_twice_area_of_ring(incidence, vertices.data(), links) == area,
          "a chain and its vertices have different areas");

  struct Sum {
    uint8_t incidence;
    int64_t area;
  } sum{incidence, 0};
  const discmc_ring_receiver receiver = {
      &sum, [](void* context, const discmc_vertex* ring, uint32_t length) {
        Sum& to = *static_cast<Sum*>(context);
        require(length >= 3, "a simple ring of fewer than three vertices");
        const int64_t part = discmc_twice_area_of_ring(to.incidence, ring, length);
        require(part != 0, "a simple ring without an area");
        to.area += part;
        std::vector<discmc_vertex> corners(ring, ring + length);
        const uint32_t left = discmc_keep_corners(corners.data(), length, nullptr, nullptr);
        require(left >= 3 && left <= length, "a ring of another number of corners");
        require(discmc_twice_area_of_ring(to.incidence, corners.data(), left) == part,
                "corners alone have another area");
      }};
  std::vector<uint32_t> scratch(size_t{2} * links);
  discmc_split_ring(vertices.data(), links, scratch.data(), &receiver);
  require(sum.area == area, "simple rings have another area than their ring");
  discmc_reverse(incidence, runs.data(), count);
  require(discmc_twice_area(incidence, runs.data(), count) == -area, "turned round, another area");
}

/// Puts the rings of regions together.
class Rings {
 public:
  void take(const discmc_event& event) {
    if (event.kind == DISCMC_RING || event.kind == DISCMC_REGION_END) end_ring();
    if (event.kind == DISCMC_REGION) incidence_ = event.incidence;
    if (event.kind == DISCMC_RING) {
      start_ = event.start;
      is_whole_ = true;
    }
    if (event.kind == DISCMC_RUN) runs_.push_back(event.run);
    if (event.kind == DISCMC_FRAGMENT_END) runs_.clear();
  }
  void forget() {
    runs_.clear();
    is_whole_ = false;
  }

 private:
  void end_ring() {
    if (is_whole_) check_ring(incidence_, start_, runs_);
    forget();
  }

  uint8_t incidence_ = 0;
  discmc_vertex start_{};
  std::vector<discmc_run> runs_;
  bool is_whole_ = false;
};

// ---- the two sides ----

/// A sink on either side: notes what it takes, and passes it on to an encoder that may refuse too.
struct EarInC {
  Mood mood;
  Events events;
  discmc_encoder* encoder = nullptr;
  Rings* rings = nullptr;

  static discmc_answer take(void* context, const discmc_event* event) {
    EarInC& ear = *static_cast<EarInC*>(context);
    if (ear.mood.refuses()) return DISCMC_NOT_NOW;
    if (ear.encoder != nullptr && discmc_encoder_take(ear.encoder, event) != DISCMC_TAKEN)
      return DISCMC_NOT_NOW;
    ear.events.push_back(from_c(*event));
    if (ear.rings != nullptr) ear.rings->take(*event);
    return DISCMC_TAKEN;
  }
};
struct EarInCpp {
  Mood mood;
  Events events;
  Encoder* encoder = nullptr;

  Answer take(const Event& event) {
    if (mood.refuses()) return Answer::not_now;
    if (encoder != nullptr && encoder->take(event) != Answer::taken) return Answer::not_now;
    events.emplace_back(event);
    return Answer::taken;
  }
};

/// The functions of one width of index, under one name.
struct Width16 {
  using Index = uint16_t;
  using Object = discmc_extractor16;
  static constexpr auto start = discmc_extractor16_start;
  static constexpr auto reset = discmc_extractor16_reset;
  static constexpr auto push_u8 = discmc_extractor16_push_u8;
  static constexpr auto push_u16 = discmc_extractor16_push_u16;
  static constexpr auto push_i16 = discmc_extractor16_push_i16;
  static constexpr auto push_bits = discmc_extractor16_push_bits;
  static constexpr auto skip_row = discmc_extractor16_skip_row;
  static constexpr auto resume = discmc_extractor16_resume;
  static constexpr auto finish = discmc_extractor16_finish;
  static constexpr auto abandon = discmc_extractor16_abandon;
  static constexpr auto statistics = discmc_extractor16_statistics;
  static constexpr auto limits = discmc_extractor16_limits;
  static constexpr auto capacities = discmc_extractor16_capacities;
  static constexpr auto high_water = discmc_extractor16_high_water;
  static constexpr auto bytes_used = discmc_extractor16_bytes_used;
  static constexpr auto slices = discmc_extractor16_slices;
  static constexpr auto rows = discmc_extractor16_rows;
  static constexpr auto bytes_for = discmc_bytes_for16;
  static constexpr auto minimum_bytes = discmc_minimum_bytes16;
  static constexpr auto are_valid = discmc_capacities_are_valid16;
  static constexpr auto default_capacities = discmc_default_capacities16;
};
struct Width32 {
  using Index = uint32_t;
  using Object = discmc_extractor32;
  static constexpr auto start = discmc_extractor32_start;
  static constexpr auto reset = discmc_extractor32_reset;
  static constexpr auto push_u8 = discmc_extractor32_push_u8;
  static constexpr auto push_u16 = discmc_extractor32_push_u16;
  static constexpr auto push_i16 = discmc_extractor32_push_i16;
  static constexpr auto push_bits = discmc_extractor32_push_bits;
  static constexpr auto skip_row = discmc_extractor32_skip_row;
  static constexpr auto resume = discmc_extractor32_resume;
  static constexpr auto finish = discmc_extractor32_finish;
  static constexpr auto abandon = discmc_extractor32_abandon;
  static constexpr auto statistics = discmc_extractor32_statistics;
  static constexpr auto limits = discmc_extractor32_limits;
  static constexpr auto capacities = discmc_extractor32_capacities;
  static constexpr auto high_water = discmc_extractor32_high_water;
  static constexpr auto bytes_used = discmc_extractor32_bytes_used;
  static constexpr auto slices = discmc_extractor32_slices;
  static constexpr auto rows = discmc_extractor32_rows;
  static constexpr auto bytes_for = discmc_bytes_for32;
  static constexpr auto minimum_bytes = discmc_minimum_bytes32;
  static constexpr auto are_valid = discmc_capacities_are_valid32;
  static constexpr auto default_capacities = discmc_default_capacities32;
};

void require_same(discmc_status in_c, Status in_cpp) {
  require(in_c == static_cast<discmc_status>(in_cpp), "another status than in C++");
}
void require_same(discmc_pushed in_c, Pushed in_cpp) {
  require_same(in_c.status, in_cpp.status);
  require(in_c.samples == in_cpp.samples, "another number of samples taken than in C++");
}
template <class InC, class InCpp>
void require_same_records(const InC& in_c, const InCpp& in_cpp) {
  require(in_c.edges == in_cpp.edges && in_c.runs == in_cpp.runs && in_c.rings == in_cpp.rings &&
              in_c.regions == in_cpp.regions && in_c.slots == in_cpp.slots,
          "other numbers of records than in C++");
}

/// Makes every call twice, in C and in C++.
template <class Width>
class Both {
 public:
  explicit Both(Input& input) : input_(input) {}

  void run() {
    while (!input_.is_empty()) {
      call();
      compare();
    }
    const Mood willing;
    ear_c_.mood = ear_cpp_.mood = heard_c_.mood = heard_cpp_.mood = willing;
    line_c_.mood = line_cpp_.mood = willing;
    abandon();
    flush();
    push_stream(0);
    finish_decoder();
    look();
    compare();
  }

 private:
  using Index = typename Width::Index;

  void call() {
    const uint32_t what = input_.byte();
    if (what < 16) return start();
    if (what < 20) return reset();
    if (what < 28) return change_mood();
    if (what < 36) return resume();
    if (what < 44) return finish();
    if (what < 48) return abandon();
    if (what < 64) return skip_row();
    if (what < 96) return push_bits();
    if (what < 128) return push(Width::push_u8);
    if (what < 144) return push(Width::push_u16);
    if (what < 160) return push(Width::push_i16);
    if (what < 176) return start_encoder();
    if (what < 192) return flush();
    if (what < 208) return start_decoder();
    if (what < 232) return push_stream(what);
    if (what < 240) return push_any_bytes();
    if (what < 248) return finish_decoder();
    look();
  }

  // ---- the extractor ----

  void start() {
    const uint32_t flags = input_.byte();
    const discmc_limits limits = {1 + input_.byte() % 12, 1 + input_.byte() % 6,
                                  static_cast<uint8_t>(flags & 1)};
    discmc_capacities capacities = discmc_minimum_capacities();
    capacities.edges += input_.byte();
    capacities.runs += input_.byte();
    capacities.rings += input_.below(16);
    capacities.regions += input_.byte();
    capacities.slots += input_.byte();
    if (flags >= 0xF8) capacities.runs = flags;
    const bool is_split = (flags & 2) != 0;
    uint64_t bytes = Width::minimum_bytes(&limits) + 8 * input_.byte();
    if (!is_split) bytes = Width::bytes_for(&limits, &capacities);
    if ((flags & 0x38) == 0x38) bytes -= 1 + input_.byte();
    const bool takes_fragments = (flags & 4) == 0;
    const int32_t threshold = static_cast<int32_t>(input_.byte()) - 2;

    auto block_c = std::make_unique<Block>(bytes, Block::Kind::exact);
    auto block_cpp = std::make_unique<Block>(bytes, Block::Kind::exact);
    const Memory memory = block_c->memory();
    const discmc_sink sink = {&ear_c_, EarInC::take, static_cast<uint8_t>(takes_fragments)};
    const discmc_status in_c =
        Width::start(extractor_.get(), &limits, is_split ? nullptr : &capacities, threshold,
                     {memory.data, memory.bytes}, &sink);
    const Limits cpp_limits{limits.width, limits.height, static_cast<Border>(limits.border)};
    const Capacities cpp_capacities{capacities.edges, capacities.runs, capacities.rings,
                                    capacities.regions, capacities.slots};
    const Sink cpp_sink = sink_to(ear_cpp_, takes_fragments);
    const Status in_cpp =
        is_split
            ? in_cpp_.start(cpp_limits, threshold, block_cpp->memory(), cpp_sink)
            : in_cpp_.start(cpp_limits, cpp_capacities, threshold, block_cpp->memory(), cpp_sink);
    require_same(in_c, in_cpp);
    require((Width::are_valid(&capacities) != 0) == are_valid<Index>(cpp_capacities),
            "capacities are valid on one side");
    require_same_records(Width::default_capacities(&limits, bytes),
                         default_capacities<Index>(cpp_limits, bytes));
    if (in_c != DISCMC_OK) return;
    block_c_ = std::move(block_c);
    block_cpp_ = std::move(block_cpp);
    width_ = limits.width;
    ear_c_.encoder = (flags & 0x40) != 0 ? encoder_.get() : nullptr;
    ear_cpp_.encoder = (flags & 0x40) != 0 ? &encoder_cpp_ : nullptr;
    begin();
  }

  void begin() { rings_.forget(); }

  void reset() {
    const discmc_status in_c = Width::reset(extractor_.get());
    require_same(in_c, in_cpp_.reset());
    begin();
  }

  void change_mood() {
    Mood mood;
    const uint32_t refusals = input_.byte();
    mood.set(refusals, input_.byte());
    const uint32_t whose = input_.below(3);
    if (whose == 0) ear_c_.mood = ear_cpp_.mood = mood;
    if (whose == 1) heard_c_.mood = heard_cpp_.mood = mood;
    if (whose == 2) line_c_.mood = line_cpp_.mood = mood;
    if (whose == 2) line_c_.most = line_cpp_.most = size_t{1} + input_.byte();
  }

  void resume() { require_same(Width::resume(extractor_.get()), in_cpp_.resume()); }
  void finish() { require_same(Width::finish(extractor_.get()), in_cpp_.finish()); }
  void abandon() { require_same(Width::abandon(extractor_.get()), in_cpp_.abandon()); }

  void skip_row() {
    const auto substitute = static_cast<uint8_t>(input_.byte() % 2);
    require_same(Width::skip_row(extractor_.get(), substitute),
                 in_cpp_.skip_row(static_cast<Substitute>(substitute)));
  }

  void push_bits() {
    const std::vector<uint8_t> bits = exactly((width_ + 7) / 8);
    require_same(Width::push_bits(extractor_.get(), bits.data()), in_cpp_.push_bits(bits.data()));
  }

  template <class Sample>
  void push(discmc_pushed (*in_c)(typename Width::Object*, const Sample*, uint32_t, uint32_t)) {
    const uint32_t count = input_.byte() % 40;
    const uint32_t stride = 1 + input_.below(3);
    std::vector<Sample> samples(count == 0 ? 0 : (count - 1) * stride + 1);
    for (Sample& sample : samples) sample = static_cast<Sample>(input_.byte());
    require_same(in_c(extractor_.get(), samples.data(), count, stride),
                 in_cpp_.push(samples.data(), count, stride));
  }

  // ---- the stream ----

  void start_encoder() {
    discmc_stream_header header = {};
    header.width = input_.byte();
    header.height = 1 + input_.byte();
    header.depth = input_.number(UINT32_MAX);
    for (int32_t& spacing : header.spacing_nm)
      spacing = static_cast<int32_t>(input_.number(INT32_MAX)) - 1000;
    header.border = static_cast<uint8_t>(input_.below(2));
    const bool has_output = input_.byte() < 250;
    StreamHeader cpp_header;
    cpp_header.width = header.width;
    cpp_header.height = header.height;
    cpp_header.depth = header.depth;
    for (int i = 0; i < 3; ++i) cpp_header.spacing_nm[i] = header.spacing_nm[i];
    cpp_header.border = static_cast<Border>(header.border);
    const auto write = has_output ? Line::write : nullptr;
    const discmc_status in_c = discmc_encoder_start(encoder_.get(), &header, {&line_c_, write});
    require_same(in_c, encoder_cpp_.start(cpp_header, {&line_cpp_, write}));
  }

  void flush() {
    const bool in_c = discmc_encoder_flush(encoder_.get()) != 0;
    require(in_c == encoder_cpp_.flush(), "flush() comes to something else than in C++");
  }

  void start_decoder() {
    const bool has_sink = input_.byte() < 250;
    const discmc_sink sink = {&heard_c_, has_sink ? EarInC::take : nullptr, 1};
    Sink cpp_sink = sink_to(heard_cpp_);
    if (!has_sink) cpp_sink.take = nullptr;
    const discmc_status in_c = discmc_decoder_start(decoder_.get(), &sink);
    require_same(in_c, decoder_cpp_.start(cpp_sink));
    if (in_c == DISCMC_OK) arrived_ = 0;
  }

  // Some of what the encoder has sent, now and then with a bit that is wrong.
  void push_stream(uint32_t what) {
    const size_t there = line_c_.bytes.size() - arrived_;
    const size_t most = what == 0 ? SIZE_MAX : size_t{4} * input_.byte();
    const size_t count = there < most ? there : most;
    const auto begin = line_c_.bytes.begin() + static_cast<std::ptrdiff_t>(arrived_);
    std::vector<uint8_t> bytes(begin, begin + static_cast<std::ptrdiff_t>(count));
    if (what >= 228 && count > 0) {
      uint8_t& damaged = bytes[input_.byte() % count];
      damaged = static_cast<uint8_t>(damaged ^ 1U << what % 8);
    }
    arrived_ += push_bytes(bytes);
  }

  void push_any_bytes() { push_bytes(input_.bytes(input_.byte())); }

  size_t push_bytes(const std::vector<uint8_t>& bytes) {
    const discmc_decoded in_c = discmc_decoder_push(decoder_.get(), bytes.data(), bytes.size());
    const Decoded in_cpp = decoder_cpp_.push(bytes.data(), bytes.size());
    require_same(in_c.status, in_cpp.status);
    require(in_c.bytes == in_cpp.bytes, "another number of bytes taken than in C++");
    require(in_c.bytes <= bytes.size(), "more bytes taken than given");
    return in_c.bytes;
  }

  void finish_decoder() {
    require_same(discmc_decoder_finish(decoder_.get()), decoder_cpp_.finish());
  }

  // ---- comparing ----

  void compare() {
    require(ear_c_.events == ear_cpp_.events, "other events than in C++");
    require(heard_c_.events == heard_cpp_.events, "other events decoded than in C++");
    require(line_c_.bytes == line_cpp_.bytes, "other bytes than in C++");
    require(discmc_encoder_bytes(encoder_.get()) == encoder_cpp_.bytes(),
            "another number of bytes sent than in C++");
    ear_c_.events.clear();
    ear_cpp_.events.clear();
    heard_c_.events.clear();
    heard_cpp_.events.clear();
  }

  void look() const {
    const auto* extractor = extractor_.get();
    require(counts(from_c(Width::statistics(extractor))) == counts(in_cpp_.statistics()),
            "other totals than in C++");
    require_same_records(Width::high_water(extractor), in_cpp_.high_water());
    require_same_records(Width::capacities(extractor), in_cpp_.capacities());
    const discmc_limits limits = Width::limits(extractor);
    require(limits.width == in_cpp_.limits().width && limits.height == in_cpp_.limits().height,
            "other limits than in C++");
    require(block_c_ == nullptr || Width::bytes_used(extractor) <= block_c_->memory().bytes,
            "more bytes in use than were given");
    require(
        Width::slices(extractor) == in_cpp_.slices() && Width::rows(extractor) == in_cpp_.rows(),
        "other rows counted than in C++");
    look_at_decoder();
  }

  void look_at_decoder() const {
    const discmc_stream_report in_c = discmc_decoder_report(decoder_.get());
    const StreamReport& in_cpp = decoder_cpp_.report();
    require(in_c.is_complete == in_cpp.is_complete() && in_c.has_header == in_cpp.has_header &&
                in_c.has_trailer == in_cpp.has_trailer && in_c.abandoned == in_cpp.abandoned &&
                in_c.is_unreadable == in_cpp.is_unreadable && in_c.slices == in_cpp.slices,
            "another report than in C++");
    require(in_c.bytes == in_cpp.bytes && in_c.packets == in_cpp.packets &&
                in_c.repeated_packets == in_cpp.repeated_packets &&
                in_c.damaged_packets == in_cpp.damaged_packets &&
                in_c.lost_packets == in_cpp.lost_packets && in_c.regions == in_cpp.regions &&
                in_c.fragments == in_cpp.fragments && in_c.lost_pieces == in_cpp.lost_pieces,
            "other counts reported than in C++");
    require(counts(from_c(in_c.totals)) == counts(in_cpp.totals),
            "other totals reported than in C++");
    const discmc_stream_header header = discmc_decoder_header(decoder_.get());
    require(header.width == decoder_cpp_.header().width &&
                header.spacing_nm[2] == decoder_cpp_.header().spacing_nm[2] &&
                header.border == static_cast<uint8_t>(decoder_cpp_.header().border),
            "another header than in C++");
  }

  // A block of so many bytes, whatever the input has left.
  std::vector<uint8_t> exactly(size_t count) {
    std::vector<uint8_t> bytes(count);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(input_.byte());
    return bytes;
  }

  Input& input_;
  uint32_t width_ = 1;
  Rings rings_;
  Line line_c_, line_cpp_;
  EarInC ear_c_{{}, {}, nullptr, &rings_};  // of the extractor
  EarInCpp ear_cpp_;
  EarInC heard_c_;  // of the decoder
  EarInCpp heard_cpp_;
  std::unique_ptr<Block> block_c_, block_cpp_;
  // On the heap, where the next byte is no one's.
  std::unique_ptr<typename Width::Object> extractor_ = std::make_unique<typename Width::Object>();
  std::unique_ptr<discmc_encoder> encoder_ = std::make_unique<discmc_encoder>();
  std::unique_ptr<discmc_decoder> decoder_ = std::make_unique<discmc_decoder>();
  Extractor<Index> in_cpp_;
  Encoder encoder_cpp_;
  Decoder decoder_cpp_{};
  size_t arrived_ = 0;  // bytes of the stream that the decoder has taken
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  if (input.below(2) != 0)
    Both<Width32>(input).run();
  else
    Both<Width16>(input).run();
  return 0;
}

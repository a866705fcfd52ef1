// Fuzz target. The promise: whatever is called through C, in whatever order, on objects and memory
// of exactly their size, comes to the statuses, events and bytes that the same calls come to in
// C++, and touches nothing else; the rings of the extractor come apart into simple ones of the same
// area.
//
//   fuzz_c_api -max_len=800 corpus/c_api      with libFuzzer
//   fuzz_c_api corpus/c_api                   with replay_main.cpp

#include <discmc/discmc.hpp>
#include <memory>

#include "both_sides.hpp"
#include "input.hpp"
#include "oracle/scan.hpp"

using namespace discmc;
using reference::counts;
using reference::Events;
using reference::from_c;

namespace {

// ---- geometry, in arrays of exactly their size ----

void check_ring(uint8_t incidence, discmc_vertex start, std::vector<discmc_run> runs) {
  const auto count = static_cast<uint32_t>(runs.size());
  require(discmc_is_closed(incidence, runs.data(), count) == 1, "a ring that is not closed");
  const int64_t area = discmc_twice_area(incidence, runs.data(), count);
  const auto link_total = static_cast<uint32_t>(discmc_link_count(runs.data(), count));
  std::vector<discmc_vertex> vertices(link_total);
  discmc_unfold(incidence, start, runs.data(), count, vertices.data());
  require(discmc_twice_area_of_ring(incidence, vertices.data(), link_total) == area,
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
  std::vector<uint32_t> scratch(size_t{2} * link_total);
  discmc_split_ring(vertices.data(), link_total, scratch.data(), &receiver);
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
struct SinkInC {
  Refusals refusals;
  Events events;
  discmc_encoder* encoder = nullptr;
  Rings* rings = nullptr;

  static discmc_answer take(void* context, const discmc_event* event) {
    SinkInC& sink = *static_cast<SinkInC*>(context);
    if (sink.refusals.refuses()) return DISCMC_NOT_NOW;
    if (sink.encoder != nullptr && discmc_encoder_take(sink.encoder, event) != DISCMC_TAKEN)
      return DISCMC_NOT_NOW;
    sink.events.push_back(from_c(*event));
    if (sink.rings != nullptr) sink.rings->take(*event);
    return DISCMC_TAKEN;
  }
};
struct SinkInCpp {
  Refusals refusals;
  Events events;
  Encoder* encoder = nullptr;

  Answer take(const Event& event) {
    if (refusals.refuses()) return Answer::not_now;
    if (encoder != nullptr && encoder->take(event) != Answer::taken) return Answer::not_now;
    events.emplace_back(event);
    return Answer::taken;
  }
};

template <class InC, class InCpp>
void require_same_records(const InC& in_c, const InCpp& in_cpp) {
  require(in_c.records == in_cpp.records && in_c.holes == in_cpp.holes,
          "other numbers of records than in C++");
}

/// Who takes packets of records, on either side.
struct Packets {
  std::vector<std::vector<uint8_t>> payloads;
  std::vector<uint32_t> pieces;

  template <class Packet>
  void add(const Packet& packet) {
    payloads.emplace_back(packet.payload, packet.payload + packet.bytes);
    pieces.push_back(packet.pieces << 1 | (packet.is_whole ? 1U : 0U));
  }
  static void take_in_c(void* context, const discmc_records_packet* packet) {
    static_cast<Packets*>(context)->add(*packet);
  }
  static void take_in_cpp(void* context, const RecordsPacket& packet) {
    static_cast<Packets*>(context)->add(packet);
  }
};

// ---- extractors with normals ----

discmc_push_result push(discmc_normal_extractor& extractor, const uint8_t* samples,
                        uint32_t count) {
  return discmc_normal_extractor_push_u8(&extractor, samples, count, 1);
}
discmc_push_result push(discmc_normal_extractor& extractor, const uint16_t* samples,
                        uint32_t count) {
  return discmc_normal_extractor_push_u16(&extractor, samples, count, 1);
}
discmc_push_result push(discmc_normal_extractor& extractor, const int16_t* samples,
                        uint32_t count) {
  return discmc_normal_extractor_push_i16(&extractor, samples, count, 1);
}

/// A scan with normals, on either side. The object of C has been of any kind before.
template <class Index, class Sample>
class BothNormals {
 public:
  BothNormals(Input& input, discmc_normal_extractor& in_c, const discmc_normal_kind& kind)
      : input_(input), in_c_(in_c), kind_(kind) {}

  void run() {
    if (!is_started()) return;
    const uint32_t rows = input_.below(40);
    for (uint32_t row = 0; row < rows; ++row) take_row();
    finish();
    require(c_.events == cpp_.events, "other events with normals than in C++");
    require(
        counts(from_c(discmc_normal_extractor_statistics(&in_c_))) == counts(in_cpp_.statistics()),
        "other totals with normals than in C++");
    require_same_records(discmc_normal_extractor_high_water(&in_c_), in_cpp_.high_water());
    require(discmc_normal_extractor_bytes_used(&in_c_) == in_cpp_.bytes_used() &&
                discmc_normal_extractor_slices(&in_c_) == in_cpp_.slices() &&
                discmc_normal_extractor_rows(&in_c_) == in_cpp_.rows(),
            "other bytes or rows with normals than in C++");
  }

 private:
  bool is_started() {
    width_ = 1 + input_.below(12);
    const discmc_limits limits = {
        width_, 1 + input_.below(6), static_cast<uint8_t>(input_.below(2)), {}};
    discmc_capacities capacities = discmc_minimum_capacities();
    capacities.records += input_.byte();
    capacities.holes += input_.below(16);
    const int32_t spacing_nm[3] = {static_cast<int32_t>(input_.byte()) - 100, 100,
                                   static_cast<int32_t>(input_.byte()) - 20};
    c_.refusals = cpp_.refusals = read_refusals(input_);
    const int32_t threshold = static_cast<int32_t>(input_.byte()) - 2;
    blocks_ = std::make_unique<BothBlocks>(
        discmc_normal_extractor_bytes_for(&kind_, &limits, &capacities));
    const discmc_sink sink = {&c_, SinkInC::take};
    discmc_normal_extractor_set_spacing(&in_c_, &kind_, spacing_nm);
    in_cpp_.set_spacing(spacing_nm);
    const discmc_status in_c = discmc_normal_extractor_start(&in_c_, &kind_, &limits, &capacities,
                                                             threshold, blocks_->memory_c(), &sink);
    require_same(in_c, in_cpp_.start({width_, limits.height, static_cast<Border>(limits.border)},
                                     {capacities.records, capacities.holes}, threshold,
                                     blocks_->cpp.memory(), sink_to(cpp_)));
    return in_c == DISCMC_OK;
  }

  void take_row() {
    const uint32_t what = input_.below(16);
    if (what == 0) {
      require_same(discmc_normal_extractor_skip_row(&in_c_, DISCMC_PREVIOUS_ROW),
                   in_cpp_.skip_row(Substitute::previous_row));
      return;
    }
    const uint32_t count = what == 1 ? input_.below(width_) : width_;
    const auto samples = read_samples<Sample>(input_, count);
    require_same(push(in_c_, samples.data(), count), in_cpp_.push(samples.data(), count));
  }

  void finish() {
    if (input_.below(2) == 0)
      require_same(discmc_normal_extractor_finish(&in_c_), in_cpp_.finish());
    else
      require_same(discmc_normal_extractor_abandon(&in_c_), in_cpp_.abandon());
    c_.refusals = cpp_.refusals = Refusals();
    require_same(discmc_normal_extractor_resume(&in_c_), in_cpp_.resume());
  }

  Input& input_;
  discmc_normal_extractor& in_c_;
  const discmc_normal_kind& kind_;
  uint32_t width_ = 0;
  SinkInC c_;
  SinkInCpp cpp_;
  std::unique_ptr<BothBlocks> blocks_;
  NormalExtractor<Index, Sample> in_cpp_;
};

/// Makes every call twice, in C and in C++.
class Both {
 public:
  explicit Both(Input& input) : input_(input) {}

  void run() {
    while (!input_.is_empty()) {
      call();
      compare();
    }
    const Refusals none;
    scanned_c_.refusals = scanned_cpp_.refusals = decoded_c_.refusals = decoded_cpp_.refusals =
        none;
    line_c_.refusals = line_cpp_.refusals = none;
    abandon();
    flush();
    push_stream(0);
    finish_decoder();
    look();
    compare();
  }

 private:
  void call() {
    const uint32_t what = input_.byte();
    if (what < 16) return start();
    if (what < 20) return reset();
    if (what < 28) return change_refusals();
    if (what < 36) return resume();
    if (what < 44) return finish();
    if (what < 48) return abandon();
    if (what < 64) return skip_row();
    if (what < 96) return push_bits();
    if (what < 128) return push(discmc_extractor_push_u8);
    if (what < 144) return push(discmc_extractor_push_u16);
    if (what < 160) return push(discmc_extractor_push_i16);
    if (what < 176) return start_encoder();
    if (what < 192) return flush();
    if (what < 208) return start_decoder();
    if (what < 232) return push_stream(what);
    if (what < 240) return push_any_bytes();
    if (what < 248) return finish_decoder();
    if (what < 250) return pass_on();
    if (what < 252) return append();
    if (what < 254) return scan_with_normals();
    look();
  }

  // ---- the extractor ----

  void start() {
    const uint32_t flags = input_.byte();
    discmc_limits limits = {
        1 + input_.byte() % 12, 1 + input_.byte() % 6, static_cast<uint8_t>(flags & 1), {}};
    discmc_capacities capacities = discmc_minimum_capacities();
    capacities.records += input_.byte();
    if (flags >= 0xF8) capacities.records = flags * input_.byte();
    capacities.holes += input_.below(16);
    // Now and then a slab, and not always a valid one.
    const uint32_t seams = input_.byte();
    if (seams >= 0xC0)
      limits.slab = {input_.byte(), static_cast<uint8_t>(seams & 1),
                     static_cast<uint8_t>(seams >> 1 & 1)};
    const bool has_defaults = (flags & 2) != 0;
    uint64_t bytes = discmc_minimum_bytes(&limits) + 8 * input_.byte();
    if (!has_defaults) bytes = discmc_bytes_for(&limits, &capacities);
    if ((flags & 0x38) == 0x38) bytes -= 1 + input_.byte();
    const int32_t threshold = static_cast<int32_t>(input_.byte()) - 2;

    auto blocks = std::make_unique<BothBlocks>(bytes);
    const discmc_sink sink = {&scanned_c_, SinkInC::take};
    const discmc_status in_c =
        discmc_extractor_start(extractor_.get(), &limits, has_defaults ? nullptr : &capacities,
                               threshold, blocks->memory_c(), &sink);
    const Limits cpp_limits{
        limits.width,
        limits.height,
        static_cast<Border>(limits.border),
        {limits.slab.first, limits.slab.continues_below != 0, limits.slab.continues_above != 0}};
    const Capacities cpp_capacities{capacities.records, capacities.holes};
    const Sink cpp_sink = sink_to(scanned_cpp_);
    const Status in_cpp =
        has_defaults
            ? in_cpp_.start(cpp_limits, threshold, blocks->cpp.memory(), cpp_sink)
            : in_cpp_.start(cpp_limits, cpp_capacities, threshold, blocks->cpp.memory(), cpp_sink);
    require_same(in_c, in_cpp);
    require((discmc_limits_is_valid(&limits) != 0) == cpp_limits.is_valid(),
            "limits are valid on one side");
    require((discmc_capacities_is_valid(&capacities) != 0) == is_valid<uint16_t>(cpp_capacities),
            "capacities are valid on one side");
    require_same_records(discmc_default_capacities(&limits, bytes),
                         default_capacities<uint16_t>(cpp_limits, bytes));
    if (in_c != DISCMC_OK) return;
    blocks_ = std::move(blocks);
    width_ = limits.width;
    scanned_c_.encoder = (flags & 0x40) != 0 ? encoder_.get() : nullptr;
    scanned_cpp_.encoder = (flags & 0x40) != 0 ? &encoder_cpp_ : nullptr;
    begin();
  }

  void begin() { rings_.forget(); }

  void reset() {
    const discmc_status in_c = discmc_extractor_reset(extractor_.get());
    require_same(in_c, in_cpp_.reset());
    begin();
  }

  void change_refusals() {
    const Refusals refusals = read_refusals(input_);
    const uint32_t whose = input_.below(3);
    if (whose == 0) scanned_c_.refusals = scanned_cpp_.refusals = refusals;
    if (whose == 1) decoded_c_.refusals = decoded_cpp_.refusals = refusals;
    if (whose == 2) line_c_.refusals = line_cpp_.refusals = refusals;
    if (whose == 2) line_c_.most = line_cpp_.most = size_t{1} + input_.byte();
  }

  void resume() { require_same(discmc_extractor_resume(extractor_.get()), in_cpp_.resume()); }
  void finish() { require_same(discmc_extractor_finish(extractor_.get()), in_cpp_.finish()); }
  void abandon() { require_same(discmc_extractor_abandon(extractor_.get()), in_cpp_.abandon()); }

  void skip_row() {
    const auto substitute = static_cast<uint8_t>(input_.byte() % 2);
    require_same(discmc_extractor_skip_row(extractor_.get(), substitute),
                 in_cpp_.skip_row(static_cast<Substitute>(substitute)));
  }

  void push_bits() {
    const auto bits = read_samples<uint8_t>(input_, (width_ + 7) / 8);
    require_same(discmc_extractor_push_bits(extractor_.get(), bits.data()),
                 in_cpp_.push_bits(bits.data()));
  }

  template <class Sample>
  void push(discmc_push_result (*in_c)(discmc_extractor*, const Sample*, uint32_t, uint32_t)) {
    const uint32_t count = input_.byte() % 40;
    const uint32_t stride = 1 + input_.below(3);
    const auto samples = read_samples<Sample>(input_, count == 0 ? 0 : (count - 1) * stride + 1);
    require_same(in_c(extractor_.get(), samples.data(), count, stride),
                 in_cpp_.push(samples.data(), count, stride));
  }

  void scan_with_normals() {
    discmc_normal_extractor& in_c = *normals_;
    switch (input_.below(4)) {
      case 0:
        return BothNormals<uint16_t, uint8_t>(input_, in_c, discmc_normals_u8).run();
      case 1:
        return BothNormals<uint16_t, uint16_t>(input_, in_c, discmc_normals_u16).run();
      case 2:
        return BothNormals<uint16_t, int16_t>(input_, in_c, discmc_normals_i16).run();
      default:
        return BothNormals<uint32_t, uint8_t>(input_, in_c, discmc_host_normals_u8).run();
    }
  }

  // ---- the stream ----

  void start_encoder() {
    discmc_stream_label label = {};
    label.scan = static_cast<uint16_t>(input_.byte());
    label.channel = static_cast<uint8_t>(input_.byte() % 80);
    label.depth = input_.number(UINT32_MAX);
    for (int32_t& spacing : label.spacing_nm)
      spacing = static_cast<int32_t>(input_.number(INT32_MAX)) - 1000;
    const bool has_output = input_.byte() < 250;
    StreamLabel cpp_label;
    cpp_label.scan = label.scan;
    cpp_label.channel = label.channel;
    cpp_label.depth = label.depth;
    for (int i = 0; i < 3; ++i) cpp_label.spacing_nm[i] = label.spacing_nm[i];
    const auto write = has_output ? RefusingLine::write : nullptr;
    const discmc_status in_c = discmc_encoder_start(encoder_.get(), &label, {&line_c_, write});
    require_same(in_c, encoder_cpp_.start(cpp_label, {&line_cpp_, write}));
  }

  void flush() {
    const bool in_c = discmc_encoder_flush(encoder_.get()) != 0;
    require(in_c == encoder_cpp_.flush(), "flush() comes to something else than in C++");
  }

  void append() {
    const auto payload = input_.bytes(input_.byte());
    const uint32_t pieces = input_.number(UINT32_MAX);
    const bool is_whole = input_.below(2) == 1;
    const discmc_records_packet packet = {payload.data(), payload.size(), pieces, is_whole};
    require_same(discmc_encoder_append(encoder_.get(), &packet),
                 encoder_cpp_.append({payload.data(), payload.size(), pieces, is_whole}));
  }

  void pass_on() {
    const bool is_wanted = input_.below(4) != 0;
    discmc_decoder_pass_whole_regions_to(decoder_.get(), is_wanted ? &packet_sink_ : nullptr);
    decoder_cpp_.pass_whole_regions_to(
        is_wanted ? RecordsPacketSink{&packets_cpp_, Packets::take_in_cpp} : RecordsPacketSink{});
  }

  void start_decoder() {
    const bool has_sink = input_.byte() < 250;
    const discmc_sink sink = {&decoded_c_, has_sink ? SinkInC::take : nullptr};
    Sink cpp_sink = sink_to(decoded_cpp_);
    if (!has_sink) cpp_sink.take = nullptr;
    const uint32_t choice = input_.byte();
    const auto channel = choice < 200 ? any_channel : static_cast<uint8_t>(choice % 80);
    const discmc_status in_c = discmc_decoder_start(decoder_.get(), &sink, channel);
    require_same(in_c, decoder_cpp_.start(cpp_sink, channel));
    if (in_c == DISCMC_OK) arrived_ = 0;
  }

  void push_stream(uint32_t what) {
    arrived_ += push_bytes(some_of(line_c_.bytes, arrived_, what, input_));
  }

  void push_any_bytes() { push_bytes(input_.bytes(input_.byte())); }

  size_t push_bytes(const std::vector<uint8_t>& bytes) {
    const discmc_decoded in_c = discmc_decoder_push(decoder_.get(), bytes.data(), bytes.size());
    const Decoded in_cpp = decoder_cpp_.push(bytes.data(), bytes.size());
    require_same(in_c, in_cpp);
    require(in_c.bytes <= bytes.size(), "more bytes taken than given");
    return in_c.bytes;
  }

  void finish_decoder() {
    require_same(discmc_decoder_finish(decoder_.get()), decoder_cpp_.finish());
  }

  // ---- comparing ----

  void compare() {
    require(scanned_c_.events == scanned_cpp_.events, "other events than in C++");
    require(decoded_c_.events == decoded_cpp_.events, "other events decoded than in C++");
    require(line_c_.bytes == line_cpp_.bytes, "other bytes than in C++");
    require(
        packets_c_.payloads == packets_cpp_.payloads && packets_c_.pieces == packets_cpp_.pieces,
        "other packets passed on than in C++");
    require(discmc_encoder_bytes(encoder_.get()) == encoder_cpp_.bytes(),
            "another number of bytes sent than in C++");
    scanned_c_.events.clear();
    scanned_cpp_.events.clear();
    decoded_c_.events.clear();
    decoded_cpp_.events.clear();
  }

  void look() const {
    const auto* extractor = extractor_.get();
    require(counts(from_c(discmc_extractor_statistics(extractor))) == counts(in_cpp_.statistics()),
            "other totals than in C++");
    require_same_records(discmc_extractor_high_water(extractor), in_cpp_.high_water());
    require_same_records(discmc_extractor_capacities(extractor), in_cpp_.capacities());
    const discmc_limits limits = discmc_extractor_limits(extractor);
    require(limits.width == in_cpp_.limits().width && limits.height == in_cpp_.limits().height &&
                limits.slab.first == in_cpp_.limits().slab.first,
            "other limits than in C++");
    require(discmc_extractor_bytes_used(extractor) == in_cpp_.bytes_used(),
            "other bytes in use than in C++");
    require(
        blocks_ == nullptr || discmc_extractor_bytes_used(extractor) <= blocks_->cpp.memory().bytes,
        "more bytes in use than were given");
    require(discmc_extractor_slices(extractor) == in_cpp_.slices() &&
                discmc_extractor_rows(extractor) == in_cpp_.rows(),
            "other rows counted than in C++");
    require_same(discmc_decoder_report(decoder_.get()), decoder_cpp_.report());
    require_same(discmc_decoder_header(decoder_.get()), decoder_cpp_.header());
  }

  Input& input_;
  uint32_t width_ = 1;
  Rings rings_;
  RefusingLine line_c_, line_cpp_;
  SinkInC scanned_c_{{}, {}, nullptr, &rings_};  // of the extractor
  SinkInCpp scanned_cpp_;
  SinkInC decoded_c_;  // of the decoder
  SinkInCpp decoded_cpp_;
  Packets packets_c_, packets_cpp_;
  const discmc_records_packet_sink packet_sink_{&packets_c_, Packets::take_in_c};
  std::unique_ptr<BothBlocks> blocks_;
  // On the heap, where the next byte is no one's.
  std::unique_ptr<discmc_extractor> extractor_ = std::make_unique<discmc_extractor>();
  std::unique_ptr<discmc_encoder> encoder_ = std::make_unique<discmc_encoder>();
  std::unique_ptr<discmc_normal_extractor> normals_ = std::make_unique<discmc_normal_extractor>();
  std::unique_ptr<discmc_decoder> decoder_ = std::make_unique<discmc_decoder>();
  Extractor16 in_cpp_{};
  Encoder encoder_cpp_{};
  Decoder decoder_cpp_{};
  size_t arrived_ = 0;  // bytes of the stream that the decoder has taken
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  Both(input).run();
  return 0;
}

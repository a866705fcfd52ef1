// Fuzz target. The promise: whatever is called through C, in whatever order, on objects in memory
// of exactly their size, comes to the statuses, events and bytes that the same calls come to in
// C++, and touches nothing else. Checkpoints included, after which both sides go on in other
// memory.
//
//   fuzz_c_api -max_len=800 corpus/c_api      with libFuzzer
//   fuzz_c_api corpus/c_api                   with replay_main.cpp

#include <discmc/discmc.h>

#include <discmc/encoder.hpp>
#include <discmc/host/learning_extractor.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_decoder.hpp>
#include <memory>

#include "input.hpp"
#include "oracle/c_events.hpp"
#include "oracle/scan.hpp"
#include "require.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

// ---- what both sides have in common ----

/// Refuses at random, but on both sides alike.
struct Refusals {
  uint32_t of_256 = 0;
  uint32_t seed = 0;

  bool refuses() {
    seed = seed * 1664525 + 1013904223;
    return seed >> 24 < of_256;
  }
};

struct RefusingLine {
  Refusals refusals;
  std::vector<uint8_t> bytes;

  ByteOutput output() { return {this, write}; }
  discmc_byte_output c_output() { return {this, write}; }
  static size_t write(void* context, const uint8_t* data, size_t count) {
    RefusingLine& line = *static_cast<RefusingLine*>(context);
    if (line.refusals.refuses()) return 0;
    const size_t taken = count < 9 ? count : 9;
    line.bytes.insert(line.bytes.end(), data, data + taken);
    return taken;
  }
};

void require_same(discmc_status in_c, Status in_cpp) {
  require(in_c == static_cast<discmc_status>(in_cpp), "another status than in C++");
}
void require_same(discmc_push_result in_c, PushResult in_cpp) {
  require_same(in_c.status, in_cpp.status);
  require(in_c.accepted == in_cpp.samples, "another number of samples than in C++");
}

/// An object's memory, which can be replaced by a copy elsewhere, as after a power failure.
class MemoryInC {
 public:
  explicit MemoryInC(uint64_t bytes) : block_(std::make_unique<Block>(bytes, Block::Kind::exact)) {}
  discmc_memory get() { return {block_->memory().data, block_->memory().bytes}; }
  void move(const discmc_memory& part) {
    auto other = std::make_unique<Block>(block_->memory().bytes, Block::Kind::exact);
    std::copy_n(static_cast<uint8_t*>(part.data), part.bytes,
                static_cast<uint8_t*>(other->memory().data));
    block_ = std::move(other);
  }

 private:
  std::unique_ptr<Block> block_;
};

struct Setting {
  explicit Setting(Input& input)
      : limits{1 + input.below(20), 1 + input.below(12), static_cast<Border>(input.below(2))},
        threshold(static_cast<int32_t>(input.byte())),
        spare(input.byte() * 16),
        of_sink{input.byte() / 2, input.byte()},
        of_line{input.byte() / 2, input.byte()} {}
  discmc_limits in_c() const {
    return {limits.width, limits.height, static_cast<uint8_t>(limits.border)};
  }

  Limits limits;
  int32_t threshold;
  uint32_t spare;
  Refusals of_sink, of_line;
};

// ---- polygons ----

struct SinkInC {
  Refusals refusals;
  Events events;
  discmc_encoder* encoder;

  static discmc_sink_result take(void* context, const discmc_event* event) {
    SinkInC& sink = *static_cast<SinkInC*>(context);
    if (sink.refusals.refuses() || discmc_encoder_take(sink.encoder, event) != DISCMC_SINK_ACCEPTED)
      return DISCMC_SINK_BUSY;
    sink.events.push_back(from_c(*event));
    return DISCMC_SINK_ACCEPTED;
  }
};
struct SinkInCpp {
  Refusals refusals;
  Events events;
  NormalEncoder encoder;

  Answer take(const Event& event) {
    if (refusals.refuses() || encoder.take(event) != Answer::taken) return Answer::not_now;
    events.emplace_back(event);
    return Answer::taken;
  }
};

template <class Scanner, class Sample>
class Polygons {
 public:
  Polygons(const discmc_extractor_kind& kind, discmc_sample_type type, const Setting& setting)
      : setting_(setting), type_(type) {
    c_line_.refusals = cpp_line_.refusals = setting.of_line;
    c_sink_.refusals = cpp_sink_.refusals = setting.of_sink;
    encoder_config_ = {&discmc_regions_with_normals,
                       {9, {3, -4, 5}, 6, 7},
                       encoder_memory_.get(),
                       c_line_.c_output()};
    config_.kind = &kind;
    config_.limits = setting.in_c();
    config_.threshold = setting.threshold;
    config_.memory.bytes = static_cast<size_t>(discmc_extractor_bytes(&config_)) + setting.spare;
    memory_ = std::make_unique<MemoryInC>(config_.memory.bytes);
    config_.memory = memory_->get();
    config_.sink = {&c_sink_, SinkInC::take};
    require(discmc_encoder_start(&c_sink_.encoder, &encoder_config_) == DISCMC_OK, "no encoder");
    require_ok(cpp_sink_.encoder.start({9, {3, -4, 5}, 6, 7}, cpp_line_.output()));
    const discmc_status status = discmc_extractor_start(&extractor_, &config_);
    is_started_ = status == DISCMC_OK;
    // A sink that refuses the start.
    require(is_started_ || status == DISCMC_BAD_SINK, "a scan that does not start");
    if (!is_started_) return;
    const discmc_extractor_info info = discmc_extractor_get_info(extractor_);
    const Capacities capacities{info.records, info.holes};
    cpp_memory_.resize(size_t{1} << 20);
    require_same(status,
                 scanner_->start(setting.limits, capacities, setting.threshold,
                                 {cpp_memory_.data(), cpp_memory_.size()}, sink_to(cpp_sink_)));
  }

  bool is_started() const { return is_started_; }

  void push(const std::vector<Sample>& samples, uint32_t stride) {
    const auto count = static_cast<uint32_t>((samples.size() + stride - 1) / stride);
    require_same(discmc_extractor_push(extractor_, type_, samples.data(), count, stride),
                 scanner_->push(samples.data(), count, stride));
  }
  void skip(uint32_t substitute) {
    require_same(discmc_extractor_skip_row(extractor_, static_cast<uint8_t>(substitute)),
                 scanner_->skip_row(static_cast<Substitute>(substitute)));
  }
  void resume() { require_same(discmc_extractor_resume(extractor_), scanner_->resume()); }
  void finish() { require_same(discmc_extractor_finish(extractor_), scanner_->finish()); }
  void abandon() { require_same(discmc_extractor_abandon(extractor_), scanner_->abandon()); }
  void write(const std::vector<uint8_t>& bytes) {
    const discmc_application_record record = {1, 2, 3, bytes.data(), bytes.size()};
    require_same(discmc_encoder_write_record(c_sink_.encoder, &record),
                 cpp_sink_.encoder.tell({1, 2, 3, bytes.data(), bytes.size()}));
  }
  void flush() {
    require((discmc_encoder_flush(c_sink_.encoder) == DISCMC_OK) == cpp_sink_.encoder.flush(),
            "another flush than in C++");
  }
  void set_output(bool drops) {
    discmc_encoder_set_output(c_sink_.encoder,
                              drops ? discmc_byte_output{nullptr, nullptr} : c_line_.c_output());
    cpp_sink_.encoder.set_output(drops ? ByteOutput{} : cpp_line_.output());
  }
  void lose_power() {
    discmc_memory part, encoder_part;
    const discmc_status status = discmc_extractor_save(extractor_, &part);
    require_same(status, scanner_->save(*std::make_unique<Checkpoint<Scanner>>()));
    if (status != DISCMC_OK) return;
    require(discmc_encoder_save(c_sink_.encoder, &encoder_part) == DISCMC_OK, "not saved");
    memory_->move(part);
    encoder_memory_.move(encoder_part);
    config_.memory = memory_->get();
    encoder_config_.memory = encoder_memory_.get();
    require(discmc_encoder_restore(&c_sink_.encoder, &encoder_config_) == DISCMC_OK &&
                discmc_extractor_restore(&extractor_, &config_) == DISCMC_OK,
            "not restored");
    // A frame that is under way is sent again.
    auto checkpoint = std::make_unique<Checkpoint<Encoder>>();
    require_ok(cpp_sink_.encoder.save(*checkpoint));
    require_ok(cpp_sink_.encoder.restore(*checkpoint, cpp_line_.output()));
  }

  std::vector<uint8_t> compare() {
    require(c_sink_.events == cpp_sink_.events, "other events than in C++");
    require(c_line_.bytes == cpp_line_.bytes, "other bytes than in C++");
    const discmc_extractor_info info = discmc_extractor_get_info(extractor_);
    require(counts(from_c(info.statistics)) == counts(scanner_->statistics()) &&
                info.slices == scanner_->slices() && info.rows == scanner_->rows() &&
                info.bytes_used <= config_.memory.bytes &&
                discmc_encoder_stream_bytes(c_sink_.encoder) == cpp_sink_.encoder.bytes(),
            "another info than in C++");
    return c_line_.bytes;
  }

 private:
  Setting setting_;
  discmc_sample_type type_;
  RefusingLine c_line_, cpp_line_;
  MemoryInC encoder_memory_{DISCMC_ENCODER_BYTES};
  std::unique_ptr<MemoryInC> memory_;
  std::vector<uint8_t> cpp_memory_;
  discmc_encoder_config encoder_config_{};
  discmc_extractor_config config_{};
  discmc_extractor* extractor_ = nullptr;
  std::unique_ptr<Scanner> scanner_ = std::make_unique<Scanner>();
  SinkInC c_sink_{};
  SinkInCpp cpp_sink_;
  bool is_started_ = false;
};

// ---- slices ----

class Slices {
 public:
  Slices(Input& input, const Setting& setting) {
    c_line_.refusals = cpp_line_.refusals = setting.of_line;
    config_.kind = &discmc_slices_u8;
    config_.limits = setting.in_c();
    config_.surface_count = static_cast<uint8_t>(1 + input.below(4));
    for (int32_t& threshold : config_.thresholds) threshold = static_cast<int32_t>(input.byte());
    config_.key_slice_interval = input.below(4);
    config_.label = {9, {3, -4, 5}, 6, 7};
    config_.memory.bytes = static_cast<size_t>(discmc_slice_encoder_bytes(&config_));
    memory_ = std::make_unique<MemoryInC>(config_.memory.bytes);
    config_.memory = memory_->get();
    config_.output = c_line_.c_output();
    require(discmc_slice_encoder_start(&in_c_, &config_) == DISCMC_OK, "no slice encoder");
    StreamHeader header{setting.limits.width,
                        setting.limits.height,
                        9,
                        {3, -4, 5},
                        config_.thresholds[0],
                        setting.limits.border,
                        7,
                        6,
                        static_cast<uint8_t>(config_.surface_count - 1),
                        {config_.thresholds[1], config_.thresholds[2], config_.thresholds[3]}};
    cpp_memory_.resize(config_.memory.bytes);
    require_ok(in_cpp_.start(header, {config_.key_slice_interval},
                             {cpp_memory_.data(), cpp_memory_.size()}, cpp_line_.output()));
  }

  static bool is_started() { return true; }

  void push(const std::vector<uint8_t>& samples, uint32_t stride) {
    const auto count = static_cast<uint32_t>((samples.size() + stride - 1) / stride);
    require_same(discmc_slice_encoder_push(in_c_, DISCMC_U8, samples.data(), count, stride),
                 in_cpp_.push(samples.data(), count, stride));
  }
  void skip(uint32_t substitute) {
    require_same(discmc_slice_encoder_skip_row(in_c_, static_cast<uint8_t>(substitute)),
                 in_cpp_.skip_row(static_cast<Substitute>(substitute)));
  }
  void resume() { require_same(discmc_slice_encoder_resume(in_c_), in_cpp_.resume()); }
  void finish() { require_same(discmc_slice_encoder_finish(in_c_), in_cpp_.finish()); }
  void abandon() { require_same(discmc_slice_encoder_abandon(in_c_), in_cpp_.abandon()); }
  void write(const std::vector<uint8_t>& bytes) {
    const discmc_application_record record = {1, 0, 0, bytes.data(), bytes.size()};
    require_same(discmc_slice_encoder_write_record(in_c_, &record),
                 in_cpp_.tell({1, 0, 0, bytes.data(), bytes.size()}));
  }
  void flush() { require_same(discmc_slice_encoder_flush(in_c_), in_cpp_.flush()); }
  void set_output(bool drops) {
    discmc_slice_encoder_set_output(
        in_c_, drops ? discmc_byte_output{nullptr, nullptr} : c_line_.c_output());
    in_cpp_.set_output(drops ? ByteOutput{} : cpp_line_.output());
  }
  void lose_power() {
    discmc_memory part;
    const discmc_status status = discmc_slice_encoder_save(in_c_, &part);
    Checkpoint<SliceEncoder> checkpoint{};
    require_same(status, in_cpp_.save(checkpoint));
    if (status != DISCMC_OK) return;
    memory_->move(part);
    config_.memory = memory_->get();
    require(discmc_slice_encoder_restore(&in_c_, &config_) == DISCMC_OK, "not restored");
    require_ok(
        in_cpp_.restore(checkpoint, {cpp_memory_.data(), cpp_memory_.size()}, cpp_line_.output()));
  }

  std::vector<uint8_t> compare() {
    require(c_line_.bytes == cpp_line_.bytes, "other bytes than in C++");
    const discmc_slice_encoder_info info = discmc_slice_encoder_get_info(in_c_);
    require(info.slices == in_cpp_.slices() && info.rows == in_cpp_.rows() &&
                info.stream_bytes == in_cpp_.bytes(),
            "another info than in C++");
    return c_line_.bytes;
  }

 private:
  RefusingLine c_line_, cpp_line_;
  std::unique_ptr<MemoryInC> memory_;
  std::vector<uint8_t> cpp_memory_;
  discmc_slice_encoder_config config_{};
  discmc_slice_encoder* in_c_ = nullptr;
  SliceEncoder in_cpp_;
};

// ---- the receiver ----

void receive(Input& input, std::vector<uint8_t> stream, const Setting& setting) {
  if (!stream.empty())
    for (uint32_t flips = input.below(3); flips > 0; --flips) {
      uint8_t& damaged = stream[input.word() % stream.size()];
      damaged = static_cast<uint8_t>(damaged ^ 1U << input.below(8));
    }
  const discmc_limits limits = setting.in_c();
  MemoryInC memory(discmc_receiver_bytes(&limits, 4) + setting.spare);
  std::vector<uint8_t> cpp_memory(minimum_surface_bytes(setting.limits, 4) + setting.spare);
  const auto refuses = [refusals = setting.of_sink](uint64_t) mutable {
    return refusals.refuses();
  };
  EventLog log(refuses), expected(refuses);
  const discmc_receiver_config config = {DISCMC_ANY_CHANNEL, memory.get(), c_sink_to(log)};
  discmc_receiver* receiver = nullptr;
  require(discmc_receiver_start(&receiver, &config) == DISCMC_OK, "no receiver");
  SurfaceDecoder decoder;
  require_ok(decoder.start({cpp_memory.data(), cpp_memory.size()}, sink_to(expected)));
  for (size_t at = 0; at < stream.size();) {
    const size_t left = stream.size() - at, portion = 1 + input.byte();
    const std::vector<uint8_t> bytes(stream.data() + at,
                                     stream.data() + at + (portion < left ? portion : left));
    const discmc_push_result result = discmc_receiver_push(receiver, bytes.data(), bytes.size());
    const Decoded decoded = decoder.push(bytes.data(), bytes.size());
    require_same(result.status, decoded.status);
    require(result.accepted == decoded.bytes, "another number of bytes than in C++");
    if (result.status != DISCMC_OK && result.status != DISCMC_SUSPENDED) break;
    at += result.accepted;
  }
  for (Status status = Status::more; status == Status::more;) {
    status = decoder.finish();
    require_same(discmc_receiver_finish(receiver), status);
  }
  require(log.events == expected.events, "other events received than in C++");
  const discmc_receiver_info info = discmc_receiver_get_info(receiver);
  const StreamReport& report = decoder.report();
  require(info.bytes == report.bytes && info.packets == report.packets &&
              info.damaged_packets == report.damaged_packets &&
              info.lost_packets == report.lost_packets && info.regions == report.regions &&
              info.rows == report.rows && info.is_complete == (report.is_complete() ? 1 : 0),
          "another report than in C++");
}

template <class Sample, class Both>
void run(Input& input, Both& both, const Setting& setting) {
  while (!input.is_empty()) {
    const uint32_t call = input.below(24);
    if (call < 12) {
      std::vector<Sample> samples(input.below(2) == 0 ? setting.limits.width : input.byte());
      for (Sample& sample : samples) sample = static_cast<Sample>(input.byte());
      both.push(samples, 1 + call % 3);
    } else if (call < 14) {
      both.skip(call % 2);
    } else if (call < 17) {
      both.resume();
    } else if (call < 18) {
      both.finish();
    } else if (call < 19 && input.below(4) == 0) {
      both.abandon();
    } else if (call < 20) {
      both.write(input.bytes(input.byte()));
    } else if (call < 21) {
      both.flush();
    } else if (call < 22) {
      both.set_output(input.below(2) == 0);
    } else {
      both.lose_power();
    }
  }
  both.abandon();
  receive(input, both.compare(), setting);
}

template <class Scanner, class Sample>
void run_polygons(Input& input, const discmc_extractor_kind& kind, discmc_sample_type type,
                  const Setting& setting) {
  Polygons<Scanner, Sample> both(kind, type, setting);
  if (both.is_started()) run<Sample>(input, both, setting);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  const uint32_t kind = input.below(5);
  const Setting setting(input);
  if (kind == 0) run_polygons<Extractor16, uint8_t>(input, discmc_plain_u8, DISCMC_U8, setting);
  if (kind == 1) run_polygons<Extractor16, int16_t>(input, discmc_plain_i16, DISCMC_I16, setting);
  if (kind == 2)
    run_polygons<Extractor<uint16_t, GradientNormals<uint16_t>>, uint16_t>(
        input, discmc_normals_u16, DISCMC_U16, setting);
  if (kind == 3) run_polygons<LearningExtractor, uint8_t>(input, discmc_host, DISCMC_U8, setting);
  if (kind == 4) {
    Slices both(input, setting);
    run<uint8_t>(input, both, setting);
  }
  return 0;
}

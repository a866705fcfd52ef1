// Fuzz target. The promise of the C API of slices: whatever is called, in whatever order, on
// objects and memory of exactly their size, comes to the statuses, rows, events and bytes that the
// same calls come to in C++, and touches nothing else.
//
//   fuzz_c_slices -max_len=800 corpus/c_slices      with libFuzzer
//   fuzz_c_slices corpus/c_slices                   with replay_main.cpp
#include <discmc/slice_encoder.hpp>
#include <discmc/surface_decoder.hpp>
#include <memory>

#include "both_sides.hpp"
#include "input.hpp"
#include "oracle/c_row_events.hpp"

using namespace discmc;
using reference::Events;
using reference::from_c;

namespace {

/// Notes rows, but for those that it refuses.
struct RowSinkOfEither {
  Refusals refusals;
  uint32_t width = 0;  // of the stream
  std::vector<std::vector<int64_t>> rows;

  static discmc_answer take_in_c(void* context, const discmc_row_event* event) {
    StreamHeader header;
    ApplicationRecord application;
    const RowEvent same = from_c(*event, header, application);
    return static_cast<discmc_answer>(static_cast<RowSinkOfEither*>(context)->take(same));
  }
  Answer take(const RowEvent& event) {
    if (refusals.refuses()) return Answer::not_now;
    if (event.kind == RowEvent::Kind::start) width = event.header->width;
    rows.push_back(reference::numbers_of(event, width));
    return Answer::taken;
  }
};

/// Notes events, but for those that it refuses.
struct EventSinkOfEither {
  Refusals refusals;
  Events events;

  static discmc_answer take_in_c(void* context, const discmc_event* event) {
    auto& sink = *static_cast<EventSinkOfEither*>(context);
    if (sink.refusals.refuses()) return DISCMC_NOT_NOW;
    sink.events.push_back(from_c(*event));
    return DISCMC_TAKEN;
  }
  Answer take(const Event& event) {
    if (refusals.refuses()) return Answer::not_now;
    events.emplace_back(event);
    return Answer::taken;
  }
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
    line_c_.refusals = line_cpp_.refusals = {};
    rows_c_.refusals = rows_cpp_.refusals = {};
    events_c_.refusals = events_cpp_.refusals = {};
    abandon();
    push_stream(0);
    finish_decoders();
    compare();
  }

 private:
  void call() {
    const uint32_t what = input_.byte();
    if (what < 24) return start_encoder();
    if (what < 40) return change_refusals();
    if (what < 48) return resume();
    if (what < 56) return flush();
    if (what < 64) return finish();
    if (what < 68) return abandon();
    if (what < 80) return tell();
    if (what < 84) return set_output();
    if (what < 96) return skip_row();
    if (what < 128) return push_bits();
    if (what < 144) return push(discmc_slice_encoder_push_u8);
    if (what < 152) return push(discmc_slice_encoder_push_u16);
    if (what < 160) return push(discmc_slice_encoder_push_i16);
    if (what < 176) return start_slice_decoder();
    if (what < 192) return start_surface_decoder();
    if (what < 232) return push_stream(what);
    if (what < 238) return push_any_bytes();
    if (what < 246) return give_memory();
    finish_decoders();
  }

  // ---- the encoder ----

  void start_encoder() {
    discmc_stream_header header = {};
    header.width = 1 + input_.byte() % 40;
    header.height = 1 + input_.byte() % 6;
    header.depth = input_.byte();
    header.threshold = static_cast<int32_t>(input_.byte()) - 2;
    const uint32_t flags = input_.byte();
    header.border = flags & 1;
    header.channel = static_cast<uint8_t>(input_.byte() % 70);
    header.scan = static_cast<uint16_t>(input_.byte());
    header.further_surfaces = static_cast<uint8_t>(flags >> 1 & 3);
    if (flags >= 0xF8) header.further_surfaces = 4;  // too many
    for (int32_t& threshold : header.further_thresholds)
      threshold = static_cast<int32_t>(input_.byte());
    const uint32_t interval = flags >> 3 & 3;
    const discmc_limits limits = {header.width, header.height, header.border, {}};
    const uint32_t surfaces = 1 + header.further_surfaces % 4U;
    uint64_t bytes = discmc_slice_encoder_bytes_for(&limits, interval, surfaces);
    if ((flags & 0x60) == 0x60) bytes -= 1 + input_.byte();
    const bool has_output = input_.byte() < 250;
    auto blocks = std::make_unique<BothBlocks>(bytes);
    const StreamHeader cpp_header = from_c(header);
    const discmc_status in_c =
        discmc_slice_encoder_start(encoder_.get(), &header, interval, blocks->memory_c(),
                                   {&line_c_, has_output ? RefusingLine::write : nullptr});
    require_same(in_c,
                 encoder_cpp_.start(cpp_header, {interval}, blocks->cpp.memory(),
                                    {&line_cpp_, has_output ? RefusingLine::write : nullptr}));
    if (in_c != DISCMC_OK) return;
    encoder_blocks_ = std::move(blocks);
    width_ = header.width;
    surfaces_ = surfaces;
  }

  void change_refusals() {
    const Refusals refusals = read_refusals(input_);
    const uint32_t whose = input_.below(3);
    if (whose == 0) rows_c_.refusals = rows_cpp_.refusals = refusals;
    if (whose == 1) events_c_.refusals = events_cpp_.refusals = refusals;
    if (whose == 2) line_c_.refusals = line_cpp_.refusals = refusals;
    if (whose == 2) line_c_.most = line_cpp_.most = size_t{1} + input_.byte();
  }

  void resume() {
    require_same(discmc_slice_encoder_resume(encoder_.get()), encoder_cpp_.resume());
  }
  void flush() { require_same(discmc_slice_encoder_flush(encoder_.get()), encoder_cpp_.flush()); }
  void finish() {
    require_same(discmc_slice_encoder_finish(encoder_.get()), encoder_cpp_.finish());
  }
  void abandon() {
    require_same(discmc_slice_encoder_abandon(encoder_.get()), encoder_cpp_.abandon());
  }

  void tell() {
    const auto kind = static_cast<uint8_t>(input_.byte());
    const std::vector<uint8_t> bytes = input_.bytes(input_.byte());
    const discmc_application_record record = {kind, 0, 0, bytes.data(), bytes.size()};
    require_same(discmc_slice_encoder_tell(encoder_.get(), &record),
                 encoder_cpp_.tell({kind, 0, 0, bytes.data(), bytes.size()}));
  }

  void set_output() {
    const auto write = input_.byte() % 2 == 0 ? RefusingLine::write : nullptr;
    discmc_slice_encoder_set_output(encoder_.get(), {&line_c_, write});
    encoder_cpp_.set_output({&line_cpp_, write});
  }

  void skip_row() {
    const auto substitute = static_cast<uint8_t>(input_.byte() % 2);
    require_same(discmc_slice_encoder_skip_row(encoder_.get(), substitute),
                 encoder_cpp_.skip_row(static_cast<Substitute>(substitute)));
  }

  void push_bits() {
    const auto bits = read_samples<uint8_t>(input_, surfaces_ * ((width_ + 7) / 8));
    require_same(discmc_slice_encoder_push_bits(encoder_.get(), bits.data()),
                 encoder_cpp_.push_bits(bits.data()));
  }

  template <class Sample>
  void push(discmc_push_result (*in_c)(discmc_slice_encoder*, const Sample*, uint32_t, uint32_t)) {
    const uint32_t count = input_.byte() % 90;
    const uint32_t stride = 1 + input_.below(3);
    const auto samples = read_samples<Sample>(input_, count == 0 ? 0 : (count - 1) * stride + 1);
    require_same(in_c(encoder_.get(), samples.data(), count, stride),
                 encoder_cpp_.push(samples.data(), count, stride));
  }

  // ---- the decoders ----

  uint8_t read_channel() {
    const uint32_t choice = input_.byte();
    return choice < 200 ? any_channel : static_cast<uint8_t>(choice % 70);
  }
  // Enough for slices of some size, or none.
  uint64_t read_bytes(uint64_t (*bytes_for)(const discmc_limits*, uint32_t)) {
    const discmc_limits limits = {1 + input_.byte() % 40, 1 + input_.byte() % 6, 0, {}};
    const uint32_t surfaces = input_.below(5);
    return surfaces == 0 ? 0 : bytes_for(&limits, surfaces);
  }

  void start_slice_decoder() {
    auto blocks = std::make_unique<BothBlocks>(read_bytes(discmc_slice_decoder_bytes_for));
    const bool has_sink = input_.byte() < 250;
    const discmc_row_sink sink = {&rows_c_, has_sink ? RowSinkOfEither::take_in_c : nullptr};
    RowSink cpp_sink = row_sink_to(rows_cpp_);
    if (!has_sink) cpp_sink.take = nullptr;
    const uint8_t channel = read_channel();
    const discmc_status in_c =
        discmc_slice_decoder_start(slices_.get(), blocks->memory_c(), &sink, channel);
    require_same(in_c, slices_cpp_.start(blocks->cpp.memory(), cpp_sink, channel));
    if (in_c != DISCMC_OK) return;
    slices_blocks_ = std::move(blocks);
    taken_by_slices_ = 0;
  }

  void start_surface_decoder() {
    auto blocks = std::make_unique<BothBlocks>(read_bytes(discmc_minimum_surface_bytes));
    const bool has_sink = input_.byte() < 250;
    const discmc_sink sink = {&events_c_, has_sink ? EventSinkOfEither::take_in_c : nullptr};
    Sink cpp_sink = sink_to(events_cpp_);
    if (!has_sink) cpp_sink.take = nullptr;
    const uint8_t channel = read_channel();
    const discmc_status in_c =
        discmc_surface_decoder_start(surface_.get(), blocks->memory_c(), &sink, channel);
    require_same(in_c, surface_cpp_.start(blocks->cpp.memory(), cpp_sink, channel));
    if (in_c != DISCMC_OK) return;
    surface_blocks_ = std::move(blocks);
    taken_by_surface_ = 0;
  }

  void push_stream(uint32_t what) {
    const bool is_surface = what % 2 != 0;
    size_t& taken = is_surface ? taken_by_surface_ : taken_by_slices_;
    const std::vector<uint8_t> bytes = some_of(line_c_.bytes, taken, what, input_);
    taken += is_surface ? push_to_surface(bytes) : push_to_slices(bytes);
  }

  void push_any_bytes() {
    const std::vector<uint8_t> bytes = input_.bytes(input_.byte());
    push_to_slices(bytes);
    push_to_surface(bytes);
  }

  size_t push_to_slices(const std::vector<uint8_t>& bytes) {
    const discmc_decoded in_c =
        discmc_slice_decoder_push(slices_.get(), bytes.data(), bytes.size());
    require_same(in_c, slices_cpp_.push(bytes.data(), bytes.size()));
    require(in_c.bytes <= bytes.size(), "more bytes taken than given");
    return in_c.bytes;
  }
  size_t push_to_surface(const std::vector<uint8_t>& bytes) {
    const discmc_decoded in_c =
        discmc_surface_decoder_push(surface_.get(), bytes.data(), bytes.size());
    require_same(in_c, surface_cpp_.push(bytes.data(), bytes.size()));
    require(in_c.bytes <= bytes.size(), "more bytes taken than given");
    return in_c.bytes;
  }

  void give_memory() {
    if (input_.byte() % 2 == 0) {
      auto blocks = std::make_unique<BothBlocks>(read_bytes(discmc_slice_decoder_bytes_for));
      const discmc_status in_c =
          discmc_slice_decoder_give_memory(slices_.get(), blocks->memory_c());
      require_same(in_c, slices_cpp_.give_memory(blocks->cpp.memory()));
      given_blocks_.push_back(std::move(blocks));
    } else {
      auto blocks = std::make_unique<BothBlocks>(read_bytes(discmc_minimum_surface_bytes));
      const discmc_status in_c =
          discmc_surface_decoder_give_memory(surface_.get(), blocks->memory_c());
      require_same(in_c, surface_cpp_.give_memory(blocks->cpp.memory()));
      given_blocks_.push_back(std::move(blocks));
    }
  }

  void finish_decoders() {
    require_same(discmc_slice_decoder_finish(slices_.get()), slices_cpp_.finish());
    require_same(discmc_surface_decoder_finish(surface_.get()), surface_cpp_.finish());
  }

  // ---- comparing ----

  void compare() {
    require(line_c_.bytes == line_cpp_.bytes, "other bytes than in C++");
    require(rows_c_.rows == rows_cpp_.rows, "other rows than in C++");
    require(events_c_.events == events_cpp_.events, "other events than in C++");
    rows_c_.rows.clear();
    rows_cpp_.rows.clear();
    events_c_.events.clear();
    events_cpp_.events.clear();
    require(discmc_slice_encoder_bytes(encoder_.get()) == encoder_cpp_.bytes() &&
                discmc_slice_encoder_slices(encoder_.get()) == encoder_cpp_.slices() &&
                discmc_slice_encoder_rows(encoder_.get()) == encoder_cpp_.rows(),
            "another place in the scan than in C++");
    require_same(discmc_slice_decoder_report(slices_.get()), slices_cpp_.report());
    require_same(discmc_slice_decoder_header(slices_.get()), slices_cpp_.header());
    require_same(discmc_surface_decoder_report(surface_.get()), surface_cpp_.report());
    require_same(discmc_surface_decoder_header(surface_.get()), surface_cpp_.header());
  }

  Input& input_;
  uint32_t width_ = 1;
  uint32_t surfaces_ = 1;
  RefusingLine line_c_, line_cpp_;
  RowSinkOfEither rows_c_, rows_cpp_;
  EventSinkOfEither events_c_, events_cpp_;
  std::unique_ptr<BothBlocks> encoder_blocks_, slices_blocks_, surface_blocks_;
  std::vector<std::unique_ptr<BothBlocks>> given_blocks_;
  // On the heap, where the next byte is no one's.
  std::unique_ptr<discmc_slice_encoder> encoder_ = std::make_unique<discmc_slice_encoder>();
  std::unique_ptr<discmc_slice_decoder> slices_ = std::make_unique<discmc_slice_decoder>();
  std::unique_ptr<discmc_surface_decoder> surface_ = std::make_unique<discmc_surface_decoder>();
  SliceEncoder encoder_cpp_{};
  SliceDecoder slices_cpp_{};
  SurfaceDecoder surface_cpp_{};
  size_t taken_by_slices_ = 0, taken_by_surface_ = 0;  // bytes of the stream
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  Both(input).run();
  return 0;
}

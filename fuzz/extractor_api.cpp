// Fuzz target. For any order of calls, and any memory, samples and sink, every call returns the
// status that the headers specify. Only the given memory is written, and the events follow their
// grammar. The surface of a finished scan is that of its rows.
//
//   fuzz_extractor_api -max_len=600 corpus/extractor_api      with libFuzzer
//   fuzz_extractor_api corpus/extractor_api                   with replay_main.cpp

#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>

#include "input.hpp"
#include "oracle/checkpointed_device.hpp"
#include "oracle/event_log.hpp"
#include "oracle/naive_join.hpp"
#include "oracle/scan.hpp"
#include "require.hpp"

using namespace discmc;
using namespace discmc::reference;

namespace {

constexpr size_t max_voxels = 3000;  // of one scan, to limit the time of a run

/// Memory that begins at any address, and ends with its heap block.
class OffsetMemory {
 public:
  OffsetMemory(size_t bytes, size_t offset)
      : offset_(offset), bytes_(bytes), all_(new uint8_t[offset + bytes]) {
    std::fill_n(all_.get(), offset_ + bytes_, filling);
  }

  Memory memory() { return {all_.get() + offset_, bytes_}; }
  size_t offset() const { return offset_; }
  bool is_intact() const { return is_filled(0, offset_); }
  bool is_untouched() const { return is_filled(0, offset_ + bytes_); }

 private:
  static constexpr uint8_t filling = 0xA5;

  bool is_filled(size_t from, size_t to) const {
    return std::all_of(all_.get() + from, all_.get() + to,
                       [](uint8_t byte) { return byte == filling; });
  }

  size_t offset_;
  size_t bytes_;
  std::unique_ptr<uint8_t[]> all_;
};

/// The sink: a log of the current scan, which refuses at random, and the collected surface. It
/// outlives the scans.
class Listener {
 public:
  void listen() {
    log_.emplace([this](uint64_t) { return refuses(); });
    collector_ = Collector();
    refuses_now_ = false;
  }
  void refuse(uint32_t of_256, uint32_t seed) {
    refusals_ = of_256;
    seed_ = seed;
  }
  const Collector& collector() const { return collector_; }
  /// Whether the last event offered was refused.
  bool refuses_now() const { return refuses_now_; }

  SinkResult accept(const Event& event) try {
    if (event.kind == Event::Kind::start) return SinkResult::accepted;
    require(log_.has_value(), "an event before any scan");
    const SinkResult answer = log_->accept(event);
    refuses_now_ = answer == SinkResult::busy;
    return refuses_now_ ? answer : collector_.accept(event);
  } catch (const std::exception& error) {
    require(false, error.what());
    return SinkResult::accepted;
  }

 private:
  bool refuses() {
    seed_ = seed_ * 1664525 + 1013904223;
    return seed_ >> 24 < refusals_;
  }

  std::optional<EventLog> log_;
  Collector collector_;
  uint32_t refusals_ = 0;
  uint32_t seed_ = 0;
  bool refuses_now_ = false;
};

/// A row of samples that become the given bits, for any type and threshold.
template <class Sample>
Sample sample_of(bool on, int32_t threshold, uint32_t noise) {
  constexpr int64_t least = std::numeric_limits<Sample>::min();
  constexpr int64_t most = std::numeric_limits<Sample>::max();
  const int64_t first_on = std::clamp<int64_t>(threshold, least, most);
  if (on) return static_cast<Sample>(first_on + int64_t{noise} % (most - first_on + 1));
  if (first_on == least) return static_cast<Sample>(least);
  return static_cast<Sample>(first_on - 1 - int64_t{noise} % (first_on - least));
}

/// Calls an extractor and compares its behaviour with that in the headers.
template <class Index>
class Caller {
 public:
  explicit Caller(Input& input) : input_(input) {}

  void run() {
    while (!input_.is_empty()) call();
    end();
    check_own_memory();
  }

 private:
  enum class State : uint8_t { idle, scanning, finishing, finished };

  void call() {
    const uint32_t what = input_.byte();
    if (what < 24) return start();
    if (what < 28) return reset();
    if (what < 40) return change_mood();
    if (what < 56) return resume();
    if (what < 72) return finish();
    if (what < 76) return abandon();
    if (what < 100) return skip_row();
    if (what < 140) return push_bits();
    if (what < 190) return push<uint8_t>();
    if (what < 220) return push<uint16_t>();
    if (what < 250) return push<int16_t>();
    if (what < 253) return fail_power();
    look();
  }

  void change_mood() {
    const uint32_t refusals = input_.byte();
    listener_.refuse(refusals, input_.byte());
  }

  // ---- beginning ----

  void start() {
    const uint32_t flags = input_.byte();
    Limits limits = read_limits(flags);
    const uint64_t least = limits.is_valid() ? Extractor<Index>::minimum_bytes(limits) : 64;
    Capacities capacities = read_capacities(least);
    const bool is_split = (flags & 2) != 0;
    const bool is_good = detail::sizing::is_valid<Index>(capacities);
    const uint64_t needed = is_split || !limits.is_valid() || !is_good
                                ? least
                                : Extractor<Index>::bytes_for(limits, capacities);
    if (needed > 1 << 20) return;
    const uint64_t bytes = read_bytes(needed, is_split);
    auto block = std::make_unique<OffsetMemory>(bytes, input_.below(4));
    const Memory memory = (flags & 4) != 0 && bytes == 0 ? Memory{} : block->memory();
    Sink sink = make_sink(listener_);
    if ((flags & 0xF0) == 0xF0) sink.accept = nullptr;
    const int32_t threshold = read_threshold();

    const Status status = is_split ? extractor_.start(limits, threshold, memory, sink)
                                   : extractor_.start(limits, capacities, threshold, memory, sink);
    const Status expected = !limits.is_valid()       ? Status::bad_limits
                            : !is_split && !is_good  ? Status::bad_capacities
                            : sink.accept == nullptr ? Status::bad_sink
                            : bytes < needed         ? Status::too_little_memory
                                                     : Status::ok;
    require(status == expected, "start() comes to another status");
    if (status == Status::too_little_memory) state_ = State::idle;
    if (status != Status::ok) {
      require(block->is_untouched(), "a start in vain has written");
      return;
    }
    check_own_memory();
    block_ = std::move(block);
    limits_ = limits;
    threshold_ = threshold;
    require(extractor_.bytes_used() <= bytes, "more bytes in use than were given");
    begin();
  }

  void reset() {
    const Status expected = state_ == State::idle ? Status::not_started : Status::ok;
    require(extractor_.reset() == expected, "reset() comes to another status");
    if (expected == Status::ok) begin();
  }

  void begin() {
    state_ = State::scanning;
    was_abandoned_ = false;
    on_.clear();
    skipped_ = 0;
    listener_.listen();
  }

  Limits read_limits(uint32_t flags) {
    const Border border = (flags & 1) != 0 ? Border::open : Border::closed;
    const uint32_t width = input_.byte();
    const uint32_t height = input_.byte();
    // Mostly small, sometimes longer than a word, sometimes invalid.
    if (width == 255) return {0, 1 + height, border};
    if (width == 254) return {1 + height, Limits::max_extent + 1 + height, border};
    return {width < 200 ? 1 + width % 9 : 28 + width % 40, 1 + height % 7, border};
  }

  Capacities read_capacities(uint64_t min_bytes) {
    Capacities capacities = minimum_capacities();
    const uint32_t kind = input_.below(8);
    if (kind == 0) return capacities;
    if (kind == 1) {
      // Invalid: too few slots, or more than an index counts.
      capacities.slots = input_.below(2) != 0 ? capacities.slots - 1 : UINT32_MAX - input_.byte();
      return capacities;
    }
    if (kind == 2)
      return Extractor<Index>::default_capacities({9, 9}, min_bytes + 16 * input_.byte());
    capacities.slots += input_.byte();
    capacities.holes += input_.below(16);
    return capacities;
  }

  // Mostly the exact size, so that a write beyond it is detected.
  uint64_t read_bytes(uint64_t needed, bool is_split) {
    const uint32_t kind = input_.byte();
    if (kind < 20) return needed - 1 - (kind < 10 ? 0 : input_.byte() % needed);
    if (kind < 24) return 0;
    return needed + (is_split ? 8 * input_.byte() : kind % 4 == 0 ? input_.byte() : 0);
  }

  int32_t read_threshold() {
    constexpr int32_t usual[] = {1,     128,   0,     -5,        255,      256,
                                 40000, 65535, 65536, INT32_MIN, INT32_MAX};
    return usual[input_.below(std::size(usual))];
  }

  // ---- samples ----

  size_t column() const { return on_.size() % limits_.width; }
  size_t rows() const { return on_.size() / limits_.width; }
  bool is_refused() const { return listener_.refuses_now(); }

  /// The expected result of a call that pushes samples, if the sink accepts everything.
  Status for_samples() const {
    if (state_ == State::idle) return Status::not_started;
    return state_ == State::scanning ? Status::ok : Status::finished;
  }

  template <class Sample>
  void push() {
    const uint32_t stride = input_.below(16) == 0 ? 0 : 1 + input_.below(3);
    // A stride of 0 repeats one sample.
    uint32_t count = input_.byte() % (state_ == State::idle ? 4 : 3 * limits_.width + 2);
    if (on_.size() + count > max_voxels) count = 0;
    std::vector<uint8_t> on(count);
    for (uint32_t i = 0; i < count; i += 8) {
      const uint32_t bits = input_.byte();
      for (uint32_t k = i; k < i + 8 && k < count; ++k) {
        // If the threshold is outside the range of the type, all samples are on, or all off.
        const bool reaches = threshold_ <= int64_t{std::numeric_limits<Sample>::max()};
        const bool misses = threshold_ > int64_t{std::numeric_limits<Sample>::min()};
        const uint32_t bit = stride == 0 ? bits & 1 : bits >> (k - i) & 1;
        on[k] = reaches && (bit != 0 || !misses);
        if (stride == 0) on[k] = on[0];
      }
    }
    const uint32_t noise = input_.byte() * 0x101;
    const size_t length = count == 0 ? 0 : size_t{count - 1} * stride + 1;
    // The samples between have the opposite value.
    std::vector<Sample> samples(length);
    for (size_t i = 0; i < length; ++i) {
      const bool is_sample = stride == 0 || i % stride == 0;
      const bool bit = on[stride == 0 ? 0 : i / stride] != 0;
      samples[i] = sample_of<Sample>(is_sample ? bit : !bit, threshold_, noise);
    }
    took(extractor_.push(samples.data(), count, stride), on);
  }

  // Checks the result of push(), and records the accepted samples.
  void took(const PushResult& pushed, const std::vector<uint8_t>& on) {
    if (for_samples() != Status::ok) {
      require(pushed.status == for_samples(), "push() comes to another error");
      require(pushed.samples == 0, "samples taken in spite of an error");
      return;
    }
    require(pushed.samples <= on.size(), "push() took more than it was given");
    on_.insert(on_.end(), on.begin(), on.begin() + pushed.samples);
    require(pushed.status == Status::suspended || pushed.status == Status::ok,
            to_string(pushed.status));
    require((pushed.status == Status::suspended) == is_refused(), "push() and the sink disagree");
    if (pushed.status == Status::ok)
      require(pushed.samples == on.size(), "push() came to ok and took a part");
    else
      require(pushed.samples == 0 || column() == 0, "suspended in the middle of a row");
  }

  template <class Call>
  void whole_row(Call call, const std::vector<uint8_t>& on) {
    const bool was_refused = is_refused();
    const bool is_between = state_ == State::idle || column() == 0;
    const PushResult pushed = call();
    if (for_samples() != Status::ok) {
      require(pushed.status == for_samples(), "a row comes to another error");
      require(pushed.samples == 0, "a row taken in spite of an error");
      return;
    }
    if (pushed.samples == 0) {
      const bool is_suspended = pushed.status == Status::suspended && was_refused && is_refused();
      const bool is_misuse = pushed.status == Status::row_in_progress && !is_between;
      require(is_suspended || is_misuse, "a row is not taken for no reason");
      return;
    }
    require(is_between, "a row taken in the middle of a row");
    require(pushed.samples == limits_.width, "a part of a row taken");
    require(pushed.status == (is_refused() ? Status::suspended : Status::ok),
            to_string(pushed.status));
    on_.insert(on_.end(), on.begin(), on.end());
  }

  bool has_room() const {
    return state_ == State::idle || on_.size() + limits_.width <= max_voxels;
  }

  void push_bits() {
    if (!has_room()) return;
    const uint32_t width = state_ == State::idle ? 1 : limits_.width;
    std::vector<uint8_t> bits((width + 7) / 8);
    for (uint8_t& byte : bits) byte = static_cast<uint8_t>(input_.byte());
    std::vector<uint8_t> on(width);
    for (size_t x = 0; x < width; ++x) on[x] = bits[x / 8] >> x % 8 & 1;
    whole_row([&] { return extractor_.push_bits(bits.data()); }, on);
  }

  void skip_row() {
    if (!has_room()) return;
    const bool repeats = input_.below(2) != 0;
    std::vector<uint8_t> on(state_ == State::idle ? 1 : limits_.width);
    if (repeats && state_ == State::scanning && rows() > 0 && column() == 0)
      std::copy(on_.end() - static_cast<std::ptrdiff_t>(on.size()), on_.end(), on.begin());
    const size_t before = on_.size();
    whole_row(
        [&] { return extractor_.skip_row(repeats ? Substitute::previous_row : Substitute::off); },
        on);
    if (on_.size() > before) ++skipped_;
  }

  // ---- resuming and ending ----

  void resume() {
    const Status status = extractor_.resume();
    const Status expected = state_ == State::idle ? Status::not_started
                            : is_refused()        ? Status::suspended
                                                  : Status::ok;
    require(status == expected, "resume() comes to another status");
    look_for_end(status);
  }

  void finish() {
    const bool is_between = state_ != State::idle && on_.size() % slice() == 0;
    const State before = state_;
    const Status status = extractor_.finish();
    if (before == State::scanning && !is_between) {
      require(status == Status::slice_in_progress, "a slice that is not complete is finished");
      return;
    }
    if (before == State::scanning) state_ = State::finishing;
    ended(status);
  }

  void abandon() {
    const State before = state_;
    const Status status = extractor_.abandon();
    if (before == State::scanning) {
      state_ = State::finishing;
      was_abandoned_ = true;
    }
    ended(status);
  }

  void ended(Status status) {
    const Status expected = state_ == State::idle ? Status::not_started
                            : is_refused()        ? Status::suspended
                                                  : Status::ok;
    require(status == expected, "an ending comes to another status");
    look_for_end(status);
  }

  void look_for_end(Status status) {
    if (state_ == State::finishing && status == Status::ok) {
      state_ = State::finished;
      check_scan();
    }
    if (state_ == State::finished)
      require(listener_.collector().is_finished(), "the scan has no finish event");
  }

  // Ends the current scan, so that each run is checked.
  void end() {
    listener_.refuse(0, 0);
    if (state_ == State::scanning && on_.size() % slice() == 0) finish();
    abandon();
    if (state_ != State::idle) look();
  }

  // Continues the scan in another object and in other memory, which contains only the used bytes.
  void fail_power() {
    Memory parts[2];
    const Status expected = state_ == State::idle ? Status::not_started
                            : is_refused()        ? Status::suspended
                                                  : Status::ok;
    require(extractor_.save(parts) == expected, "save() comes to another status");
    if (expected != Status::ok) return;
    const size_t used = parts[1].bytes;
    require(used == extractor_.bytes_used(), "the part of the memory is not bytes_used()");
    const auto image = test::image_of({parts, parts + 2});
    auto block = std::make_unique<OffsetMemory>(block_->memory().bytes, block_->offset());
    const Memory memory = block->memory();
    check_own_memory();
    block_ = std::move(block);
    const std::vector<Memory> to = {memory_of(extractor_), memory};
    const Sink sink = make_sink(listener_);
    test::read_back(image, to);
    uint8_t& any = static_cast<uint8_t*>(memory.data)[input_.byte() % used];
    any = static_cast<uint8_t>(any ^ 1);
    require(extractor_.restore(memory, sink) == Status::bad_checkpoint,
            "memory with a wrong bit passes for what was saved");
    test::read_back(image, to);
    require(extractor_.restore(memory, sink) == Status::ok, "restore() fails");
  }

  // ---- checks ----

  size_t slice() const { return size_t{limits_.width} * limits_.height; }

  void check_scan() const {
    const Collector& collector = listener_.collector();
    const bool is_closed = limits_.border == Border::closed;
    const auto depth = static_cast<uint32_t>((on_.size() + slice() - 1) / slice());
    BitVolume volume({limits_.width, limits_.height, depth});
    std::copy(on_.begin(), on_.end(), volume.on.begin());
    require(collector.was_abandoned() == was_abandoned_,
            "the finish event has the wrong is_abandoned");
    require(collector.layers().size() == depth, "another number of slices");
    require(collector.skipped().size() == skipped_, "another number of skipped rows");
    require(collector.statistics().skipped_rows == skipped_, "skipped rows are counted wrong");
    const std::string unlike = unlike_joined({collector}, merge(volume, is_closed));
    require(unlike.empty(), unlike.c_str());
  }

  void check_own_memory() const {
    require(block_ == nullptr || block_->is_intact(), "a write before the memory");
  }

  // The queries of an extractor.
  void look() const {
    const Peaks most = extractor_.peaks();
    const Capacities& room = extractor_.capacities();
    if (state_ == State::idle) return;
    require(most.slots <= room.slots, "more in use than there is room for");
    require(extractor_.statistics().skipped_rows == skipped_, "skipped rows are counted wrong");
    require(extractor_.limits().width == limits_.width, "other limits");
    require(extractor_.bytes_used() <= block_->memory().bytes, "more bytes in use than given");
    if (state_ == State::scanning)
      require(size_t{extractor_.slices()} * limits_.height + extractor_.rows() == rows(),
              "other rows counted than given");
  }

  Input& input_;
  Listener listener_;
  std::unique_ptr<OffsetMemory> block_;
  Extractor<Index> extractor_;
  Limits limits_{1, 1};
  int32_t threshold_ = 0;
  State state_ = State::idle;
  bool was_abandoned_ = false;
  std::vector<uint8_t> on_;  // of the voxels of this scan so far
  uint64_t skipped_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  if (input.below(2) != 0)
    Caller<uint32_t>(input).run();
  else
    Caller<uint16_t>(input).run();
  return 0;
}

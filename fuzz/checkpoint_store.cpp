// Fuzz target. A store obeys the rules of flash for any contents of the flash, and for any failure
// of the power or a call. It reads back the newest complete checkpoint as saved, unless another
// program wrote to the flash.
//
//   fuzz_checkpoint_store -max_len=400 corpus/checkpoint_store      with libFuzzer
//   fuzz_checkpoint_store corpus/checkpoint_store                   with replay_main.cpp

#include <cstring>
#include <discmc/checkpoint_store.hpp>
#include <discmc/stream/crc32.hpp>
#include <new>

#include "input.hpp"
#include "oracle/simulated_flash.hpp"
#include "require.hpp"

using namespace discmc;
using reference::SimulatedFlash;

namespace {

constexpr uint32_t max_bytes = 600;
constexpr FlashGeometry geometries[] = {{16, 64, 25}, {64, 256, 7}, {32, 2048, 2}, {256, 1024, 3}};

/// Contents that contain their number.
std::vector<uint8_t> contents_of(uint32_t number, uint32_t count) {
  std::vector<uint8_t> bytes(count);
  for (uint32_t i = 0; i < count; ++i)
    bytes[i] = static_cast<uint8_t>(i < 4 ? number >> 8 * i : number * 31 + i * i);
  return bytes;
}

class Caller {
 public:
  explicit Caller(Input& input)
      : input_(input),
        geometry_(geometries[input.below(4)]),
        flash_(geometry_, input.byte(),
               input.below(4) == 0 ? SimulatedFlash::Kind::fram : SimulatedFlash::Kind::flash),
        buffer_(geometry_.program_bytes) {}

  void run() {
    start();
    while (!input_.is_empty()) call();
    start();
    require(!flash_.has_broken_rules, "the rules of flash are broken");
  }

 private:
  void call() {
    switch (input_.below(10)) {
      case 0:
      case 1:
        return save();
      case 2:
        return start();
      case 3:
        return flash_.cut_after(1 + input_.word() % 4000);
      case 4:
        return flash_.fail_call(input_.below(40));
      case 5:
        return (void)store_.erase_ahead(input_.word());
      case 6:
        return flip();
      case 7:
        return put_head();
      case 8:
        return discard();
      default:
        return begin_in_vain();
    }
  }

  // The power returns; everything outside the flash is lost.
  void start() {
    flash_.power_on();
    flash_.fail_call(UINT64_MAX - flash_.calls);
    new (&store_) CheckpointStore{};
    const Status status =
        store_.start(flash_.device(), max_bytes, {buffer_.data(), buffer_.size()});
    require(status == Status::ok, "start() fails");
    require(store_.has_checkpoint() || newest_ == 0 || may_be_discarded_ || is_disturbed_,
            "the checkpoint is lost");
    require(!store_.has_checkpoint() || !is_discarded_ || is_disturbed_,
            "a discarded checkpoint is found");
    if (store_.has_checkpoint()) check();
  }

  void check() {
    std::vector<uint8_t> bytes(store_.bytes());
    const Memory part{bytes.data(), bytes.size()};
    require(store_.restore(&part, 1) == Status::ok, "what was found cannot be read");
    require(bytes.size() >= 4, "a checkpoint that was never saved");
    const uint32_t number =
        bytes[0] | uint32_t{bytes[1]} << 8 | uint32_t{bytes[2]} << 16 | uint32_t{bytes[3]} << 24;
    require(bytes == contents_of(number, store_.bytes()), "a checkpoint that was never saved");
    require(number <= last_, "a checkpoint that was never saved");
    require(number >= newest_ || is_disturbed_, "an older checkpoint than the newest");
    newest_ = number;
  }

  void save() {
    is_discarded_ = false;  // a failed save may be complete in flash
    std::vector<uint8_t> bytes = contents_of(++last_, 4 + input_.word() % (max_bytes - 3));
    const Memory part{bytes.data(), bytes.size()};
    Status status = store_.save(&part, 1);
    while (status == Status::suspended) status = store_.resume();
    require(status == Status::ok || status == Status::device_error, to_string(status));
    if (status == Status::ok) note_saved();
  }
  void note_saved() {
    newest_ = last_;
    may_be_discarded_ = false;
  }

  void discard() {
    const bool has_checkpoint = store_.has_checkpoint();
    may_be_discarded_ = may_be_discarded_ || has_checkpoint;
    Status status = store_.discard();
    while (status == Status::suspended) status = store_.resume();
    require(status == Status::ok || status == Status::device_error, to_string(status));
    if (status == Status::ok) is_discarded_ = has_checkpoint || is_discarded_;
  }

  void begin_in_vain() {
    is_discarded_ = false;
    std::vector<uint8_t> bytes = contents_of(++last_, max_bytes);
    const Memory part{bytes.data(), bytes.size()};
    Status status = store_.save(&part, 1);
    for (uint32_t steps = input_.below(8); steps > 0 && status == Status::suspended; --steps)
      status = store_.resume();
    if (status == Status::ok) note_saved();
    // Its part is about to be destroyed, so the save must end.
    if (status == Status::suspended) (void)store_.restore(&part, 0);
  }

  // ---- other programs ----

  void flip() {
    is_disturbed_ = true;
    uint8_t& byte = flash_.bytes[input_.word() % flash_.bytes.size()];
    byte = static_cast<uint8_t>(byte ^ 1 << input_.below(8));
  }

  // A head with any number and any size.
  void put_head() {
    is_disturbed_ = true;
    StoredHead head{StoredHead::current_format, input_.number(UINT32_MAX), input_.word(), 0};
    head.checksum = crc32(reinterpret_cast<const uint8_t*>(&head), 12);
    const uint32_t units = geometry_.units_per_block() * geometry_.blocks;
    std::memcpy(&flash_.bytes[size_t{input_.word() % units} * geometry_.program_bytes], &head,
                sizeof head);
  }

  Input& input_;
  FlashGeometry geometry_;
  SimulatedFlash flash_;
  std::vector<uint8_t> buffer_;
  CheckpointStore store_{};
  uint32_t newest_ = 0, last_ = 0;
  bool is_discarded_ = false;      // the newest checkpoint
  bool may_be_discarded_ = false;  // a failure may have interrupted discard()
  bool is_disturbed_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Input input(data, size);
  Caller(input).run();
  return 0;
}

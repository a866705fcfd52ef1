// Where an encoder's bytes go.
#ifndef DISCMC_BYTE_OUTPUT_HPP
#define DISCMC_BYTE_OUTPUT_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

/// Where bytes go: a UART, a ring buffer, a file. Owner: the context belongs to the caller, and
/// must stay until there is another output, or the encoder is used no more.
///
/// write() is called within calls of the encoder or SharedOutput that has it, and of the extractor
/// before that, by the same thread, and at no other time. It may wait. It must not call a function
/// of any of them that does something or saves, nor throw: the library is compiled without
/// exceptions.
struct ByteOutput {
  void* context = nullptr;
  /// Takes up to `count` bytes and returns how many it took, never more; 0 means "not now". On
  /// error, return 0. bytes: valid during the call.
  size_t (*write)(void* context, const uint8_t* bytes, size_t count) = nullptr;
};

// ---- One link for several encoders: their frames go out in turns, each of them whole.
//
//   static SharedOutput link;
//   link.start({nullptr, uart_write});
//   encoders[i].start(label, link.output());     // each with a channel of its own
//   ...
//   while (!link.flush() && link_is_up) sleep();  // after all have finished
//
// The output stays what it is. Where the link is dead, set_output({}) of the encoders, each of
// them, drops what comes, and set_output(link.output()) takes their streams up again. A frame that
// is held waits for the link meanwhile.

/// It holds a frame: what one encoder has begun to send is no matter of the others, who would wait
/// for ever if that one had nothing more to say. The outputs that it gives point to it, so it is
/// neither copied nor moved. Nothing is locked: the encoders of a link belong to one context.
class SharedOutput {
 public:
  SharedOutput() = default;
  SharedOutput(const SharedOutput&) = delete;
  SharedOutput& operator=(const SharedOutput&) = delete;

  /// Drops a frame that is held.
  void start(const ByteOutput& output) {
    output_ = output;
    held_ = 0;
    sent_ = 0;
  }

  /// The output of every encoder; before start(), or where that got none, one without a function,
  /// with which encoders do not start.
  ByteOutput output() {
    if (output_.write == nullptr) return {};
    return {this, [](void* context, const uint8_t* bytes, size_t count) {
              return static_cast<SharedOutput*>(context)->take(bytes, count);
            }};
  }

  /// Hands over what is held. False when the output does not take all of it now: call again, as
  /// long as there is hope, as on a dead link it stays so.
  [[nodiscard]] bool flush() {
    while (sent_ < held_) {
      const size_t taken = output_.write(output_.context, frame_ + sent_, held_ - sent_);
      if (taken == 0) return false;
      sent_ += taken;
    }
    return true;
  }

 private:
  // All or nothing. An encoder offers a frame at a time.
  size_t take(const uint8_t* bytes, size_t count) {
    if (!flush()) return 0;
    for (size_t i = 0; i < count; ++i) frame_[i] = bytes[i];
    held_ = count;
    sent_ = 0;
    (void)flush();  // the rest when it is asked again
    return count;
  }

  ByteOutput output_;
  size_t held_ = 0;
  size_t sent_ = 0;
  uint8_t frame_[wire::max_frame] = {};
};

}  // namespace discmc

#endif

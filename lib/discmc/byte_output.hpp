// The output of an encoder: a write function with a context.
#ifndef DISCMC_BYTE_OUTPUT_HPP
#define DISCMC_BYTE_OUTPUT_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

/// The destination of a stream: a UART, a ring buffer, a file. Owner: the context belongs to the
/// caller, and must exist until the encoder has another output or is no longer used.
///
/// write() is called during calls of the encoder, or of the extractor in front of it, in the
/// caller's thread. It may block. It must not throw: the library is compiled without exceptions. It
/// must not call a function that changes or saves one of these objects.
struct ByteOutput {
  void* context = nullptr;
  /// Accepts up to `count` bytes, and returns how many it accepted. 0 means busy; return 0 on an
  /// error, too. If the link is dead, call set_output() of the encoder, because resume() keeps
  /// returning Status::suspended. bytes: valid during the call.
  size_t (*write)(void* context, const uint8_t* bytes, size_t count) = nullptr;
};

// ---- One link for several encoders: their frames alternate on the link, each frame whole.
//
//   static SharedOutput link;
//   link.start({nullptr, uart_write});
//   encoders[i].start(label, link.output());     // each with a channel of its own
//   ...
//   while (!link.flush() && link_is_up) sleep();  // after all have finished
//
// If the link is dead, call set_output({}) of every encoder: the encoders drop their streams, and
// the scans continue. Later set_output(link.output()) resumes each stream. The frame that the
// SharedOutput holds waits for the link meanwhile.

/// Buffers one frame, so that an encoder with an unfinished frame cannot block the others for ever.
/// Its outputs point to this object, so it is neither copied nor moved. It locks nothing: call all
/// encoders of a link from one context.
class SharedOutput {
 public:
  SharedOutput() = default;
  SharedOutput(const SharedOutput&) = delete;
  SharedOutput& operator=(const SharedOutput&) = delete;

  /// Sets the output and drops a held frame.
  void start(const ByteOutput& output) {
    output_ = output;
    held_ = 0;
    sent_ = 0;
  }

  /// Returns the output for every encoder. Before start(), returns an output that encoders reject
  /// with bad_sink.
  ByteOutput output() {
    if (output_.write == nullptr) return {};
    return {this, [](void* context, const uint8_t* bytes, size_t count) {
              return static_cast<SharedOutput*>(context)->take(bytes, count);
            }};
  }

  /// Sends the held frame. Returns false if the output did not accept all of it: call again, unless
  /// the link is dead.
  [[nodiscard]] bool flush() {
    while (sent_ < held_) {
      const size_t taken = output_.write(output_.context, frame_ + sent_, held_ - sent_);
      if (taken == 0) return false;
      sent_ += taken;
    }
    return true;
  }

 private:
  // All or nothing: an encoder offers one frame at a time.
  size_t take(const uint8_t* bytes, size_t count) {
    if (!flush()) return 0;
    for (size_t i = 0; i < count; ++i) frame_[i] = bytes[i];
    held_ = count;
    sent_ = 0;
    (void)flush();  // the next call sends the rest
    return count;
  }

  ByteOutput output_;
  size_t held_ = 0;
  size_t sent_ = 0;
  uint8_t frame_[wire::max_frame] = {};
};

}  // namespace discmc

#endif

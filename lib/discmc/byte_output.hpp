// The output of an encoder: a write function with a context.
#ifndef DISCMC_BYTE_OUTPUT_HPP
#define DISCMC_BYTE_OUTPUT_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

/// The destination of a stream: a UART, a ring buffer, a file. Owner: the context belongs to the
/// caller, and must exist until the encoder has another output or is no longer used.
///
/// Both functions are called during calls of the encoder, or of the extractor in front of it, in
/// the caller's thread. They may block. They must not throw: the library is compiled without
/// exceptions. They must not call a function that changes or saves one of these objects.
struct ByteOutput {
  void* context = nullptr;
  /// Accepts up to `count` bytes, and returns how many it accepted. 0 means busy; return 0 on an
  /// error, too. If the link is dead, call set_output() of the encoder, because resume() keeps
  /// returning Status::suspended. bytes: valid during the call.
  size_t (*write)(void* context, const uint8_t* bytes, size_t count) = nullptr;
  /// Returns how many accepted bytes a power failure would still lose: those in the queue of a
  /// driver, a DMA or a radio. A function that only returns 0 states that write() queues nothing.
  /// save() of an encoder waits until it returns 0, and fails with bad_sink if it is null. Programs
  /// without checkpoints leave it null.
  size_t (*unsent)(void* context) = nullptr;
  /// The longest frame of regions, fragments or slices; 0: max_frame_limit. Short frames suit links
  /// that lose short frames of their own: a lost one costs a packet. They make the stream longer
  /// (docs/receiving.md). Others may be longer: headers have up to 66 bytes, trailers 86,
  /// application records 22 more than their data, and appended packets max_frame_limit. Units:
  /// bytes. Limit: 0, or min_frame_limit to max_frame_limit.
  uint16_t max_frame = 0;

  static constexpr uint16_t min_frame_limit = 48;
  static constexpr uint16_t max_frame_limit = detail::wire::max_frame;

  constexpr bool is_valid() const {
    const bool has_limit = max_frame >= min_frame_limit && max_frame <= max_frame_limit;
    return write != nullptr && (max_frame == 0 || has_limit);
  }
};

// ---- One link for several encoders: their frames alternate on the link, each frame whole.
//
//   static SharedOutput link;
//   link.start({nullptr, uart_write});
//   encoders[i].start(label, link.output());     // each with a channel of its own
//   ...
//   while (link.flush() == Status::suspended && link_is_up) sleep();  // after all have finished
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
  /// with bad_sink. Its unsent() counts the held frame, and is null if that of the output is.
  ByteOutput output() {
    if (output_.write == nullptr) return {};
    ByteOutput shared{this, [](void* context, const uint8_t* bytes, size_t count) {
                        return static_cast<SharedOutput*>(context)->accept(bytes, count);
                      }};
    shared.max_frame = output_.max_frame;
    if (output_.unsent != nullptr)
      shared.unsent = [](void* context) { return static_cast<SharedOutput*>(context)->unsent(); };
    return shared;
  }

  /// Sends the held frame. Status::suspended: the output did not accept all of it; call again,
  /// unless the link is dead.
  [[nodiscard]] Status flush() {
    while (sent_ < held_) {
      const size_t written = output_.write(output_.context, frame_ + sent_, held_ - sent_);
      if (written == 0) return Status::suspended;
      sent_ += written;
    }
    return Status::ok;
  }

 private:
  // All or nothing: an encoder offers one frame at a time.
  size_t accept(const uint8_t* bytes, size_t count) {
    if (flush() != Status::ok) return 0;
    for (size_t i = 0; i < count; ++i) frame_[i] = bytes[i];
    held_ = count;
    sent_ = 0;
    (void)flush();  // the next call sends the rest
    return count;
  }

  size_t unsent() {
    (void)flush();
    return held_ - sent_ + output_.unsent(output_.context);
  }

  ByteOutput output_;
  size_t held_ = 0;
  size_t sent_ = 0;
  uint8_t frame_[detail::wire::max_frame] = {};
};

}  // namespace discmc

#endif

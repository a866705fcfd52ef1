// Where the events of a surface go while it is extracted.
#ifndef DISCMC_COMMAND_COMMANDS_SURFACE_RECEIVER_HPP
#define DISCMC_COMMAND_COMMANDS_SURFACE_RECEIVER_HPP

#include <discmc/encoder.hpp>
#include <discmc/sink.hpp>

#include "require.hpp"
#include "surface/growing_joiner.hpp"
#include "surface/surface_builder.hpp"

namespace discmc::host {

/// Gives every event to an encoder and, joined, to a surface: to either or both, as they are begun.
class SurfaceReceiver {
 public:
  /// Begins a stream. output: must take all; Owner: the caller.
  void start_stream(const StreamLabel& label, const ByteOutput& output) {
    require(encoder_.start(label, output));
    encodes_ = true;
  }
  /// Begins to keep polygons.
  void start_surface() { builds_ = true; }

  Answer take(const Event& event) {
    if (encodes_ && encoder_.take(event) != Answer::taken) return Answer::not_now;
    return builds_ ? joiner_.take(event) : Answer::taken;
  }

  /// Of the stream; 0 without one.
  std::uint64_t stream_bytes() const { return encodes_ ? encoder_.bytes() : 0; }
  /// Empty unless begun. The spacing is for the caller to set.
  Surface& surface() { return builder_.surface(); }

 private:
  NormalEncoder encoder_;
  SurfaceBuilder builder_;
  GrowingJoiner joiner_{sink_to(builder_)};
  bool encodes_ = false;
  bool builds_ = false;
};

}  // namespace discmc::host

#endif

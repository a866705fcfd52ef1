// The lines of a scanner on a GPIO chip, and their events from the kernel.
//
// The two versions of libgpiod have different interfaces. Each has a file, line_events_v1.cpp or
// line_events_v2.cpp; CMake compiles the one that fits.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace discmc::device {

enum class LineRole : std::uint8_t { sync, button, end_stop };

/// A change of a line. The sync line and the end-stop report only changes to active.
struct LineEvent {
  LineRole role;
  bool is_active;
  std::uint64_t time_ns;  ///< of a monotonic clock
  /// The number of the line's edge, from 1, including lost edges, if the kernel counts them (2.x).
  std::optional<std::uint32_t> number{};
  /// If the kernel does not count them (1.x): edges may have been dropped since the previous event.
  bool may_follow_loss = false;
};

/// The lines, by offset or name.
struct Wiring {
  std::string chip;  ///< by name, path or label
  std::string sync;
  std::string button;    ///< empty: none
  std::string end_stop;  ///< empty: none
  bool sync_is_falling = false;
  bool contacts_to_ground = false;  ///< button and end-stop: active is low, with a pull-up
};

/// Whether a line is given by its offset on the chip, not by its name.
inline bool is_offset(const std::string& line) {
  return line.find_first_not_of("0123456789") == std::string::npos && line.size() < 6;
}

class LineEvents {
 public:
  /// Requests the lines. Throws std::runtime_error with the line or chip that is not available.
  explicit LineEvents(const Wiring& wiring);
  ~LineEvents();
  LineEvents(const LineEvents&) = delete;
  LineEvents& operator=(const LineEvents&) = delete;

  /// Waits for events and returns them in the order of their times; none after a timeout or a
  /// signal. Throws DeviceGone if the chip has disappeared.
  std::vector<LineEvent> wait(std::chrono::milliseconds timeout);

 private:
  struct Lines;
  std::unique_ptr<Lines> lines_;
};

}  // namespace discmc::device

// The speed of reading the stream. A receiver that is slow, or stalls, fills the device's UART.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>

#include "scanner.hpp"

namespace discmc::simulator {

/// A pause of reading, from a row of the scan until the device has dropped this many frames.
struct HoldUp {
  std::uint32_t row, frames;
};

struct ListenerBehaviour {
  std::uint64_t bytes_per_second = 0;  ///< 0: unlimited
  /// Pauses of this length, after the scan has reached these rows.
  std::map<std::uint32_t, std::chrono::milliseconds> stalls;
  std::optional<HoldUp> hold_up;
};

class Listener {
 public:
  explicit Listener(const ListenerBehaviour& behaviour) : behaviour_(behaviour) {}

  /// Updates the position of the scan. Several rows may have been sent since the last call.
  void follow(const Scanner& scanner, Clock::time_point now) {
    auto& stalls = behaviour_.stalls;
    while (!stalls.empty() && stalls.begin()->first <= scanner.row()) {
      next_ = now + stalls.begin()->second;
      stalls.erase(stalls.begin());
    }
    const auto& hold_up = behaviour_.hold_up;
    is_held_up_ = hold_up && scanner.row() >= hold_up->row && scanner.drops() < hold_up->frames &&
                  !scanner.has_sent_all();
  }

  /// Returns the number of bytes to read now, at most `most`.
  std::size_t allowed(std::size_t most, Clock::time_point now) const {
    if (is_held_up_ || now < next_) return 0;
    return behaviour_.bytes_per_second > 0 ? 1 : most;
  }

  void has_read(std::size_t count, Clock::time_point now) {
    if (behaviour_.bytes_per_second == 0) return;
    next_ = now + std::chrono::nanoseconds(count * 1000000000 / behaviour_.bytes_per_second);
  }

  /// Returns the time of the next read, unless reading is paused.
  Clock::time_point next() const { return next_; }

 private:
  ListenerBehaviour behaviour_;
  Clock::time_point next_{};
  bool is_held_up_ = false;
};

}  // namespace discmc::simulator

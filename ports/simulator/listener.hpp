// How fast the stream is read: a receiver that is slow, or stalls, fills the device's UART.
#ifndef DISCMC_SIMULATOR_LISTENER_HPP
#define DISCMC_SIMULATOR_LISTENER_HPP

#include <chrono>
#include <cstdint>
#include <map>

namespace discmc::simulator {

struct ListenerBehaviour {
  std::uint64_t bytes_per_second = 0;  ///< 0: as fast as they come
  /// Reads nothing for so long from when the scan is at these rows.
  std::map<std::uint32_t, std::chrono::milliseconds> stalls;
};

class Listener {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Listener(const ListenerBehaviour& behaviour) : behaviour_(behaviour) {}

  /// The scan is at this row.
  void at_row(std::uint32_t row, Clock::time_point now) {
    const auto stall = behaviour_.stalls.find(row);
    if (stall == behaviour_.stalls.end()) return;
    next_ = now + stall->second;
    behaviour_.stalls.erase(stall);
  }

  /// How many bytes may be read now, when they are no more than `most`.
  std::size_t allowed(std::size_t most, Clock::time_point now) const {
    if (now < next_) return 0;
    return behaviour_.bytes_per_second > 0 ? 1 : most;
  }

  void has_read(std::size_t count, Clock::time_point now) {
    if (behaviour_.bytes_per_second == 0) return;
    next_ = now + std::chrono::nanoseconds(count * 1000000000 / behaviour_.bytes_per_second);
  }

  /// When it reads again.
  Clock::time_point next() const { return next_; }

 private:
  ListenerBehaviour behaviour_;
  Clock::time_point next_{};
};

}  // namespace discmc::simulator

#endif

// The presses of a bouncing button, and their lengths.
#pragma once

#include <cstdint>

namespace discmc::device {

class Button {
 public:
  enum class Press : std::uint8_t { none, brief, lengthy };

  /// Changes that follow another within this time are bouncing. Units: nanoseconds.
  static constexpr std::uint64_t bounce_ns = 20'000'000;
  /// The minimum duration of a lengthy press. Units: nanoseconds.
  static constexpr std::uint64_t lengthy_ns = 1'000'000'000;

  /// Processes a change of the contact. A press is reported when the button is released.
  Press update(bool is_pressed, std::uint64_t time_ns) {
    if (has_changed_ && time_ns - changed_ns_ < bounce_ns) return Press::none;
    const bool is_release = is_pressed_ && !is_pressed;
    const std::uint64_t held_ns = time_ns - changed_ns_;
    has_changed_ = true;
    is_pressed_ = is_pressed;
    changed_ns_ = time_ns;
    if (!is_release) return Press::none;
    return held_ns >= lengthy_ns ? Press::lengthy : Press::brief;
  }

 private:
  bool has_changed_ = false;
  bool is_pressed_ = false;
  std::uint64_t changed_ns_ = 0;
};

}  // namespace discmc::device

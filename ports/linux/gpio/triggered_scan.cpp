#include "triggered_scan.hpp"

namespace discmc::device {

void TriggeredScan::process(const LineEvent& event) {
  if (state_ == State::ended) return;
  switch (event.role) {
    case LineRole::sync:
      return process_edge(event);
    case LineRole::button:
      return press(button_.update(event.is_active, event.time_ns));
    case LineRole::end_stop:
      state_ = State::ended;
  }
}

void TriggeredScan::process_edge(const LineEvent& edge) {
  const std::uint32_t missed = counter_.missed_before(edge);
  if (state_ != State::running) {
    ++unused_;
    return;
  }
  ++edges_;
  if (missed > 0 && !first_missed_row_) first_missed_row_ = scan_.rows();
  missed_ += missed;
  scan_.skip(missed);
  if (!scan_.has_all_rows() && source_.read(scan_.rows(), row_))
    scan_.push(row_.data());
  else
    state_ = State::ended;
  if (scan_.has_all_rows()) state_ = State::ended;
}

void TriggeredScan::press(Button::Press press) {
  if (press == Button::Press::lengthy) state_ = State::ended;
  if (press == Button::Press::brief)
    state_ = state_ == State::running ? State::paused : State::running;
}

void TriggeredScan::report(std::ostream& out) const {
  out << "edges " << edges_ << '\n'
      << "edges_missed " << missed_ << '\n'
      << "edges_unused " << unused_ << '\n'
      << "long_intervals " << counter_.long_intervals() << '\n';
}

}  // namespace discmc::device

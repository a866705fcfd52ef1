// Line events by libgpiod 1.x. The kernel has a queue of 16 events per line, and drops events while
// it is full. Events have times but no numbers, so only a full queue is detected.
#include <gpiod.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "common/device_gone.hpp"
#include "line_events.hpp"

namespace discmc::device {
namespace {

constexpr unsigned queue_events = 16;

std::string reason() {
  return std::strerror(errno);
}

}  // namespace

struct LineEvents::Lines {
  struct RequestedLine {
    LineRole role;
    gpiod_line* handle;
    bool was_full = false;  // whether its queue was full at the last read
  };

  gpiod_chip* chip = nullptr;
  std::vector<RequestedLine> requested;

  ~Lines() {
    if (chip != nullptr) gpiod_chip_close(chip);  // also closes the lines
  }

  void request(LineRole role, const std::string& name, int request_type, int flags) {
    gpiod_line* handle = is_offset(name)
                             ? gpiod_chip_get_line(chip, static_cast<unsigned>(std::stoul(name)))
                             : gpiod_chip_find_line(chip, name.c_str());
    if (handle == nullptr)
      throw std::runtime_error("the GPIO chip has no line '" + name +
                               "'; list the lines with gpioinfo");
    const gpiod_line_request_config config{"discmc-gpio", request_type, flags};
    if (gpiod_line_request(handle, &config, 0) != 0)
      throw std::runtime_error("GPIO line '" + name + "' cannot be requested: " + reason());
    requested.push_back({role, handle});
  }

  void read(RequestedLine& line, std::vector<LineEvent>& events) {
    std::array<gpiod_line_event, queue_events> queue;
    const int count = gpiod_line_event_read_multiple(line.handle, queue.data(), queue_events);
    if (count < 0) throw DeviceGone("the GPIO chip is gone: " + reason());
    for (int i = 0; i < count; ++i) {
      const gpiod_line_event& edge = queue[static_cast<std::size_t>(i)];
      LineEvent event{};
      event.role = line.role;
      event.is_active =
          line.role == LineRole::sync || edge.event_type == GPIOD_LINE_EVENT_RISING_EDGE;
      event.time_ns = static_cast<std::uint64_t>(edge.ts.tv_sec) * 1'000'000'000U +
                      static_cast<std::uint64_t>(edge.ts.tv_nsec);
      event.may_follow_loss = line.was_full;
      events.push_back(event);
    }
    line.was_full = static_cast<unsigned>(count) == queue_events;
  }
};

LineEvents::LineEvents(const Wiring& wiring) : lines_(std::make_unique<Lines>()) {
  lines_->chip = gpiod_chip_open_lookup(wiring.chip.c_str());
  if (lines_->chip == nullptr)
    throw std::runtime_error("no GPIO chip '" + wiring.chip + "': " + reason() +
                             "; list the chips with gpiodetect");
  const int contact = wiring.contacts_to_ground ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW |
                                                      GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP
                                                : 0;
  if (!wiring.button.empty())
    lines_->request(LineRole::button, wiring.button, GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES, contact);
  if (!wiring.end_stop.empty())
    lines_->request(LineRole::end_stop, wiring.end_stop, GPIOD_LINE_REQUEST_EVENT_RISING_EDGE,
                    contact);
  lines_->request(LineRole::sync, wiring.sync,
                  wiring.sync_is_falling ? GPIOD_LINE_REQUEST_EVENT_FALLING_EDGE
                                         : GPIOD_LINE_REQUEST_EVENT_RISING_EDGE,
                  0);
}

LineEvents::~LineEvents() = default;

std::vector<LineEvent> LineEvents::wait(std::chrono::milliseconds timeout) {
  gpiod_line_bulk all = GPIOD_LINE_BULK_INITIALIZER;
  gpiod_line_bulk ready = GPIOD_LINE_BULK_INITIALIZER;
  for (const Lines::RequestedLine& line : lines_->requested) gpiod_line_bulk_add(&all, line.handle);
  const timespec limit{timeout.count() / 1000, timeout.count() % 1000 * 1'000'000};
  const int found = gpiod_line_event_wait_bulk(&all, &limit, &ready);
  std::vector<LineEvent> events;
  if (found == 0 || (found < 0 && errno == EINTR)) return events;
  if (found < 0 || gpiod_line_bulk_num_lines(&ready) == 0)
    throw DeviceGone("the GPIO chip is gone: " + reason());
  for (Lines::RequestedLine& line : lines_->requested)
    for (unsigned i = 0; i < gpiod_line_bulk_num_lines(&ready); ++i)
      if (gpiod_line_bulk_get_line(&ready, i) == line.handle) lines_->read(line, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const LineEvent& a, const LineEvent& b) { return a.time_ns < b.time_ns; });
  return events;
}

}  // namespace discmc::device

// Line events by libgpiod 2.x: one queue for all lines, of the kernel's maximum size. Every event
// has the number of its edge. While the queue is full the kernel drops the oldest event.
#include <gpiod.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "common/device_gone.hpp"
#include "line_events.hpp"

namespace discmc::device {
namespace {

// The maximum of the kernel: 16 for each of the 64 lines of a request.
constexpr std::size_t queue_events = 1024;

template <auto function>
struct Releases {
  template <class Object>
  void operator()(Object* object) const {
    function(object);
  }
};
using Chip = std::unique_ptr<gpiod_chip, Releases<gpiod_chip_close>>;
using ChipInfo = std::unique_ptr<gpiod_chip_info, Releases<gpiod_chip_info_free>>;
using Settings = std::unique_ptr<gpiod_line_settings, Releases<gpiod_line_settings_free>>;
using LineConfig = std::unique_ptr<gpiod_line_config, Releases<gpiod_line_config_free>>;
using RequestConfig = std::unique_ptr<gpiod_request_config, Releases<gpiod_request_config_free>>;
using Request = std::unique_ptr<gpiod_line_request, Releases<gpiod_line_request_release>>;
using Buffer = std::unique_ptr<gpiod_edge_event_buffer, Releases<gpiod_edge_event_buffer_free>>;

std::string reason() {
  return std::strerror(errno);
}

bool is_called(gpiod_chip* chip, const std::string& name) {
  const ChipInfo info(gpiod_chip_get_info(chip));
  return info != nullptr && (name == gpiod_chip_info_get_name(info.get()) ||
                             name == gpiod_chip_info_get_label(info.get()));
}

Chip open_chip(const std::string& name) {
  if (gpiod_is_gpiochip_device(name.c_str())) return Chip(gpiod_chip_open(name.c_str()));
  for (const auto& entry : std::filesystem::directory_iterator("/dev")) {
    if (!gpiod_is_gpiochip_device(entry.path().c_str())) continue;
    Chip chip(gpiod_chip_open(entry.path().c_str()));
    if (chip != nullptr && is_called(chip.get(), name)) return chip;
  }
  errno = ENOENT;
  return nullptr;
}

unsigned offset_of(gpiod_chip* chip, const std::string& line) {
  if (is_offset(line)) return static_cast<unsigned>(std::stoul(line));
  const int offset = gpiod_chip_get_line_offset_from_name(chip, line.c_str());
  if (offset < 0)
    throw std::runtime_error("the GPIO chip has no line '" + line +
                             "'; list the lines with gpioinfo");
  return static_cast<unsigned>(offset);
}

void require(bool succeeded) {
  if (!succeeded) throw std::runtime_error("the GPIO lines cannot be set up: " + reason());
}

}  // namespace

struct LineEvents::Lines {
  struct RequestedLine {
    LineRole role;
    unsigned offset;
  };

  Chip chip;
  LineConfig config{gpiod_line_config_new()};
  std::vector<RequestedLine> requested;
  Request request;
  Buffer buffer{gpiod_edge_event_buffer_new(queue_events)};

  void add(LineRole role, const std::string& name, gpiod_line_edge edge, bool to_ground) {
    const unsigned offset = offset_of(chip.get(), name);
    for (const RequestedLine& other : requested)
      if (other.offset == offset)
        throw std::runtime_error("GPIO line '" + name + "' is given twice; give each line once");
    const Settings settings(gpiod_line_settings_new());
    require(config != nullptr && settings != nullptr);
    require(gpiod_line_settings_set_direction(settings.get(), GPIOD_LINE_DIRECTION_INPUT) == 0);
    require(gpiod_line_settings_set_edge_detection(settings.get(), edge) == 0);
    if (to_ground) {
      gpiod_line_settings_set_active_low(settings.get(), true);
      require(gpiod_line_settings_set_bias(settings.get(), GPIOD_LINE_BIAS_PULL_UP) == 0);
    }
    require(gpiod_line_config_add_line_settings(config.get(), &offset, 1, settings.get()) == 0);
    requested.push_back({role, offset});
  }

  void send_request() {
    const RequestConfig options(gpiod_request_config_new());
    require(options != nullptr && buffer != nullptr);
    gpiod_request_config_set_consumer(options.get(), "discmc-gpio");
    gpiod_request_config_set_event_buffer_size(options.get(), queue_events);
    request.reset(gpiod_chip_request_lines(chip.get(), options.get(), config.get()));
    if (request == nullptr)
      throw std::runtime_error("the GPIO lines cannot be requested: " + reason() +
                               "; see their users with gpioinfo");
  }

  LineEvent read(gpiod_edge_event* edge) const {
    const unsigned offset = gpiod_edge_event_get_line_offset(edge);
    const auto line =
        std::find_if(requested.begin(), requested.end(),
                     [&](const RequestedLine& each) { return each.offset == offset; });
    LineEvent event{};
    event.role = line->role;
    event.is_active = line->role == LineRole::sync ||
                      gpiod_edge_event_get_event_type(edge) == GPIOD_EDGE_EVENT_RISING_EDGE;
    event.time_ns = gpiod_edge_event_get_timestamp_ns(edge);
    event.number = static_cast<std::uint32_t>(gpiod_edge_event_get_line_seqno(edge));
    return event;
  }
};

LineEvents::LineEvents(const Wiring& wiring) : lines_(std::make_unique<Lines>()) {
  lines_->chip = open_chip(wiring.chip);
  if (lines_->chip == nullptr)
    throw std::runtime_error("no GPIO chip '" + wiring.chip + "': " + reason() +
                             "; list the chips with gpiodetect");
  if (!wiring.button.empty())
    lines_->add(LineRole::button, wiring.button, GPIOD_LINE_EDGE_BOTH, wiring.contacts_to_ground);
  if (!wiring.end_stop.empty())
    lines_->add(LineRole::end_stop, wiring.end_stop, GPIOD_LINE_EDGE_RISING,
                wiring.contacts_to_ground);
  lines_->add(LineRole::sync, wiring.sync,
              wiring.sync_is_falling ? GPIOD_LINE_EDGE_FALLING : GPIOD_LINE_EDGE_RISING, false);
  lines_->send_request();
}

LineEvents::~LineEvents() = default;

std::vector<LineEvent> LineEvents::wait(std::chrono::milliseconds timeout) {
  const std::chrono::nanoseconds limit = timeout;
  const int found = gpiod_line_request_wait_edge_events(lines_->request.get(), limit.count());
  std::vector<LineEvent> events;
  if (found == 0 || (found < 0 && errno == EINTR)) return events;
  const int count = found < 0 ? -1
                              : gpiod_line_request_read_edge_events(
                                    lines_->request.get(), lines_->buffer.get(), queue_events);
  if (count < 0) throw DeviceGone("the GPIO chip is gone: " + reason());
  for (int i = 0; i < count; ++i)
    events.push_back(lines_->read(
        gpiod_edge_event_buffer_get_event(lines_->buffer.get(), static_cast<unsigned long>(i))));
  return events;
}

}  // namespace discmc::device

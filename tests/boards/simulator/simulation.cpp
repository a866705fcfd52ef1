#include "simulation.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace discmc::simulator {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds silence_limit{30000};
constexpr milliseconds longest_poll{100};
constexpr milliseconds show_interval{100};

bool is_terminal() {
  static const bool is = isatty(STDERR_FILENO) == 1;
  return is;
}

}  // namespace

Simulation::Simulation(const Rows& rows, const Options& options, const Lines& lines)
    : rows_(rows),
      options_(options),
      lines_(lines),
      scanner_(rows, options.scanner),
      listener_(options.listener) {}

void Simulation::run() {
  const auto begin = Clock::now();
  last_sign_ = begin;
  while (!received_.stream().report().has_trailer) {
    if (is_interrupted != 0) throw std::runtime_error("interrupted");
    const auto now = Clock::now();
    check_silence(now);
    receive(now);
    listen(now);
    speak(now);
    show(now);
    wait(now);
  }
  duration_ = Clock::now() - begin;
  if (is_terminal()) std::fputs("\r\033[K", stderr);
}

// Waits until bytes can be read or sent.
void Simulation::wait(Clock::time_point now) {
  const auto reads_again = listener_.next() > now ? listener_.next() : Clock::time_point::max();
  const auto until = std::min({scanner_.due(), reads_again, now + longest_poll});
  const bool reads_stream = listener_.allowed(1, now) > 0;
  const auto rows_events = static_cast<short>(lines_.rows.is_busy() ? POLLIN | POLLOUT : POLLIN);
  pollfd lines[] = {
      {lines_.rows.descriptor(), rows_events, 0},
      {reads_stream ? lines_.stream.descriptor() : -1, POLLIN, 0},
      {lines_.monitor != nullptr ? lines_.monitor->descriptor() : -1, POLLIN, 0},
  };
  const auto time = std::max(until - now, Clock::duration{0});
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(time);
  const timespec limit{
      seconds.count(),
      std::chrono::duration_cast<std::chrono::nanoseconds>(time - seconds).count()};
  ppoll(lines, std::size(lines), &limit, nullptr);
}

// Reads the device's answers to rows, and discards the output of the monitor.
void Simulation::receive(Clock::time_point now) {
  std::uint8_t bytes[256];
  if (lines_.monitor != nullptr) lines_.monitor->read(bytes, sizeof bytes);
  const std::size_t count = lines_.rows.read(bytes, sizeof bytes);
  if (count > 0) last_sign_ = now;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t restarts = scanner_.restarts();
    scanner_.receive(bytes[i], now);
    if (scanner_.restarts() == restarts) continue;
    lines_.rows.discard();
    note("the device runs from its beginning, and so does the scan");
  }
}

void Simulation::listen(Clock::time_point now) {
  listener_.follow(scanner_, now);
  std::uint8_t bytes[4096];
  const std::size_t allowed = listener_.allowed(sizeof bytes, now);
  if (allowed == 0) return;
  const std::size_t count = lines_.stream.read(bytes, allowed);
  if (count > 0) {
    last_sign_ = now;
    listener_.has_read(count, now);
    received_.push(bytes, count);
    check_header();
  }
  if (!lines_.stream.is_open() && !received_.stream().report().has_trailer)
    throw std::runtime_error("the device has hung up when the scan was at row " +
                             std::to_string(scanner_.row()) + ": see what it printed");
}

void Simulation::check_header() {
  if (!received_.stream().report().has_header) return;
  const StreamHeader& header = received_.stream().header();
  const auto& dims = rows_.info().dims;
  if (header.width != dims[0] || header.height != dims[1])
    throw std::runtime_error("the device scans slices of " + std::to_string(header.width) + "x" +
                             std::to_string(header.height) + ", and the volume has " +
                             std::to_string(dims[0]) + "x" + std::to_string(dims[1]) +
                             ": give another volume, or change the firmware's scan.hpp");
}

void Simulation::speak(Clock::time_point now) {
  if (scanner_.is_scanning() && scanner_.row() == options_.reset_at && !was_reset_) reset();
  lines_.rows.flush();
  while (!lines_.rows.is_busy()) {
    const bool had_sent_all = scanner_.has_sent_all();
    const std::vector<std::uint8_t> frame = scanner_.next(now);
    if (frame.empty() && scanner_.due() > now) return;
    lines_.rows.send(frame.data(), frame.size());
    if (!had_sent_all && scanner_.has_sent_all())
      early_regions_ = received_.stream().report().regions;
    if (scanner_.row() == options_.reset_at) return;
  }
}

void Simulation::reset() {
  const std::string command = "system_reset\n";
  lines_.monitor->send(reinterpret_cast<const std::uint8_t*>(command.data()), command.size());
  was_reset_ = true;
  note("row " + std::to_string(scanner_.row()) + ": reset");
}

// During a pause or a stall, silence is expected.
void Simulation::check_silence(Clock::time_point now) const {
  const bool is_pausing =
      scanner_.is_scanning() && scanner_.due() > now && scanner_.due() != Clock::time_point::max();
  const auto since = std::max(last_sign_, std::min(listener_.next(), now));
  if (is_pausing || now - since < silence_limit) return;
  throw std::runtime_error(
      "the device has been silent for " +
      std::to_string(std::chrono::duration_cast<std::chrono::seconds>(silence_limit).count()) +
      " s " +
      (scanner_.is_scanning() ? "when the scan was at row " + std::to_string(scanner_.row()) + ": "
       : scanner_.has_sent_all() ? std::string("after the last row: ")
                                 : std::string("and does not answer the start: ")) +
      "does it run, and are the lines the right ones?");
}

void Simulation::show(Clock::time_point now) {
  if (!is_terminal() || now < next_show_) return;
  next_show_ = now + show_interval;
  const ReceivedStream& stream = received_.stream();
  std::fprintf(stderr, "\r\033[Krow %u/%u  layers %u/%u  regions %llu  stream %zu B",
               scanner_.row(), scanner_.row_count(), stream.final_slices(), rows_.info().dims[2],
               static_cast<unsigned long long>(stream.report().regions), stream.bytes().size());
  std::fflush(stderr);
}

void Simulation::note(const std::string& text) const {
  std::fprintf(stderr, "%s%s\n", is_terminal() ? "\r\033[K" : "", text.c_str());
}

}  // namespace discmc::simulator

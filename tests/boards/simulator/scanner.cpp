#include "scanner.hpp"

#include <algorithm>
#include <rows/row_frame.hpp>
#include <stdexcept>
#include <string>

namespace discmc::simulator {
namespace {

using row_frame::Answer;
using row_frame::Kind;
using Bytes = std::vector<std::uint8_t>;

constexpr int halves = 2;
constexpr std::chrono::milliseconds repeat_interval{250};

Bytes frame(Kind kind, std::uint32_t number, const std::uint8_t* samples = nullptr,
            std::size_t count = 0) {
  Bytes bytes(row_frame::max_bytes);
  bytes.resize(row_frame::write(bytes.data(), kind, number, samples, count));
  return bytes;
}

// One wrong byte. It is not zero, because a zero would divide the frame.
void damage(Bytes& bytes) {
  std::uint8_t& byte = bytes[bytes.size() / 2];
  byte = byte == 0x55 ? 0xAA : static_cast<std::uint8_t>(byte ^ 0x55);
}

}  // namespace

Scanner::Scanner(const Rows& rows, const ScannerBehaviour& behaviour)
    : rows_(rows), behaviour_(behaviour), end_(std::min(rows.count(), behaviour.broken_off_at)) {}

void Scanner::receive(std::uint8_t answer, Clock::time_point now) {
  switch (static_cast<Answer>(answer)) {
    case Answer::restarted:
      if (stage_ != Stage::starting) ++restarts_;
      begin(now);
      break;
    case Answer::ready:
      if (stage_ != Stage::starting) break;  // the answer to a repeated start
      stage_ = Stage::scanning;
      credit_ = halves;
      due_ = now;
      schedule(now);
      break;
    case Answer::refused:
      throw std::runtime_error("the device refuses rows of " + std::to_string(rows_.bytes()) +
                               " bytes: they are not those of its scan.hpp, or it scans already "
                               "and needs a reset");
    case Answer::dropped:
      ++drops_;
      [[fallthrough]];
    case Answer::taken:
      credit_ = std::min(credit_ + 1, halves);
      break;
  }
}

void Scanner::begin(Clock::time_point now) {
  stage_ = Stage::starting;
  row_ = 0;
  credit_ = 0;
  due_ = now;
}

std::vector<std::uint8_t> Scanner::next(Clock::time_point now) {
  if (now < due_) return {};
  if (stage_ == Stage::scanning && row_ < end_) return next_row(now);
  if (stage_ == Stage::scanning) stage_ = Stage::ending;
  due_ = now + repeat_interval;
  if (stage_ == Stage::starting)
    return frame(Kind::start, static_cast<std::uint32_t>(rows_.bytes()));
  return frame(end_ < rows_.count() ? Kind::broken_off : Kind::end, end_);
}

std::vector<std::uint8_t> Scanner::next_row(Clock::time_point now) {
  Bytes bytes;
  if (waits_for_device()) return {};
  if (behaviour_.dropped.count(row_) == 0) {
    bytes = frame(Kind::row, row_, rows_.row(row_), rows_.bytes());
    if (behaviour_.damaged.count(row_) > 0) damage(bytes);
    credit_ = std::max(credit_ - 1, 0);
  }
  longest_wait_ = std::max(longest_wait_, now - due_);
  ++row_;
  schedule(now);
  return bytes;
}

// Sets the time of the next row; a row is sent now.
void Scanner::schedule(Clock::time_point now) {
  const auto most = behaviour_.jitter.count();
  const std::chrono::microseconds deviation(
      std::uniform_int_distribution<std::int64_t>(-most, most)(chance_));
  // A scanner that waits for the device continues from now; otherwise it keeps its schedule.
  const auto from = behaviour_.waits_for_credit ? now : due_;
  const auto pause = behaviour_.pauses.find(row_);
  due_ = from + std::max(behaviour_.pace + deviation, std::chrono::microseconds{0});
  if (pause != behaviour_.pauses.end()) due_ += pause->second;
}

bool Scanner::waits_for_device() const {
  const bool has_row =
      stage_ == Stage::scanning && row_ < end_ && behaviour_.dropped.count(row_) == 0;
  return has_row && behaviour_.waits_for_credit && credit_ == 0;
}

Clock::time_point Scanner::due() const {
  return waits_for_device() ? Clock::time_point::max() : due_;
}

}  // namespace discmc::simulator

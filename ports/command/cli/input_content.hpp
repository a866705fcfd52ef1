// Detects the kind of an input from its first bytes, if the name does not decide.
#pragma once

#include <optional>
#include <streambuf>
#include <string>

namespace discmc::command {

/// Returns the first bytes of std::cin again while this object exists. Limit: one at a time.
class ReplayedInput final : public std::streambuf {
 public:
  /// head: all bytes read so far.
  explicit ReplayedInput(std::string head);
  ReplayedInput(const ReplayedInput&) = delete;
  ReplayedInput& operator=(const ReplayedInput&) = delete;
  ~ReplayedInput() override;

 private:
  int_type underflow() override;

  std::string bytes_;
  std::streambuf* rest_;
};

/// Whether a file, or standard input ("-"), begins like a volume. An input that cannot be opened
/// may be a pattern of names. It counts as a volume, whose reader reports the fault. A pipe does
/// not count as a volume, because its first bytes cannot be returned. replayed: returns the first
/// bytes of standard input again.
bool begins_like_volume(const std::string& input, std::optional<ReplayedInput>& replayed);

}  // namespace discmc::command

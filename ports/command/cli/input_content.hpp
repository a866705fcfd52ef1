// The kind of an input by its first bytes, if its name does not decide.
#pragma once

#include <optional>
#include <streambuf>
#include <string>

namespace discmc::command {

/// Gives std::cin its first bytes again, as long as this lives. Limit: one at a time.
class ReplayedInput final : public std::streambuf {
 public:
  /// head: all that was read so far.
  explicit ReplayedInput(std::string head);
  ReplayedInput(const ReplayedInput&) = delete;
  ReplayedInput& operator=(const ReplayedInput&) = delete;
  ~ReplayedInput() override;

 private:
  int_type underflow() override;

  std::string bytes_;
  std::streambuf* rest_;
};

/// Whether a file, or standard input by the name "-", begins like a volume. What cannot be opened
/// may be a pattern of names, and counts as a volume: its reader reports the fault. A pipe does
/// not, as its first bytes cannot be returned. replayed: returns those of standard input again.
bool begins_like_volume(const std::string& input, std::optional<ReplayedInput>& replayed);

}  // namespace discmc::command

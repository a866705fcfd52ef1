// Standard input, whose first bytes were looked at.
#ifndef DISCMC_COMMAND_CLI_REPLAYED_INPUT_HPP
#define DISCMC_COMMAND_CLI_REPLAYED_INPUT_HPP

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

}  // namespace discmc::command

#endif

// Numbers for people.
#ifndef DISCMC_COMMAND_TEXT_GROUPED_NUMBER_HPP
#define DISCMC_COMMAND_TEXT_GROUPED_NUMBER_HPP

#include <cstddef>
#include <cstdint>
#include <string>

namespace discmc::command {

/// 1234567 as 1,234,567.
inline std::string grouped(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (auto i = static_cast<std::ptrdiff_t>(digits.size()) - 3; i > 0; i -= 3)
    digits.insert(static_cast<std::size_t>(i), ",");
  return digits;
}

}  // namespace discmc::command

#endif

// Whole numbers that a text is, from its first character to its last. Apart from the others, as the
// page's module has no decimal ones.
#ifndef DISCMC_COMMAND_TEXT_WHOLE_NUMBER_HPP
#define DISCMC_COMMAND_TEXT_WHOLE_NUMBER_HPP

#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

namespace discmc::command {

/// Nothing where the text is no whole number, or one that the type does not hold.
template <class Whole>
std::optional<Whole> whole_number(std::string_view text, int base = 10) {
  Whole value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return is_number ? std::optional<Whole>(value) : std::nullopt;
}

}  // namespace discmc::command

#endif

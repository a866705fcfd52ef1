#include "header_text.hpp"

#include <algorithm>
#include <system_error>

#include "text/control_character.hpp"
#include "text/number_text.hpp"
#include "volume_error.hpp"

namespace discmc::command {

std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text) {
  const auto value = whole_number<std::int64_t>(text);
  if (!value)
    fail(file, std::string(field) + " is " + shown(text) + ", which is not a whole number in range",
         "correct the header");
  return *value;
}

double real(const std::filesystem::path& file, std::string_view field, std::string_view text) {
  const auto value = decimal_number(text);
  if (!value)
    fail(file, std::string(field) + " is " + shown(text) + ", which is not a number",
         "correct the header");
  return *value;
}

std::filesystem::path beside(const std::filesystem::path& header, std::string_view name) {
  // A zero byte would end the name early, and every message that shows it.
  if (std::any_of(name.begin(), name.end(), is_control))
    fail(header, "the data file " + shown(name) + " has control characters in its name",
         "correct the header");
  std::filesystem::path file = header.parent_path() / std::string(name);
  // Windows separates folders by another character.
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) return file;
  std::string turned(name);
  std::replace(turned.begin(), turned.end(), '\\', '/');
  return header.parent_path() / turned;
}

}  // namespace discmc::command

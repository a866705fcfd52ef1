#include "header_fields.hpp"

#include <algorithm>
#include <system_error>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

// Converts the path separators of Windows.
std::filesystem::path of_windows(std::string_view name) {
  std::string turned(name);
  std::replace(turned.begin(), turned.end(), '\\', '/');
  return turned;
}

}  // namespace

void HeaderFields::add(const std::string& name, std::string_view text) {
  if (!fields_.emplace(name, text).second)
    fail(file_, "the header field " + shown(name) + " is given twice", "delete one of the lines");
}

void HeaderFields::replace(std::string_view name, std::string text) {
  fields_.find(name)->second = std::move(text);
}

std::string_view HeaderFields::text(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names)
    if (const auto found = fields_.find(name); found != fields_.end()) return found->second;
  return {};
}

std::string_view HeaderFields::needed(std::string_view name) const {
  const std::string_view found = text(name);
  if (found.empty())
    fail(file_, "the header field " + shown(name) + " is missing", "add it to the header");
  return found;
}

std::vector<std::int64_t> HeaderFields::needed_integers(std::string_view name) const {
  std::vector<std::int64_t> numbers;
  for (const auto word : words(needed(name)))
    numbers.push_back(command::integer(file_, name, word));
  return numbers;
}

std::int64_t HeaderFields::integer(std::string_view name, std::int64_t otherwise) const {
  const std::string_view found = text(name);
  return found.empty() ? otherwise : command::integer(file_, name, found);
}

std::vector<double> HeaderFields::reals(std::initializer_list<std::string_view> names) const {
  return command::reals(file_, *names.begin(), text(names));
}

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

std::vector<double> reals(const std::filesystem::path& file, std::string_view field,
                          std::string_view text) {
  std::vector<double> numbers;
  for (const auto word : words(text)) numbers.push_back(real(file, field, word));
  return numbers;
}

bool leads_out(std::string_view name) {
  const std::filesystem::path path = of_windows(name);
  return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

std::filesystem::path beside(const std::filesystem::path& header, std::string_view name) {
  // A control character may end the name early, and every message with the name.
  if (std::any_of(name.begin(), name.end(), is_control))
    fail(header, "the data file " + shown(name) + " has control characters in its name",
         "correct the header");
  if (leads_out(name))
    fail(header, "it names " + shown(name) + ", which lies outside of its folder",
         "put that or a link to it beside this file, and correct the name");
  const std::filesystem::path file = header.parent_path() / std::string(name);
  std::error_code ignored;
  return std::filesystem::exists(file, ignored) ? file : header.parent_path() / of_windows(name);
}

}  // namespace discmc::command

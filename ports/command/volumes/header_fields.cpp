#include "header_fields.hpp"

#include "header_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {

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
  std::vector<double> numbers;
  for (const auto word : words(text(names))) numbers.push_back(real(file_, *names.begin(), word));
  return numbers;
}

}  // namespace discmc::command

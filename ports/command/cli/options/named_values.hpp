// Options whose value is one of several names.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace discmc::command {

template <typename T>
using NamedValues = std::vector<std::pair<std::string, T>>;

/// Adds an option with one of the names as its value. take: called with the named value.
template <typename T>
CLI::Option* add_named_option(CLI::App& app, const std::string& option,
                              const std::function<void(T)>& take, const NamedValues<T>& values,
                              const std::string& description) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const auto& named : values) names.push_back(named.first);
  return app
      .add_option_function<std::string>(
          option,
          [take, values](const std::string& name) {
            take(std::find_if(values.begin(), values.end(), [&name](const auto& named) {
                   return named.first == name;
                 })->second);
          },
          description)
      ->check(CLI::IsMember(names))
      ->option_text(CLI::detail::join(names, "|"));
}

/// Likewise stores the value: in an optional<T>, or in a T that holds the default. `value` must
/// outlive the parsing.
template <typename Value, typename T>
CLI::Option* add_named_option(CLI::App& app, const std::string& option, Value& value,
                              const NamedValues<T>& values, const std::string& description) {
  CLI::Option* added = add_named_option<T>(
      app, option, [&value](T named) { value = named; }, values, description);
  for (const auto& named : values)
    if (value == named.second) added->default_str(named.first);
  return added;
}

}  // namespace discmc::command

// Checks of option values for several commands. Each check returns the text of an error.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "files/file_pattern.hpp"
#include "text/number_text.hpp"
#include "text/value_text.hpp"

namespace discmc::command {

/// Throws CLI::ValidationError.
[[noreturn]] inline void refuse(const std::string& option, const std::string& reason) {
  throw CLI::ValidationError(option, reason);
}

/// Accepts a finite number that fulfils the condition. wanted: the expected value, for the message.
template <class Condition>
CLI::Validator accepted(Condition holds, const std::string& wanted) {
  return CLI::Validator(
      [holds, wanted](std::string& text) {
        const auto value = finite_number(text);
        return value && holds(*value) ? std::string()
                                      : "invalid value '" + text + "'; expected " + wanted;
      },
      "");
}

inline CLI::Validator whole_from(std::uint64_t min_value) {
  return CLI::Validator(
      [min_value](std::string& text) {
        const auto value = whole_number<std::uint64_t>(text);
        return value && *value >= min_value
                   ? std::string()
                   : "invalid value '" + text + "'; expected a whole number from " +
                         std::to_string(min_value);
      },
      "");
}

inline CLI::Validator finite() {
  return accepted([](double) { return true; }, "a finite number");
}

/// Accepts a spacing that fits a stream: a 32-bit count of nanometres.
inline CLI::Validator usable_spacing() {
  return CLI::Validator(
      [](std::string& text) {
        const double size = std::fabs(std::strtod(text.c_str(), nullptr));
        return size >= 1e-6 && size <= 2147
                   ? std::string()
                   : "invalid spacing '" + text + "'; expected 1e-6 to 2147 mm";
      },
      "");
}

inline CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) {
        return text.find('-') == std::string::npos
                   ? std::string()
                   : "invalid value '" + text + "'; expected 0 or more";
      },
      "");
}

/// Accepts a file whose name ends in one of the extensions (with their dots), or "-" for standard
/// output. what: the fault, for the message.
inline CLI::Validator named_with(const std::vector<std::string>& extensions,
                                 const std::string& what) {
  return CLI::Validator(
      [extensions, what](std::string& text) {
        const std::string own = std::filesystem::path(text).extension().string();
        const bool is_right =
            text == "-" || std::find(extensions.begin(), extensions.end(), own) != extensions.end();
        return is_right ? std::string()
                        : text + ": " + what + "; give a name that ends in " + extensions[0];
      },
      "");
}

/// Refuses {name} for commands that write one surface.
inline CLI::Validator without_braces() {
  return CLI::Validator(
      [](std::string& text) {
        const std::string found = FilePattern(text).first_placeholder();
        return found.empty()
                   ? std::string()
                   : text + ": " + found +
                         " is no placeholder here, as the command writes one file; leave it out";
      },
      "");
}

/// Converts bytes like CLI::AsSizeValue, with units of memory only.
inline CLI::Validator count_of_bytes() {
  return CLI::Validator(
      [](std::string& text) {
        const std::vector<std::string> units = {"",   "b",   "k", "kb", "kib", "m",
                                                "mb", "mib", "g", "gb", "gib"};
        const std::size_t digits = std::min(text.size(), text.find_first_not_of("0123456789"));
        const std::string unit = CLI::detail::to_lower(text.substr(digits));
        const bool is_right =
            digits > 0 && std::find(units.begin(), units.end(), unit) != units.end();
        return is_right ? std::string()
                        : "invalid number of bytes '" + text +
                              "'; expected a whole number with K, M or G, as in 24K";
      },
      "");
}

/// Adds --memory: bytes, with K, M or G for powers of 1024.
inline CLI::Option* add_memory_option(CLI::App& app, std::uint64_t& memory,
                                      const std::string& description) {
  constexpr std::uint64_t max_number = std::uint64_t{1} << 60;  // more than any computer has
  return app.add_option("--memory", memory, description)
      ->transform(CLI::AsSizeValue(false))
      ->transform(count_of_bytes())  // runs before the previous check
      ->check(CLI::Range(std::uint64_t{1}, max_number))
      ->option_text("BYTES");
}

}  // namespace discmc::command

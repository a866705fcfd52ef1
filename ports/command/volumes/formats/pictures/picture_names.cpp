#include "picture_names.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "text/number_text.hpp"
#include "text/words.hpp"

namespace discmc::command {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Takes a number off the front, without its leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

// A name as the texts between its numbers, and these.
struct NumberedName {
  std::vector<std::string_view> texts;
  std::vector<std::string_view> numbers;
};

NumberedName numbered(std::string_view name) {
  NumberedName result;
  while (!name.empty()) {
    const auto end = std::find_if(name.begin(), name.end(), is_digit);
    const auto length = static_cast<std::size_t>(end - name.begin());
    result.texts.push_back(name.substr(0, length));
    name.remove_prefix(length);
    result.numbers.push_back(take_number(name));
  }
  return result;
}

// The values of the one number in which the names differ; empty where they differ in more.
std::vector<std::uint64_t> varying_numbers(const std::vector<std::filesystem::path>& files) {
  const std::string first_name = files.front().filename().string();
  const NumberedName first = numbered(first_name);
  const std::string last_name = files.back().filename().string();
  const NumberedName last = numbered(last_name);
  if (last.numbers.size() != first.numbers.size()) return {};
  const auto differing =
      std::mismatch(first.numbers.begin(), first.numbers.end(), last.numbers.begin()).first;
  if (differing == first.numbers.end()) return {};
  const auto varying = static_cast<std::size_t>(differing - first.numbers.begin());
  std::vector<std::uint64_t> values;
  for (const auto& file : files) {
    const std::string name = file.filename().string();
    NumberedName parts = numbered(name);
    if (parts.texts != first.texts || parts.numbers.size() != first.numbers.size()) return {};
    const std::string_view number = std::exchange(parts.numbers[varying], first.numbers[varying]);
    const auto value = number.empty() ? 0 : whole_number<std::uint64_t>(number);
    if (parts.numbers != first.numbers || !value) return {};
    values.push_back(*value);
  }
  return values;
}

bool is_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view left = take_number(a);
      const std::string_view right = take_number(b);
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    } else {
      if (a[0] != b[0]) return a[0] < b[0];
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace

bool is_png_name(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".png";
}

bool is_picture_name(const std::filesystem::path& file) {
  const std::string extension = lower(file.extension().string());
  return extension == ".png" || extension == ".tif" || extension == ".tiff";
}

std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_picture_name(entry.path())) files.push_back(entry.path());
  return files;
}

void sort_naturally(std::vector<std::filesystem::path>& files) {
  // Equal but for zeros: by the plain order, for the same one everywhere.
  std::sort(files.begin(), files.end());
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return is_before(a.native(), b.native()); });
}

std::vector<Gap> gaps_of_names(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 3) return {};
  std::vector<std::uint64_t> steps = varying_numbers(files);
  std::adjacent_difference(steps.begin(), steps.end(), steps.begin());
  if (!steps.empty()) steps.erase(steps.begin());
  if (steps.empty()) return {};
  std::vector<std::uint64_t> sorted = steps;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const std::uint64_t step = *middle;
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (step == 0 || steps[i] == 0 || steps[i] % step != 0) return {};
    if (steps[i] > step)
      gaps.push_back(
          {i, std::min(steps[i] / step - 1, max_missing),
           "between " + files[i].filename().string() + " and " + files[i + 1].filename().string()});
  }
  return gaps;
}

}  // namespace discmc::command

#include "picture_names.hpp"

#include <algorithm>
#include <numeric>
#include <system_error>
#include <utility>

#include "text/number_text.hpp"
#include "text/words.hpp"

namespace discmc::command {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Removes a number from the front, and returns it without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

// Returns the values of the only number in which the names differ; empty if they differ in more.
std::vector<std::uint64_t> varying_numbers(const std::vector<std::filesystem::path>& files) {
  const NumberedName first(files.front()), last(files.back());
  if (last.numbers.size() != first.numbers.size()) return {};
  const auto differing =
      std::mismatch(first.numbers.begin(), first.numbers.end(), last.numbers.begin()).first;
  if (differing == first.numbers.end()) return {};
  const auto varying = static_cast<std::size_t>(differing - first.numbers.begin());
  std::vector<std::uint64_t> values;
  for (const auto& file : files) {
    NumberedName name(file);
    if (name.texts != first.texts) return {};
    const std::string number = std::exchange(name.numbers[varying], first.numbers[varying]);
    const auto value = number.empty() ? 0 : whole_number<std::uint64_t>(number);
    if (name.numbers != first.numbers || !value) return {};
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

std::string_view name(PictureKind kind) {
  constexpr std::string_view names[] = {"other", "PNG", "TIFF", "JPEG", "BMP"};
  return names[static_cast<std::size_t>(kind)];
}

PictureKind kind_of_name(const std::filesystem::path& file) {
  constexpr std::pair<std::string_view, PictureKind> extensions[] = {
      {".png", PictureKind::png},  {".tif", PictureKind::tiff},  {".tiff", PictureKind::tiff},
      {".jpg", PictureKind::jpeg}, {".jpeg", PictureKind::jpeg}, {".bmp", PictureKind::bmp}};
  const std::string extension = lower(file.extension().string());
  for (const auto& [text, kind] : extensions)
    if (extension == text) return kind;
  return PictureKind::none;
}

bool is_picture_name(const std::filesystem::path& file) {
  return kind_of_name(file) != PictureKind::none;
}

PictureKind kind_of_head(std::string_view head) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, PictureKind> beginnings[] = {
      {"\x89PNG"sv, PictureKind::png}, {"II*\0"sv, PictureKind::tiff},
      {"MM\0*"sv, PictureKind::tiff},  {"II+\0"sv, PictureKind::tiff},
      {"MM\0+"sv, PictureKind::tiff},  {"\xff\xd8\xff"sv, PictureKind::jpeg},
      {"BM"sv, PictureKind::bmp}};
  for (const auto& [bytes, kind] : beginnings)
    if (head.substr(0, bytes.size()) == bytes) return kind;
  return PictureKind::none;
}

bool is_system_name(const std::filesystem::path& file) {
  const std::string called = lower(file.filename().string());
  return called.rfind('.', 0) == 0 || called == "thumbs.db" || called == "desktop.ini";
}

std::vector<std::filesystem::path> picture_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (is_picture_name(entry.path()) && !is_system_name(entry.path()))
      files.push_back(entry.path());
  return files;
}

void sort_naturally(std::vector<std::filesystem::path>& files) {
  // Names that differ only in zeros keep plain order, so that the result is deterministic.
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

NumberedName::NumberedName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (auto at = name.begin();;) {
    const auto first = std::find_if(at, name.end(), is_digit);
    texts.emplace_back(at, first);
    if (first == name.end()) return;
    at = std::find_if_not(first, name.end(), is_digit);
    digits.emplace_back(first, at);
    numbers.emplace_back(std::find_if(first, at, [](char c) { return c != '0'; }), at);
  }
}

}  // namespace discmc::command

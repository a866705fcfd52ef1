#include "picture_names.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
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
std::string_view next_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view number = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(number.size());
  number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
  return number;
}

// Returns the only number in which the names differ, of each name; empty if they differ in more.
std::vector<std::string> varying_numbers(std::vector<NumberedName> names) {
  const NumberedName first = names.front(), last = names.back();
  if (last.numbers.size() != first.numbers.size()) return {};
  const auto differing =
      std::mismatch(first.numbers.begin(), first.numbers.end(), last.numbers.begin()).first;
  if (differing == first.numbers.end()) return {};
  const auto varying = static_cast<std::size_t>(differing - first.numbers.begin());
  std::vector<std::string> found;
  for (NumberedName& name : names) {
    if (name.kind() != first.kind()) return {};
    found.push_back(std::exchange(name.numbers[varying], first.numbers[varying]));
    if (name.numbers != first.numbers) return {};
  }
  return found;
}

bool is_point(const std::string& text) {
  return text == "." || text == ",";
}

// Whether a hyphen is a sign: z=-1.png, z_-0.5.png, but not z-1.png, z_-1.png.
bool is_sign(const std::string& before, const std::string& after) {
  const char previous = before.size() < 2 ? 'a' : before[before.size() - 2];
  return previous == '=' ||
         (is_point(after) && std::isalnum(static_cast<unsigned char>(previous)) == 0);
}

// Joins the digits and signs of decimals. all_signs: whether each hyphen is a sign.
NumberedName with_decimals(const NumberedName& name, bool all_signs) {
  NumberedName joined = name;
  joined.texts = {name.texts[0]};
  joined.numbers.clear();
  for (std::size_t i = 0; i < name.digits.size(); ++i) {
    std::string& before = joined.texts.back();
    const std::string& after = name.texts[i + 1];
    if (i > 0 && is_point(before)) {
      joined.numbers.back() += '.' + name.digits[i];
      before = after;
      continue;
    }
    std::string number = name.digits[i];
    const char last = before.empty() ? ' ' : before.back();
    if ((last == '-' || last == '+') && (all_signs || is_sign(before, after))) {
      if (last == '-') number.insert(0, 1, last);
      before.pop_back();
    }
    joined.numbers.push_back(number);
    joined.texts.push_back(after);
  }
  return joined;
}

std::string_view fraction_of(std::string_view number) {
  return number.substr(std::min(number.find('.'), number.size()));
}

// Whether numbers are decimals, and not pairs of numbers, such as 1.9 and 1.10.
bool are_decimals(const std::vector<std::string>& numbers) {
  std::set<std::string_view> fractions;
  std::set<std::size_t> sizes;
  bool has_final_zero = false, has_sign = false;
  for (const std::string& number : numbers) {
    const std::string_view fraction = fraction_of(number);
    fractions.insert(fraction);
    sizes.insert(fraction.size());
    has_final_zero = has_final_zero || (!fraction.empty() && fraction.back() == '0');
    has_sign = has_sign || number[0] == '-';
  }
  return (sizes.size() == 1 || !has_final_zero) && (fractions.size() > 1 || has_sign);
}

std::uint64_t median_of(std::vector<std::uint64_t> steps) {
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<std::uint64_t> steps_of(std::vector<std::uint64_t> values) {
  std::adjacent_difference(values.begin(), values.end(), values.begin());
  if (!values.empty()) values.erase(values.begin());
  return values;
}

// Whether values have one distance, which may be rounded, or multiples of it. Pairs of counters,
// such as 1.7, 1.8 and 2.0, have not. Size: at least two values.
bool are_even(std::vector<std::uint64_t> values, bool are_whole) {
  std::sort(values.begin(), values.end());
  const std::vector<std::uint64_t> steps = steps_of(values);
  const std::uint64_t step = median_of(steps);
  return step > 0 && std::all_of(steps.begin(), steps.end(), [&](std::uint64_t each) {
           const bool is_multiple = each > 0 && each % step == 0 && (step > 1 || are_whole);
           return each == step || is_multiple || (step > 2 && each + 1 >= step && each <= step + 1);
         });
}

// Returns decimals or signed numbers as counts of their last place: 0, 5, 10 for -0.5, 0.0, 0.5.
// Returns nothing if the numbers have another form or uneven distances.
std::vector<std::uint64_t> counts_of(const std::vector<std::string>& numbers) {
  if (numbers.size() < 2 || !are_decimals(numbers)) return {};
  double lowest = 0;
  std::size_t places = 0;
  for (const std::string& number : numbers) {
    lowest = std::min(lowest, decimal(number).value_or(0));
    places = std::max(places, fraction_of(number).size());
  }
  constexpr double max_exact = 1e15;
  const double scale = std::pow(10, places == 0 ? 0 : places - 1);
  std::vector<std::uint64_t> counts;
  for (const std::string& number : numbers) {
    const auto value = decimal(number);
    if (!value || (*value - lowest) * scale > max_exact) return {};
    counts.push_back(static_cast<std::uint64_t>(std::llround((*value - lowest) * scale)));
  }
  return are_even(counts, places == 0) ? counts : std::vector<std::uint64_t>();
}

// Returns the decimals or signed numbers of names as counts, or nothing if the names have none.
std::vector<std::uint64_t> decimals_of(const std::vector<std::filesystem::path>& files) {
  for (const bool all_signs : {false, true}) {
    std::vector<NumberedName> names;
    for (const auto& file : files) names.push_back(with_decimals(NumberedName(file), all_signs));
    const std::vector<std::string> numbers = varying_numbers(names);
    const bool are_hyphens =
        all_signs && std::all_of(numbers.begin(), numbers.end(),
                                 [](const std::string& number) { return number[0] == '-'; });
    const auto counts = are_hyphens ? std::vector<std::uint64_t>() : counts_of(numbers);
    if (!counts.empty()) return counts;
  }
  return {};
}

bool is_before(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view left = next_number(a);
      const std::string_view right = next_number(b);
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

bool sort_by_decimals(std::vector<std::filesystem::path>& files) {
  const std::vector<std::uint64_t> counts = decimals_of(files);
  std::map<std::uint64_t, std::filesystem::path> sorted;
  for (std::size_t i = 0; i < counts.size(); ++i) sorted[counts[i]] = files[i];
  std::transform(sorted.begin(), sorted.end(), files.begin(),
                 [](const auto& each) { return each.second; });
  return !counts.empty();
}

std::vector<Gap> gaps_of_names(const std::vector<std::filesystem::path>& files) {
  if (files.size() < 3) return {};
  std::vector<std::uint64_t> values = decimals_of(files);
  if (values.empty())
    for (const std::string& number : varying_numbers({files.begin(), files.end()})) {
      const auto value = number.empty() ? 0 : whole_number<std::uint64_t>(number);
      if (!value) return {};
      values.push_back(*value);
    }
  const std::vector<std::uint64_t> steps = steps_of(values);
  if (steps.empty()) return {};
  const std::uint64_t step = median_of(steps);
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

std::vector<std::string> NumberedName::kind() const {
  std::vector<std::string> kind = texts;
  kind.back() = lower(kind.back());
  return kind;
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

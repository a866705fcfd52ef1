#include "stack.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "picture_names.hpp"
#include "text/number_text.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

using Names = std::vector<NumberedName>;

std::string text_of(const NumberedName& name) {
  std::string text = name.texts[0];
  for (std::size_t i = 0; i < name.digits.size(); ++i) text += name.digits[i] + name.texts[i + 1];
  return text;
}

std::size_t values(const Names& names, std::size_t number) {
  std::set<std::string> different;
  for (const NumberedName& name : names) different.insert(name.numbers[number]);
  return different.size();
}

// ---- names of one kind, in natural order ----

using Numbers = std::set<std::size_t>;  // by position in the names

struct Count {
  Numbers counting;         // a different value in each file
  Numbers others;           // that vary otherwise
  std::size_t largest = 0;  // position with the most values
};

Count count(const Names& names) {
  Count count;
  std::size_t max_values = 0;
  for (std::size_t i = 0; i < names[0].numbers.size(); ++i) {
    const std::size_t different = values(names, i);
    if (different == names.size()) count.counting.insert(i);
    if (different > 1 && different < names.size()) count.others.insert(i);
    if (different < max_values) continue;
    count.largest = i;
    max_values = different;
  }
  return count;
}

// Compares the values of names at these positions.
class Earlier {
 public:
  explicit Earlier(const Numbers& places) : places_(places) {}

  bool operator()(const NumberedName& a, const NumberedName& b) const {
    for (const std::size_t place : places_) {
      const std::string &left = a.numbers[place], &right = b.numbers[place];
      if (left.size() != right.size()) return left.size() < right.size();
      if (left != right) return left < right;
    }
    return false;
  }

 private:
  const Numbers& places_;
};

bool has_even_steps(const Names& names, std::size_t place) {
  std::vector<std::uint64_t> steps;
  for (const NumberedName& name : names) {
    const std::string& number = name.numbers[place];
    steps.push_back(number.empty() ? 0 : whole_number<std::uint64_t>(number).value_or(0));
  }
  std::adjacent_difference(steps.begin(), steps.end(), steps.begin());
  return std::all_of(steps.begin() + 1, steps.end(),
                     [&steps](std::uint64_t step) { return step == steps[1]; });
}

// Whether all counting numbers rise or fall with the names, or at least one does so in even steps.
// Others, such as dates, need not.
bool is_one_order(const Names& names, const Count& count) {
  const auto is_in_order = [&names](std::size_t place) {
    const Numbers places = {place};
    return std::is_sorted(names.begin(), names.end(), Earlier(places)) ||
           std::is_sorted(names.rbegin(), names.rend(), Earlier(places));
  };
  return std::all_of(count.counting.begin(), count.counting.end(), is_in_order) ||
         std::any_of(count.counting.begin(), count.counting.end(), [&](std::size_t place) {
           return is_in_order(place) && has_even_steps(names, place);
         });
}

// Returns the numbers that may vary within a stack.
Numbers numbers_of_stack(const Names& names, const Count& count) {
  if (count.counting.empty()) return {count.largest};
  Numbers varying = count.counting;
  if (std::is_sorted(names.begin(), names.end(), Earlier(count.others)))
    varying.insert(count.others.begin(), count.others.end());
  return varying;
}

// ---- patterns ----

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text)
    if (c == '*' || c == '?' || c == '[' || c == '\\')
      result += std::string("[") + c + ']';
    else
      result += c;
  return result;
}

// Returns the name with wildcards for the varying numbers.
std::string pattern(const NumberedName& name, const Numbers& varying, const std::string& wildcard) {
  std::string result = escaped(name.texts[0]);
  for (std::size_t i = 0; i < name.digits.size(); ++i)
    result += (varying.count(i) > 0 ? wildcard : name.digits[i]) + escaped(name.texts[i + 1]);
  return result;
}

// Returns patterns, the short forms first.
std::vector<std::string> patterns(const NumberedName& name, const Numbers& varying) {
  const std::string whole = pattern(name, varying, "*");
  const std::size_t first = whole.find('*'), last = whole.rfind('*');
  const std::string extension = escaped(std::filesystem::path(text_of(name)).extension().string());
  return {whole.substr(first), whole.substr(0, last + 1) + extension, whole,
          pattern(name, varying, "[0-9]*"), pattern(name, varying, "*[0-9]")};
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry :
       std::filesystem::directory_iterator(folder.empty() ? "." : folder, error))
    names.insert(entry.path().filename().string());
  return names;
}

// Returns a pattern that matches these files, and no others in their folder.
std::optional<std::string> pattern_of(const Names& names, const Numbers& varying,
                                      const std::filesystem::path& folder) {
  if (varying.empty()) return std::nullopt;
  std::set<std::string> wanted;
  for (const NumberedName& name : names) wanted.insert(text_of(name));
  const std::set<std::string> all = names_in(folder);
  for (const std::string& candidate : patterns(names[0], varying)) {
    std::set<std::string> matched;
    for (const std::string& name : all)
      if (fnmatch(candidate.c_str(), name.c_str(), FNM_PERIOD) == 0) matched.insert(name);
    if (matched == wanted)
      return escaped(folder.string()) + (folder.empty() ? "" : "/") + candidate;
  }
  return std::nullopt;
}

// Returns how to name the stack of the first file.
std::string remedy(const Names& names, const std::filesystem::path& folder) {
  const Numbers varying = numbers_of_stack(names, count(names));
  Names stack;
  for (const NumberedName& name : names) {
    NumberedName alike = name;
    for (const std::size_t place : varying) alike.numbers[place] = names[0].numbers[place];
    if (alike.numbers == names[0].numbers) stack.push_back(name);
  }
  const auto found = pattern_of(stack, varying, folder);
  const auto& texts = names[0].texts;
  const bool have_points = std::find(texts.begin() + 1, texts.end(), ".") != texts.end();
  return (found ? "give a pattern of one stack, such as '" + *found + "'"
                : "copy the pictures of one stack into a folder of their own") +
         (have_points ? "; if uneven decimals count them, rename them by whole numbers" : "");
}

// ---- refusals ----

[[noreturn]] void fail_kinds(const std::filesystem::path& source, const std::vector<Names>& kinds,
                             const std::filesystem::path& folder) {
  const Names& largest =
      *std::max_element(kinds.begin(), kinds.end(),
                        [](const Names& a, const Names& b) { return a.size() < b.size(); });
  const Names& other = &kinds[0] == &largest ? kinds[1] : kinds[0];
  fail(source,
       "the pictures have names of " + std::to_string(kinds.size()) + " kinds, such as " +
           shown(text_of(largest[0])) + " (" + std::to_string(largest.size()) + ") and " +
           shown(text_of(other[0])) + " (" + std::to_string(other.size()) + ')',
       remedy(largest, folder));
}

[[noreturn]] void fail_counts(const std::filesystem::path& source, const Names& names,
                              const std::filesystem::path& folder) {
  fail(source,
       "the names count in several numbers, such as " + shown(text_of(names[0])) + " and " +
           shown(text_of(names[1])) + ", and the names of one stack count in one number",
       remedy(names, folder));
}

}  // namespace

void require_one_stack(const std::filesystem::path& source,
                       const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return;
  const std::filesystem::path folder = files[0].parent_path();
  std::map<std::vector<std::string>, std::size_t> numbers;
  std::vector<Names> kinds;
  for (const auto& file : files) {
    const NumberedName name(file);
    const auto [kind, is_new] = numbers.try_emplace(name.kind(), kinds.size());
    if (is_new) kinds.emplace_back();
    kinds[kind->second].push_back(name);
  }
  if (kinds.size() == files.size()) return;  // without counting numbers, the order of names decides
  if (kinds.size() > 1) fail_kinds(source, kinds, folder);
  const Names& names = kinds[0];
  const Count name_count = count(names);
  if (name_count.counting.empty() && name_count.others.size() < 2)
    fail(source, "two pictures have the same number", "leave out one of them");
  if (name_count.counting.empty() ||
      !std::is_sorted(names.begin(), names.end(), Earlier(name_count.others)))
    fail_counts(source, names, folder);
  if (!is_one_order(names, name_count))
    fail(source,
         "the numbers in the names give different orders, such as for " + shown(text_of(names[0])) +
             " and " + shown(text_of(names[1])),
         "rename the pictures so that one number counts them");
}

}  // namespace discmc::command

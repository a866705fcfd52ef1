#include "label_table.hpp"

#include <algorithm>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "text/number_text.hpp"
#include "text/words.hpp"
#include "volume_error.hpp"

namespace discmc::command {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

std::string_view without_line_end(std::string_view line) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

using Words = std::vector<std::string_view>;

// The parts of a line between tabs, empty ones too.
Words columns(std::string_view line) {
  Words columns;
  for (std::size_t tab; (tab = line.find('\t')) != std::string_view::npos;) {
    columns.push_back(line.substr(0, tab));
    line.remove_prefix(tab + 1);
  }
  columns.push_back(line);
  return columns;
}

// Three words from 0 to 255.
std::optional<Srgb> colour_of(const Words& words, std::size_t first) {
  Srgb colour{};
  if (words.size() < first + colour.size()) return std::nullopt;
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto part = whole_number<std::uint8_t>(words[first + i]);
    if (!part) return std::nullopt;
    colour[i] = *part;
  }
  return colour;
}

// #RRGGBB
std::optional<Srgb> hexadecimal_colour(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Srgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto part = whole_number<std::uint8_t>(text.substr(1 + 2 * i, 2), 16);
    if (!part) return std::nullopt;
    colour[i] = *part;
  }
  return colour;
}

struct Entry {
  std::int64_t label;
  LabelDescription description;
};

std::optional<Entry> entry(std::string_view index, std::string_view name,
                           const std::optional<Srgb>& colour) {
  const auto label = whole_number<std::int64_t>(index);
  if (!label || name.empty()) return std::nullopt;
  return Entry{*label, {std::string(name), colour}};
}

// The lines of a table, which its first one tells how to read.
class Reader {
 public:
  /// Returns whether the line is the head of columns.
  bool take_head(std::string_view line) {
    const Words heads = columns(line);
    const auto column = [&heads](std::string_view head) {
      return static_cast<std::size_t>(std::find(heads.begin(), heads.end(), head) - heads.begin());
    };
    index_ = column("index");
    name_ = column("name");
    colour_ = column("color");
    has_columns_ = index_ < heads.size() && name_ < heads.size();
    return has_columns_;
  }

  std::optional<Entry> read(std::string_view line) const {
    if (has_columns_) return read_columns(columns(line));
    const std::size_t quote = line.find('"');
    return quote == std::string_view::npos ? read_words(words(line)) : read_quoted(line, quote);
  }

 private:
  std::optional<Entry> read_columns(const Words& words) const {
    if (index_ >= words.size() || name_ >= words.size()) return std::nullopt;
    const std::string_view colour = colour_ < words.size() ? trimmed(words[colour_]) : "";
    if (colour.empty() || colour == "n/a") return entry(words[index_], words[name_], {});
    const auto read = hexadecimal_colour(colour);
    return read ? entry(words[index_], words[name_], read) : std::nullopt;
  }

  static std::optional<Entry> read_words(const Words& words) {
    if (words.size() == 2) return entry(words[0], words[1], {});
    const auto colour = colour_of(words, 2);
    return colour && words.size() <= 6 ? entry(words[0], words[1], colour) : std::nullopt;
  }

  static std::optional<Entry> read_quoted(std::string_view line, std::size_t quote) {
    const std::size_t end = line.find('"', quote + 1);
    const Words before = words(line.substr(0, quote));
    if (end == std::string_view::npos || before.empty()) return std::nullopt;
    return entry(before[0], line.substr(quote + 1, end - quote - 1), colour_of(before, 1));
  }

  bool has_columns_ = false;
  std::size_t index_ = 0, name_ = 0, colour_ = 0;
};

}  // namespace

LabelTable read_label_table(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::error_code ignored;
  if (!in || std::filesystem::is_directory(file, ignored))
    fail(file, "the table cannot be read", "check its name");
  LabelTable table;
  Reader reader;
  bool is_first = true;
  std::size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (number == 1 && text.rfind(byte_order_mark, 0) == 0) text.erase(0, byte_order_mark.size());
    // Blanks may be empty columns.
    const std::string_view line = without_line_end(text);
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const bool is_head = is_first && reader.take_head(line);
    is_first = false;
    if (is_head) continue;
    const auto read = reader.read(line);
    if (!read)
      fail(file, "line " + std::to_string(number) + " is " + shown(line),
           "give a whole number, a name of one word, and red, green and blue from 0 to 255");
    if (!table.emplace(read->label, read->description).second)
      fail(file, "label " + std::to_string(read->label) + " is there twice",
           "delete line " + std::to_string(number));
  }
  if (table.empty()) fail(file, "the table has no label", "check its name");
  return table;
}

}  // namespace discmc::command

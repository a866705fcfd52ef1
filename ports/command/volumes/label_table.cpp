#include "label_table.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "text/name_text.hpp"
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

// Splits a line at tabs or commas, with empty parts. Commas in quotes do not separate; quotes are
// dropped.
Words columns(std::string_view line, char separator) {
  Words columns;
  for (bool is_last = false; !is_last;) {
    const bool is_quoted = separator == ',' && !line.empty() && line.front() == '"';
    const std::size_t quote = is_quoted ? line.find('"', 1) : std::string_view::npos;
    const std::size_t begin = quote == std::string_view::npos ? 0 : 1;
    const std::size_t end = line.find(separator, begin == 0 ? 0 : quote);
    columns.push_back(line.substr(begin, (begin == 0 ? end : quote) - begin));
    is_last = end == std::string_view::npos;
    if (!is_last) line.remove_prefix(end + 1);
  }
  return columns;
}

// Parses three words from 0 to 255.
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

// Parses #RRGGBB.
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

std::optional<LabelDescription> entry(std::string_view index, std::string_view name,
                                      const std::optional<Srgb>& colour) {
  const auto label = label_value(index);
  if (!label || name.empty()) return std::nullopt;
  return LabelDescription{utf8(name), colour, {*label}};
}

// The lines of a table. The first line defines how to read the others.
class Reader {
 public:
  /// Returns whether the line names the columns.
  bool read_head(std::string_view line) {
    for (const char separator : {'\t', ','}) {
      separator_ = separator;
      heads_.clear();
      for (const std::string_view head : columns(line, separator)) heads_.push_back(lower(head));
      has_columns_ = (has("index") || has("labelvalue")) && has("name");
      if (has_columns_) break;
    }
    return has_columns_;
  }

  std::optional<LabelDescription> read(std::string_view line) const {
    if (has_columns_) return read_columns(columns(line, separator_));
    const std::size_t quote = line.find('"');
    return quote == std::string_view::npos ? read_words(words(line)) : read_quoted(line, quote);
  }

 private:
  std::size_t place(std::string_view head) const {
    return static_cast<std::size_t>(std::find(heads_.begin(), heads_.end(), head) - heads_.begin());
  }
  bool has(std::string_view head) const { return place(head) < heads_.size(); }

  // Returns an empty text if there is no such column.
  std::string_view value(const Words& words, std::string_view head) const {
    const std::size_t at = place(head);
    return at < words.size() ? trimmed(words[at]) : std::string_view();
  }

  // 3D Slicer may omit the name, because its columns of terms are more precise: "Left Kidney".
  std::string name(const Words& words) const {
    const std::string_view own = value(words, "name");
    if (!own.empty()) return std::string(own);
    const std::string modifier(value(words, "typemodifier_codemeaning"));
    return modifier + (modifier.empty() ? "" : " ") + std::string(value(words, "type_codemeaning"));
  }

  std::optional<LabelDescription> read_columns(const Words& words) const {
    const std::string_view index = value(words, has("index") ? "index" : "labelvalue");
    const std::string_view colour = value(words, "color");
    const std::string_view red = value(words, "color_r");
    if (!red.empty()) {
      const auto read = colour_of({red, value(words, "color_g"), value(words, "color_b")}, 0);
      return read ? entry(index, name(words), read) : std::nullopt;
    }
    if (colour.empty() || colour == "n/a") return entry(index, name(words), {});
    const auto read = hexadecimal_colour(colour);
    return read ? entry(index, name(words), read) : std::nullopt;
  }

  static std::optional<LabelDescription> read_words(const Words& words) {
    if (words.size() == 2) return entry(words[0], words[1], {});
    const auto colour = colour_of(words, 2);
    return colour && words.size() <= 6 ? entry(words[0], words[1], colour) : std::nullopt;
  }

  // ITK-SNAP writes the colour before the name, other programs after it.
  static std::optional<LabelDescription> read_quoted(std::string_view line, std::size_t quote) {
    const std::size_t end = line.find('"', quote + 1);
    const Words before = words(line.substr(0, quote));
    if (end == std::string_view::npos || before.empty()) return std::nullopt;
    const Words after = words(line.substr(end + 1));
    const auto colour = after.empty() ? colour_of(before, 1) : colour_of(after, 0);
    if (!colour && before.size() + after.size() > 1) return std::nullopt;
    return entry(before[0], line.substr(quote + 1, end - quote - 1), colour);
  }

  bool has_columns_ = false;
  char separator_ = '\t';
  std::vector<std::string> heads_;  // names of columns, in lower case
};

}  // namespace

LabelTable read_label_table(const std::string& file) {
  std::ifstream in(file);
  std::error_code ignored;
  if (!in || std::filesystem::is_directory(file, ignored))
    fail(file, "the table cannot be read", "check its name");
  if ((in >> std::ws).peek() == '{') return read_label_json(file);
  in.clear();
  in.seekg(0);
  LabelTable table;
  std::set<LabelValue> used_values;
  Reader reader;
  bool is_first = true;
  std::size_t number = 0;
  for (std::string text; std::getline(in, text);) {
    ++number;
    if (number == 1 && text.rfind(byte_order_mark, 0) == 0) text.erase(0, byte_order_mark.size());
    // Blanks may be empty columns.
    const std::string_view line = without_line_end(text);
    if (trimmed(line).empty() || trimmed(line).front() == '#') continue;
    const bool is_head = is_first && reader.read_head(line);
    is_first = false;
    if (is_head) continue;
    auto read = reader.read(line);
    if (!read)
      fail(file, "line " + std::to_string(number) + " is " + shown(line),
           "give a whole number, a name of one word or in quotes, and red, green and blue from 0 "
           "to 255");
    if (!used_values.insert(read->values[0]).second)
      fail(file, "label " + read->values[0].text() + " is given twice",
           "delete line " + std::to_string(number));
    table.push_back(*std::move(read));
  }
  if (table.empty()) fail(file, "the table has no label", "check its name");
  return table;
}

std::optional<Srgb> colour_of_shares(const std::array<std::string_view, 3>& texts) {
  Srgb colour{};
  for (std::size_t i = 0; i < colour.size(); ++i) {
    const auto share = finite_number(texts[i]);
    if (!share || *share < 0 || *share > 1) return std::nullopt;
    colour[i] = byte_of_share(*share);
  }
  return colour;
}

}  // namespace discmc::command

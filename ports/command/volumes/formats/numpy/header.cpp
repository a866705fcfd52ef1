// NumPy's .npy, https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html: a magic
// number, a version and a Python dictionary that describes the storage of one array.
#include "header.hpp"

#include <algorithm>
#include <utility>

#include "text/words.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_fields.hpp"

namespace discmc::command {
namespace {

std::string read_dictionary(ByteStream& stream) {
  unsigned char start[8] = {};
  const std::size_t got = stream.read(start, sizeof start);
  const bool is_long = start[6] >= 2;
  unsigned char length[4] = {};
  const std::size_t length_bytes = is_long ? 4 : 2;
  if (got < sizeof start || stream.read(length, length_bytes) < length_bytes)
    fail(stream.file(), "the header is incomplete", "save the array again");
  if (start[6] < 1 || start[6] > 3)
    fail(stream.file(), "this is version " + std::to_string(start[6]) + " of the format",
         "save the array as version 1 to 3");
  const std::uint64_t bytes = whole_of(length, sizeof length, false);
  constexpr std::uint64_t max_header_bytes = 1U << 20;
  if (bytes > max_header_bytes)
    fail(stream.file(), "the header has " + std::to_string(bytes) + " bytes",
         "save one plain array");
  std::string text(bytes, '\0');
  if (stream.read(text.data(), text.size()) < text.size())
    fail(stream.file(), "the header is incomplete", "save the array again");
  return text;
}

// Returns the text after a key of the dictionary, up to the end of its value.
std::string_view value_of(const std::filesystem::path& file, std::string_view dictionary,
                          const std::string& key) {
  const std::size_t at = dictionary.find("'" + key + "':");
  if (at == std::string_view::npos) fail(file, "the header has no " + key, "save one plain array");
  std::string_view value = trimmed(dictionary.substr(at + key.size() + 3));
  const bool is_tuple = !value.empty() && value.front() == '(';
  value = value.substr(0, value.find_first_of(is_tuple ? ")" : ",}"));
  return trimmed(is_tuple ? value.substr(1) : value);
}

std::string_view without_quotes(std::string_view text) {
  return text.size() < 2 ? text : text.substr(1, text.size() - 2);
}

std::vector<std::int64_t> sizes_of(const std::filesystem::path& file, std::string_view shape) {
  std::string text(shape);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<std::int64_t> sizes;
  for (const auto word : words(text)) sizes.push_back(integer(file, "shape", word));
  return sizes;
}

}  // namespace

NumpyHeader read_numpy_header(ByteStream& stream) {
  const std::filesystem::path file = stream.file();
  const std::string dictionary = read_dictionary(stream);
  NumpyHeader header;
  header.type = without_quotes(value_of(file, dictionary, "descr"));
  header.shape.is_first_fastest = value_of(file, dictionary, "fortran_order") == "True";
  header.shape.sizes = sizes_of(file, value_of(file, dictionary, "shape"));
  return header;
}

std::optional<NumpyType> numpy_type(std::string_view name) {
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"u1", SampleType::u8},  {"i1", SampleType::i8},  {"b1", SampleType::u8},
      {"u2", SampleType::u16}, {"i2", SampleType::i16}, {"u4", SampleType::u32},
      {"i4", SampleType::i32}, {"u8", SampleType::u64}, {"i8", SampleType::i64},
      {"f2", SampleType::f32}, {"f4", SampleType::f32}, {"f8", SampleType::f64}};
  constexpr std::string_view orders = "<>|";
  if (name.empty() || orders.find(name[0]) == std::string_view::npos) return std::nullopt;
  for (const auto& [called, type] : names)
    if (name.substr(1) == called) return NumpyType{type, name[0] == '>', called == "f2"};
  return std::nullopt;
}

}  // namespace discmc::command

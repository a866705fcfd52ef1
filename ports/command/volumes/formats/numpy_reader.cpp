// NumPy's .npy, https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html: a magic
// number, a version and a dictionary of Python that says how one array is stored.
#include <algorithm>
#include <utility>

#include "text/words.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/header_text.hpp"
#include "volumes/told_place.hpp"

namespace discmc::command {
namespace {

// Returns the dictionary.
std::string read_header(ByteStream& stream) {
  unsigned char start[8] = {};
  const std::size_t got = stream.read(start, sizeof start);
  const bool is_long = start[6] >= 2;
  unsigned char length[4] = {};
  const std::size_t length_bytes = is_long ? 4 : 2;
  if (got < sizeof start || stream.read(length, length_bytes) < length_bytes)
    fail(stream.file(), "the header is not whole", "save the array again");
  if (start[6] < 1 || start[6] > 3)
    fail(stream.file(), "this is version " + std::to_string(start[6]) + " of the format",
         "save the array as version 1 to 3");
  std::uint32_t bytes = 0;
  for (std::size_t i = 0; i < 4; ++i) bytes |= std::uint32_t{length[i]} << 8 * i;
  constexpr std::uint32_t max_header_bytes = 1U << 20;
  if (bytes > max_header_bytes)
    fail(stream.file(), "the header has " + std::to_string(bytes) + " bytes",
         "save one plain array");
  std::string text(bytes, '\0');
  if (stream.read(text.data(), text.size()) < text.size())
    fail(stream.file(), "the header is not whole", "save the array again");
  return text;
}

// Returns what follows a key of the dictionary, up to the end of its value.
std::string_view value_of(const std::filesystem::path& file, std::string_view dictionary,
                          const std::string& key) {
  const std::size_t at = dictionary.find("'" + key + "':");
  if (at == std::string_view::npos) fail(file, "the header has no " + key, "save one plain array");
  std::string_view value = trimmed(dictionary.substr(at + key.size() + 3));
  const bool is_tuple = !value.empty() && value.front() == '(';
  value = value.substr(0, value.find_first_of(is_tuple ? ")" : ",}"));
  return trimmed(is_tuple ? value.substr(1) : value);
}

// Takes the type and returns the byte order.
bool take_type(VolumeInfo& info, const std::filesystem::path& file, std::string_view descr) {
  constexpr std::pair<std::string_view, SampleType> names[] = {
      {"u1", SampleType::u8},  {"i1", SampleType::i8},  {"b1", SampleType::u8},
      {"u2", SampleType::u16}, {"i2", SampleType::i16}, {"u4", SampleType::u32},
      {"i4", SampleType::i32}, {"u8", SampleType::u64}, {"i8", SampleType::i64},
      {"f4", SampleType::f32}, {"f8", SampleType::f64}};
  // In quotes: the byte order, the kind and the bytes.
  const std::string_view order = descr.substr(0, 2);
  for (const auto& [name, type] : names) {
    if (descr.size() != 5 || descr.substr(2, 2) != name) continue;
    info.type = type;
    if (order == "'>" || order == "'<" || order == "'|") return order == "'>";
  }
  fail_type(file, descr);
}

std::vector<std::int64_t> sizes_of(const std::filesystem::path& file, std::string_view shape) {
  std::string text(shape);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::vector<std::int64_t> sizes;
  for (const auto word : words(text)) sizes.push_back(integer(file, "shape", word));
  return sizes;
}

}  // namespace

std::unique_ptr<VolumeReader> open_numpy(ByteStream stream, const VolumeOptions& options) {
  const std::filesystem::path file = stream.file();
  const std::string dictionary = read_header(stream);
  VolumeInfo info;
  info.format = "NumPy";
  const bool big_endian = take_type(info, file, value_of(file, dictionary, "descr"));
  // x is the axis along which neighbours are stored side by side.
  auto sizes = sizes_of(file, value_of(file, dictionary, "shape"));
  const bool is_fortran = value_of(file, dictionary, "fortran_order") == "True";
  if (is_fortran)
    note(info, "Fortran order: taken as array[x][y][z]");
  else
    std::reverse(sizes.begin(), sizes.end());
  set_dims(info, file, sizes, options.frame);
  set_place(info, {}, options);
  return std::make_unique<SliceStream>(std::move(info), std::move(stream), big_endian,
                                       options.frame);
}

}  // namespace discmc::command

#include "description.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include "volumes/formats/numpy/header.hpp"
#include "volumes/volume_error.hpp"

namespace discmc::command {
namespace {

// Messages name the file with the fault.
using Path = std::filesystem::path;

constexpr const char* rewrite =
    "write it again with Blosc, Zstandard, gzip or zlib, e.g. with zarr in Python";

PerAxis sizes_of_chunk(const Path& file, const Json& sizes, std::size_t axes) {
  const auto numbers = integers_of(file, "the sizes of chunks", sizes);
  constexpr std::int64_t max_size = std::int64_t{1} << 31;
  const bool is_usable =
      numbers.size() == axes && std::all_of(numbers.begin(), numbers.end(), [](std::int64_t size) {
        return size >= 1 && size <= max_size;
      });
  if (!is_usable)
    fail(file, "the sizes of chunks do not fit the axes of the array", "write it again");
  return {numbers.begin(), numbers.end()};
}

void set_type(ZarrDescription& array, const Path& file, const std::optional<NumpyType>& type,
              const Json& given) {
  if (!type) fail_type(file, given.is_string() ? text_of(given) : given.dump().substr(0, 60));
  array.type = type->type;
  array.is_half = type->is_half;
  array.is_big_endian = type->is_big_endian;
}

// Converts names of version 3 to NumPy's: "uint16" to "<u2".
std::optional<NumpyType> type_of_version_3(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> names[] = {
      {"bool", "|b1"},  {"uint8", "|u1"},   {"int8", "|i1"},    {"uint16", "<u2"},
      {"int16", "<i2"}, {"uint32", "<u4"},  {"int32", "<i4"},   {"uint64", "<u8"},
      {"int64", "<i8"}, {"float16", "<f2"}, {"float32", "<f4"}, {"float64", "<f8"}};
  for (const auto& [called, of_numpy] : names)
    if (called == name) return numpy_type(of_numpy);
  return std::nullopt;
}

template <class Sample>
std::optional<Sample> sample_of(const Json& value) {
  if (value.is_null()) return Sample{};
  if (value.is_boolean()) return static_cast<Sample>(value.get<bool>());
  if constexpr (std::is_floating_point_v<Sample>) {
    if (value.is_number()) return static_cast<Sample>(value.get<double>());
    const std::string text = text_of(value);
    if (text == "NaN") return std::numeric_limits<Sample>::quiet_NaN();
    if (text == "Infinity") return std::numeric_limits<Sample>::infinity();
    if (text == "-Infinity") return -std::numeric_limits<Sample>::infinity();
    return std::nullopt;
  } else {
    if (value.is_number_unsigned()) {
      const auto number = value.get<std::uint64_t>();
      if (number <= std::uint64_t{std::numeric_limits<Sample>::max()})
        return static_cast<Sample>(number);
      return std::nullopt;
    }
    if (value.is_number_integer()) {
      const auto number = value.get<std::int64_t>();
      if (std::is_signed_v<Sample> && number >= std::int64_t{std::numeric_limits<Sample>::min()})
        return static_cast<Sample>(number);
      return std::nullopt;
    }
    return value.is_number_float() && value.get<double>() == 0 ? std::optional(Sample{})
                                                               : std::nullopt;
  }
}

void set_fill(ZarrDescription& array, const Path& file, const Json& value) {
  with_sample_type(array.type, [&](auto typed) {
    const auto sample = sample_of<decltype(typed)>(value);
    if (!sample)
      fail(file, "the fill value " + shown(value.dump()) + " is not a sample of the array",
           "write it as a number");
    std::memcpy(array.fill.data(), &*sample, sizeof *sample);
  });
}

void add_codec(std::vector<ZarrCodec>& codecs, const Path& file, const std::string& name) {
  const auto codec = zarr_codec(name);
  if (!codec)
    fail(file, "the chunks are packed by " + shown(name) + ", which is not supported", rewrite);
  const bool is_packed = std::any_of(codecs.begin(), codecs.end(),
                                     [](ZarrCodec each) { return each != ZarrCodec::crc32c; });
  if (is_packed && *codec != ZarrCodec::crc32c) fail(file, "the chunks are packed twice", rewrite);
  codecs.push_back(*codec);
}

// Accepts filters that keep the type of the samples.
void add_filter(ZarrDescription& array, const Path& file, const Json& filter, const Json& type) {
  const std::string name = text_of(member(filter, "id"));
  const Json& stored = member(filter, "astype");
  const bool keeps_type = stored.is_null() || text_of(stored) == text_of(type);
  const Json& size = member(filter, "elementsize");
  const bool is_whole = !array.is_half && !array.is_big_endian;
  if (name == "shuffle" && size.is_number_unsigned() && size > 0 && size <= 64)
    array.filters.push_back({size.get<std::size_t>(), {}});
  else if (name == "delta" && keeps_type && is_whole)
    array.filters.push_back({0, array.type});
  else if (name != "bitround" && (name != "quantize" || !keeps_type))
    fail(file, "its samples went through the filter " + shown(filter.dump()),
         "write it again without filters, e.g. with zarr in Python");
}

ZarrDescription described_version_2(const ZarrNode& node) {
  const Json& json = node.array;
  ZarrDescription array;
  array.sizes = integers_of(node.file, "shape", member(json, "shape"));
  array.chunk = sizes_of_chunk(node.file, member(json, "chunks"), array.sizes.size());
  const Json& type = member(json, "dtype");
  set_type(array, node.file, numpy_type(text_of(type)), type);
  set_fill(array, node.file, member(json, "fill_value"));
  array.order.resize(array.sizes.size());
  std::iota(array.order.begin(), array.order.end(), std::size_t{0});
  if (text_of(member(json, "order")) == "F") std::reverse(array.order.begin(), array.order.end());
  for (const Json& filter : member(json, "filters")) add_filter(array, node.file, filter, type);
  const Json& compressor = member(json, "compressor");
  if (!compressor.is_null()) add_codec(array.codecs, node.file, text_of(member(compressor, "id")));
  if (text_of(member(json, "dimension_separator")) == "/") array.separator = '/';
  return array;
}

// Returns the order of axes in a chunk, if a codec permutes them.
std::vector<std::size_t> order_of(const Path& file, const Json& configuration, std::size_t axes) {
  const auto numbers = integers_of(file, "the order of axes", member(configuration, "order"));
  std::vector<std::size_t> order(axes);
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (!std::is_permutation(order.begin(), order.end(), numbers.begin(), numbers.end()))
    fail(file, "the order of axes does not fit the axes of the array", "write it again");
  return {numbers.begin(), numbers.end()};
}

// Reads the codecs of an array, or of a shard's index, which has 64-bit numbers.
void read_codecs(ZarrDescription& array, const Path& file, const Json& codecs);

void read_shard(ZarrDescription& array, const Path& file, const Json& configuration) {
  ZarrShard& shard = array.shard.emplace();
  shard.chunks = array.chunk;
  array.chunk = sizes_of_chunk(file, member(configuration, "chunk_shape"), array.sizes.size());
  for (std::size_t axis = 0; axis < shard.chunks.size(); ++axis) {
    if (shard.chunks[axis] % array.chunk[axis] != 0)
      fail(file, "a shard does not hold a whole number of chunks", "write it again");
    shard.chunks[axis] /= array.chunk[axis];
  }
  shard.has_index_at_start = text_of(member(configuration, "index_location")) == "start";
  for (const Json& codec : member(configuration, "index_codecs")) {
    const std::string name = text_of(member(codec, "name"));
    if (name == "crc32c")
      shard.has_index_checksum = true;
    else if (name != "bytes" || text_of(member(member(codec, "configuration"), "endian")) == "big")
      fail(file, "the index of its shards is stored by " + shown(name) + ", which is not supported",
           "write it again as zarr in Python does");
  }
  read_codecs(array, file, member(configuration, "codecs"));
}

void read_codecs(ZarrDescription& array, const Path& file, const Json& codecs) {
  for (const Json& codec : codecs) {
    const std::string name = text_of(member(codec, "name"));
    const Json& configuration = member(codec, "configuration");
    const bool is_first = array.codecs.empty() && !array.shard;
    if (name == "bytes")
      array.is_big_endian = text_of(member(configuration, "endian")) == "big";
    else if (name == "transpose")
      array.order = order_of(file, configuration, array.sizes.size());
    else if (name == "sharding_indexed" && codecs.size() == 1 && is_first)
      read_shard(array, file, configuration);
    else
      add_codec(array.codecs, file, name);
  }
}

ZarrDescription described_version_3(const ZarrNode& node) {
  const Json& json = node.array;
  ZarrDescription array;
  array.sizes = integers_of(node.file, "shape", member(json, "shape"));
  const std::size_t axes = array.sizes.size();
  const Json& grid = member(json, "chunk_grid");
  if (text_of(member(grid, "name")) != "regular")
    fail(node.file, "the chunks are not all of one size", "write it again as a regular grid");
  array.chunk =
      sizes_of_chunk(node.file, member(member(grid, "configuration"), "chunk_shape"), axes);
  const Json& type = member(json, "data_type");
  set_type(array, node.file, type_of_version_3(text_of(type)), type);
  set_fill(array, node.file, member(json, "fill_value"));
  array.order.resize(axes);
  std::iota(array.order.begin(), array.order.end(), std::size_t{0});
  read_codecs(array, node.file, member(json, "codecs"));
  const Json& keys = member(json, "chunk_key_encoding");
  const bool is_default = text_of(member(keys, "name")) != "v2";
  const std::string separator = text_of(member(member(keys, "configuration"), "separator"));
  array.separator = separator.empty() ? (is_default ? '/' : '.') : separator[0];
  if (is_default) array.prefix = std::string("c") + array.separator;
  for (const Json& name : member(json, "dimension_names"))
    array.axis_names.push_back(text_of(name));
  return array;
}

// Reads xarray's names of the axes.
void read_attributes(ZarrDescription& array, const Json& attributes) {
  if (!array.axis_names.empty()) return;
  for (const Json& name : member(attributes, "_ARRAY_DIMENSIONS"))
    array.axis_names.push_back(text_of(name));
}

// Whether some file or folder is named like a chunk.
bool has_chunk(const ZarrDescription& array) {
  const bool is_nested = array.separator == '/' && array.sizes.size() > 1;
  const std::filesystem::path folder =
      array.separator == '/' ? array.folder / array.prefix : array.folder;
  const std::string prefix = array.separator == '/' ? "" : array.prefix;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(ignored) == is_nested && name.rfind(prefix, 0) == 0 &&
        name.find_first_not_of("0123456789.", prefix.size()) == std::string::npos)
      return true;
  }
  return false;
}

}  // namespace

std::size_t ZarrDescription::chunk_bytes() const {
  std::size_t bytes = is_half ? 2 : sample_bytes(type);
  for (const std::uint64_t size : chunk) bytes *= size;
  return bytes;
}

ZarrDescription described(const ZarrNode& node) {
  const bool is_version_3 = node.file.filename() == "zarr.json";
  ZarrDescription array = is_version_3 ? described_version_3(node) : described_version_2(node);
  array.folder = node.folder;
  read_attributes(array, node.attributes);
  std::uint64_t max_samples = (std::uint64_t{1} << 31) / sample_bytes(array.type);
  for (const std::uint64_t size : array.chunk) {
    if (size > max_samples)
      fail(node.file, "its chunks have more than 2 GiB", "write it again in smaller ones");
    max_samples /= size;
  }
  if (has_chunk(array)) return array;
  // Some writers do not declare that their chunks are nested.
  if (!is_version_3) array.separator = array.separator == '.' ? '/' : '.';
  if (is_version_3 || !has_chunk(array))
    fail(node.folder, "the array has no chunk", "copy the whole folder");
  return array;
}

}  // namespace discmc::command

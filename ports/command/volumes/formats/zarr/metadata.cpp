#include "description.hpp"

#include "volumes/volume_error.hpp"
#include "volumes/volume_stream.hpp"

namespace discmc::command {
namespace {

Json read_json(const std::filesystem::path& file) {
  constexpr std::size_t max_bytes = 1U << 24;
  ByteStream stream(file);
  const std::string_view text = stream.peek(max_bytes);
  Json json = Json::parse(text.begin(), text.end(), nullptr, false);
  if (!json.is_object()) fail(file, "this is not a JSON object", "copy or write the file again");
  return json;
}

}  // namespace

const Json& member(const Json& object, const char* name) {
  static const Json none;
  const auto found = object.find(name);
  return found == object.end() ? none : *found;
}

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::vector<std::int64_t> integers_of(const std::filesystem::path& file, const char* name,
                                      const Json& value) {
  std::vector<std::int64_t> numbers;
  for (const Json& number : value) {
    if (!number.is_number_integer()) break;
    numbers.push_back(number.get<std::int64_t>());
  }
  if (!value.is_array() || numbers.empty() || numbers.size() != value.size())
    fail(file, std::string(name) + " is not a list of whole numbers", "write the file again");
  return numbers;
}

std::vector<double> reals_of(const std::filesystem::path& file, const char* name,
                             const Json& value) {
  std::vector<double> numbers;
  for (const Json& number : value) {
    if (!number.is_number()) break;
    numbers.push_back(number.get<double>());
  }
  if (!value.is_array() || numbers.size() != value.size())
    fail(file, std::string(name) + " is not a list of numbers", "write the file again");
  return numbers;
}

ZarrNode read_zarr_node(const std::filesystem::path& folder) {
  ZarrNode node{folder, folder / "zarr.json"};
  if (is_file(node.file)) {
    node.array = read_json(node.file);
    node.is_array = text_of(member(node.array, "node_type")) == "array";
    node.attributes = member(node.array, "attributes");
    // OME-Zarr 0.5 nests its metadata in an object.
    const Json ome = member(node.attributes, "ome");
    if (ome.is_object()) node.attributes.update(ome);
    return node;
  }
  if (is_file(folder / ".zattrs")) node.attributes = read_json(folder / ".zattrs");
  node.file = folder / ".zarray";
  node.is_array = is_file(node.file);
  if (node.is_array)
    node.array = read_json(node.file);
  else
    node.file = folder / ".zattrs";
  if (!node.is_array && !is_file(folder / ".zgroup") && !is_file(folder / ".zattrs"))
    fail(folder, "this is not a group or array of Zarr", "give the folder of a group or array");
  return node;
}

}  // namespace discmc::command

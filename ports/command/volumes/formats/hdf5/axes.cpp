#include "dataset.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string_view>

#include "text/words.hpp"

namespace discmc::command {
namespace {

// An attribute with its type and its number of values.
struct Attribute {
  Hdf5Handle id, type, space;
  std::size_t count = 0;

  Attribute(const Hdf5Handle& object, const char* name)
      : id(H5Aexists(object.id(), name) > 0 ? H5Aopen(object.id(), name, H5P_DEFAULT)
                                            : H5I_INVALID_HID,
           H5Aclose),
        type(H5Aget_type(id.id()), H5Tclose),
        space(H5Aget_space(id.id()), H5Sclose) {
    constexpr hssize_t max_count = 4096;
    const hssize_t points = id ? H5Sget_simple_extent_npoints(space.id()) : 0;
    if (points > 0 && points <= max_count) count = static_cast<std::size_t>(points);
  }
};

// Returns texts of any form; empty if the attribute has none.
std::vector<std::string> texts_of(const Hdf5Handle& object, const char* name) {
  const Attribute attribute(object, name);
  constexpr std::size_t max_bytes = 1 << 20;
  const std::size_t bytes = H5Tget_size(attribute.type.id());
  if (attribute.count == 0 || H5Tget_class(attribute.type.id()) != H5T_STRING ||
      bytes * attribute.count > max_bytes)
    return {};
  std::vector<std::string> texts;
  if (H5Tis_variable_str(attribute.type.id()) > 0) {
    std::vector<char*> read(attribute.count);
    if (H5Aread(attribute.id.id(), attribute.type.id(), read.data()) < 0) return {};
    for (const char* text : read) texts.emplace_back(text == nullptr ? "" : text);
    H5Dvlen_reclaim(attribute.type.id(), attribute.space.id(), H5P_DEFAULT, read.data());
    return texts;
  }
  std::string read(bytes * attribute.count, '\0');
  if (H5Aread(attribute.id.id(), attribute.type.id(), read.data()) < 0) return {};
  for (std::size_t i = 0; i < attribute.count; ++i)
    texts.emplace_back(read.substr(i * bytes, bytes).c_str());
  return texts;
}

std::vector<double> coordinates_of(const Hdf5Handle& scale) {
  // NetCDF writes a scale even for an axis without coordinates.
  if (text_of(scale, "NAME").rfind("This is a netCDF dimension but", 0) == 0) return {};
  const Hdf5Handle space(H5Dget_space(scale.id()), H5Sclose);
  return H5Sget_simple_extent_ndims(space.id()) == 1 ? numbers_in(scale) : std::vector<double>();
}

std::string path_of(const Hdf5Handle& object) {
  char path[1024] = {};
  H5Iget_name(object.id(), path, sizeof path);
  return path;
}

Hdf5Axis axis_of(const Hdf5Handle& scale) {
  Hdf5Axis axis;
  if (H5Iget_type(scale.id()) != H5I_DATASET) return axis;
  axis.name = std::filesystem::path(path_of(scale)).filename().string();
  const std::string letter = text_of(scale, "axis");
  if (!letter.empty()) axis.name = letter;
  axis.unit = text_of(scale, "units");
  axis.coordinates = coordinates_of(scale);
  return axis;
}

// Returns the names of axes in NeXus: datasets in the array's group or, in older files, one text of
// the array, "z:y:x".
std::vector<std::string> nexus_names(const Hdf5Handle& dataset, const Hdf5Handle& group) {
  auto names = texts_of(group, "axes");
  if (names.empty()) names = texts_of(dataset, "axes");
  if (names.size() != 1) return names;
  for (char& c : names[0])
    if (std::string_view(":,[]").find(c) != std::string_view::npos) c = ' ';
  const auto parts = words(names[0]);
  return {parts.begin(), parts.end()};
}

// Reads the axes of EMD, the datasets dim1, dim2, ... beside the array: "z" in "[n_m]". Version 1
// begins with dim0.
bool read_emd_axes(std::vector<Hdf5Axis>& axes, const Hdf5Handle& group) {
  if (H5Aexists(group.id(), "emd_group_type") <= 0) return false;
  const std::size_t first = H5Lexists(group.id(), "dim0", H5P_DEFAULT) > 0 ? 0 : 1;
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const std::string dim = "dim" + std::to_string(first + i);
    const Hdf5Handle scale(H5Oopen(group.id(), dim.c_str(), H5P_DEFAULT), H5Oclose);
    axes[i] = axis_of(scale);
    axes[i].name = text_of(scale, "name");
    std::string& unit = axes[i].unit;
    const auto is_mark = [](char c) { return c == '[' || c == ']' || c == '_'; };
    unit.erase(std::remove_if(unit.begin(), unit.end(), is_mark), unit.end());
  }
  return true;
}

void read_nexus_axes(std::vector<Hdf5Axis>& axes, const Hdf5Handle& dataset) {
  const std::string folder = std::filesystem::path(path_of(dataset)).parent_path().string();
  const Hdf5Handle group(H5Gopen2(dataset.id(), folder.c_str(), H5P_DEFAULT), H5Gclose);
  if (read_emd_axes(axes, group)) return;
  const auto names = nexus_names(dataset, group);
  for (std::size_t i = 0; i < axes.size() && names.size() == axes.size(); ++i) {
    axes[i] = axis_of({H5Oopen(group.id(), names[i].c_str(), H5P_DEFAULT), H5Oclose});
    if (axes[i].name.empty()) axes[i].name = names[i];
  }
}

}  // namespace

std::vector<double> numbers_of(const Hdf5Handle& object, const char* name) {
  const Attribute attribute(object, name);
  const H5T_class_t kind = H5Tget_class(attribute.type.id());
  std::vector<double> numbers(attribute.count);
  if ((kind != H5T_INTEGER && kind != H5T_FLOAT) ||
      H5Aread(attribute.id.id(), H5T_NATIVE_DOUBLE, numbers.data()) < 0)
    return {};
  return numbers;
}

std::vector<double> numbers_in(const Hdf5Handle& dataset) {
  constexpr hssize_t max_count = 1 << 20;
  const Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const hssize_t count = H5Sget_simple_extent_npoints(space.id());
  if (count < 1 || count > max_count) return {};
  std::vector<double> numbers(static_cast<std::size_t>(count));
  if (H5Dread(dataset.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
    return {};
  return numbers;
}

std::string text_of(const Hdf5Handle& object, const char* attribute) {
  const auto texts = texts_of(object, attribute);
  return texts.size() == 1 ? texts[0] : std::string();
}

std::vector<Hdf5Axis> axes_of(const Hdf5Handle& dataset, std::size_t count) {
  std::vector<Hdf5Axis> axes(count);
  const auto labels = texts_of(dataset, "DIMENSION_LABELS");
  for (std::size_t i = 0; i < count && labels.size() == count; ++i) axes[i].name = labels[i];
  const Attribute list(dataset, "DIMENSION_LIST");
  const Hdf5Handle each(H5Tget_super(list.type.id()), H5Tclose);
  if (list.count != count || H5Tget_class(list.type.id()) != H5T_VLEN ||
      H5Tequal(each.id(), H5T_STD_REF_OBJ) <= 0) {
    read_nexus_axes(axes, dataset);
    return axes;
  }
  std::vector<hvl_t> references(count);
  if (H5Aread(list.id.id(), list.type.id(), references.data()) < 0) return axes;
  for (std::size_t i = 0; i < count; ++i) {
    if (references[i].len == 0) continue;
    const std::string label = axes[i].name;
    axes[i] = axis_of(
        {H5Rdereference2(dataset.id(), H5P_DEFAULT, H5R_OBJECT, references[i].p), H5Oclose});
    if (!label.empty()) axes[i].name = label;
  }
  H5Dvlen_reclaim(list.type.id(), list.space.id(), H5P_DEFAULT, references.data());
  return axes;
}

}  // namespace discmc::command

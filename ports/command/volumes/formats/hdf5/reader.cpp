// HDF5, https://docs.hdfgroup.org/hdf5/: a file with many arrays, one of which is the volume.
#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "dataset.hpp"
#include "text/words.hpp"
#include "volumes/array_layout.hpp"
#include "volumes/array_name.hpp"
#include "volumes/declared_place.hpp"
#include "volumes/filters/filters.hpp"
#include "volumes/formats/readers.hpp"
#include "volumes/formats/vtk_image.hpp"

#ifdef DISCMC_WITH_JSON
#include <nlohmann/json.hpp>
#endif

namespace discmc::command {
namespace {

// Successive regions along an axis of the array.
class Hdf5Blocks final : public NumberedSlices {
 public:
  /// info: its slices are the regions. first, count: the first region, and its extents. axis: along
  /// which the next region lies.
  Hdf5Blocks(std::filesystem::path name, VolumeInfo info, Hdf5Dataset dataset, Hdf5Region first,
             Hdf5Region count, std::size_t axis)
      : NumberedSlices(std::move(name), std::move(info)),
        dataset_(std::move(dataset)),
        first_(std::move(first)),
        count_(std::move(count)),
        axis_(axis) {}

 private:
  void read(std::uint32_t slice, void* samples) override {
    Hdf5Region first = first_;
    first[axis_] += slice;
    if (!dataset_.read(first, count_, samples))
      fail(source(),
           "slice " + std::to_string(slice) + " (the first is 0) of " +
               std::to_string(info().dims[2]) + " cannot be read; it is damaged or missing",
           copy_or_export);
  }

  Hdf5Dataset dataset_;
  Hdf5Region first_, count_;
  std::size_t axis_;
};

// VTK's image data: https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/.
constexpr const char* vtk_group = "/VTKHDF";
constexpr const char* vtk_times = "/VTKHDF/Steps";
constexpr const char* vtk_points = "/VTKHDF/PointData/";
constexpr const char* vtk_cells = "/VTKHDF/CellData/";

bool is_in(const char* folder, const std::string& path) {
  return path.rfind(folder, 0) == 0;
}

std::string vtk_type(const Hdf5Handle& file) {
  const Hdf5Handle group(H5Gopen2(file.id(), vtk_group, H5P_DEFAULT), H5Gclose);
  return group ? text_of(group, "Type") : std::string();
}

std::string vtk_letters(const Hdf5Handle& file, const Hdf5Description& array) {
  if (!is_in(vtk_points, array.path) && !is_in(vtk_cells, array.path)) return {};
  const bool has_times = H5Lexists(file.id(), vtk_times, H5P_DEFAULT) > 0;
  const std::string letters = has_times ? "tzyxc" : "zyxc";
  const std::size_t count = array.sizes.size();
  return count > letters.size() || count + 1 < letters.size() ? "" : letters.substr(0, count);
}

// BigDataViewer stores unsigned cells in a signed type: /t00000/s00/0/cells.
bool is_of_big_data_viewer(const Hdf5Description& array) {
  return array.type == SampleType::i16 && array.path.rfind("/t", 0) == 0 &&
         array.path.find("/s") != std::string::npos &&
         std::filesystem::path(array.path).filename() == "cells";
}

// Refuses programs whose arrays differ from their volumes.
void require_plain(const std::filesystem::path& name, const Hdf5Handle& file,
                   const std::vector<Hdf5Description>& datasets) {
  const auto holds = [&datasets](std::string_view begin) {
    return std::any_of(datasets.begin(), datasets.end(), [begin](const Hdf5Description& dataset) {
      return dataset.path.compare(0, begin.size(), begin) == 0;
    });
  };
  if (holds("/minc-2.0/"))
    fail(name, "this is MINC, which scales every slice differently, and is not supported",
         "convert it with mnc2nii");
  if (holds("/DataSet/ResolutionLevel"))
    fail(name, "this is Imaris, which pads its arrays, and is not supported",
         "convert it, e.g. with: bioformats2raw FILE OUT.zarr");
  const std::string type = vtk_type(file);
  if (!type.empty() && type != "ImageData")
    fail(name, "this is VTK's " + shown(type) + ", not ImageData",
         "write an image, e.g. with ParaView's filter Resample To Image");
}

// ChimeraX stores an array, and smaller copies of it: /Chimera/image1/data_zyx_2.
bool is_of_chimera(const std::string& path) {
  return is_in("/Chimera/", path) && path.find("/data_zyx") != std::string::npos;
}

// Internal arrays of MATLAB and VTK, and smaller copies of ChimeraX, do not count.
std::vector<NamedArray> arrays_of(const std::vector<Hdf5Description>& datasets) {
  std::vector<NamedArray> arrays;
  for (const Hdf5Description& dataset : datasets)
    if (dataset.path.compare(0, 2, "/#") != 0 &&
        std::filesystem::path(dataset.path).filename() != vtk_ghosts &&
        !(is_of_chimera(dataset.path) &&
          std::isdigit(static_cast<unsigned char>(dataset.path.back())) != 0))
      arrays.push_back({dataset.path, dataset.sizes});
  return arrays;
}

std::string list_of(const std::vector<std::string>& links) {
  return links.front() +
         (links.size() > 1 ? " and " + std::to_string(links.size() - 1) + " more" : "");
}

// Returns the path of the requested array, or else of the only one.
std::string path_of(const std::filesystem::path& name, const Hdf5Handle& file,
                    const Hdf5Contents& contents) {
  std::string asked = array_name(name).array;
  const std::vector<NamedArray> arrays = arrays_of(contents.datasets);
  if (!asked.empty()) {
    const Hdf5Handle object(H5Oopen(file.id(), asked.c_str(), H5P_DEFAULT), H5Oclose);
    if (!object || !description_of(object, asked)) fail_no_array(name, asked, arrays);
    return asked;
  }
  if (arrays.empty() && !contents.dead_links.empty())
    fail(name, "its links lead nowhere: " + list_of(contents.dead_links),
         "copy the files to its folder");
  return only_array(name, arrays);
}

// Returns the axes that ilastik and vigra store as JSON: [{"key": "z", ...}, ...].
std::string letters_of([[maybe_unused]] const Hdf5Dataset& dataset) {
  std::string letters;
#ifdef DISCMC_WITH_JSON
  const auto tags = nlohmann::json::parse(text_of(dataset.handle(), "axistags"), nullptr, false);
  if (!tags.is_object() || !tags.contains("axes")) return letters;
  for (const auto& axis : tags["axes"]) {
    const auto key = axis.is_object() ? axis.value("key", nlohmann::json()) : nlohmann::json();
    letters += key.is_string() ? key.get<std::string>() : "?";
  }
  const bool are_axes = letters.size() == dataset.description().sizes.size() &&
                        letters.find_first_not_of("tczyx") == std::string::npos;
  if (!are_axes) letters.clear();
#endif
  return letters;
}

// Returns letters by the names of all axes, if each is recognised and none repeats.
std::string letters_of(const std::vector<Hdf5Axis>& axes) {
  std::string letters;
  for (const Hdf5Axis& axis : axes) {
    const char letter = axis_letter(axis.name);
    if (letter == '?' || letters.find(letter) != std::string::npos) return {};
    letters += letter;
  }
  return letters;
}

// Attributes list the three axes of space in stored order; an image may lack the first.
void set_sizes(DeclaredPlace& place, const ArrayLayout& layout, const std::vector<double>& sizes,
               const std::vector<double>& offsets, const char* unit) {
  if (sizes.size() != 3) return;
  place.set_unit(unit);
  const std::string order = layout.order();
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto axis = static_cast<std::size_t>(order[i] - 'x');
    place.spacing[axis] = sizes[3 - order.size() + i];
    if (offsets.size() == 3) place.origin[axis] = offsets[3 - order.size() + i];
  }
}

// Copies the numbers of an image with x first, unless they are missing.
template <class Target>
bool set_three(Target& target, const std::vector<double>& numbers) {
  if (numbers.size() == 3) std::copy(numbers.begin(), numbers.end(), target.begin());
  return numbers.size() == 3;
}

std::vector<double> numbers_in(const Hdf5Handle& file, const std::string& path) {
  if (H5Lexists(file.id(), path.c_str(), H5P_DEFAULT) <= 0) return {};
  return command::numbers_in({H5Dopen2(file.id(), path.c_str(), H5P_DEFAULT), H5Dclose});
}

Hdf5Handle folder_of(const Hdf5Handle& file, const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return {H5Gopen2(file.id(), folder.c_str(), H5P_DEFAULT), H5Gclose};
}

// Reads the geometry of DREAM.3D, which is in a group of its own, with x first and without a unit.
// DREAM3D-NX stores it in attributes of the array's parent group.
void read_geometry(DeclaredPlace& place, const Hdf5Handle& file, const std::string& path) {
  const Hdf5Handle group = folder_of(file, std::filesystem::path(path).parent_path().string());
  set_three(place.spacing, numbers_of(group, "_SPACING"));
  set_three(place.origin, numbers_of(group, "_ORIGIN"));
  constexpr std::string_view containers = "/DataContainers/";
  const std::size_t end = path.find('/', containers.size());
  if (path.compare(0, containers.size(), containers) != 0 || end == std::string::npos) return;
  const std::string geometry = path.substr(0, end) + "/_SIMPL_GEOMETRY/";
  set_three(place.spacing, numbers_in(file, geometry + "SPACING"));
  set_three(place.origin, numbers_in(file, geometry + "ORIGIN"));
}

void read_chimera_map(VolumeInfo& info, DeclaredPlace& place, const Hdf5Handle& file,
                      const std::string& path) {
  if (!is_of_chimera(path)) return;
  const Hdf5Handle group = folder_of(file, path);
  if (!set_three(place.spacing, numbers_of(group, "step"))) return;
  set_three(place.origin, numbers_of(group, "origin"));
  place.set_unit("mm");
  note(info, "lengths are in angstrom; 1 angstrom is written as 1 mm");
  const auto angles = numbers_of(group, "cell_angles");
  const bool is_right = std::all_of(angles.begin(), angles.end(), [](double a) { return a == 90; });
  if (!is_right || !numbers_of(group, "rotation_angle").empty())
    note(info, "the map is turned or its cell is oblique, which is not applied");
}

// Reads the geometry of ITK, which is beside the array, with x first, in the space of the patient.
void read_itk_image(DeclaredPlace& place, const Hdf5Handle& file, const std::string& path,
                    const ArrayLayout& layout) {
  const std::filesystem::path image = std::filesystem::path(path).parent_path();
  if (!is_in("/ITKImage/", path) || path != image / "VoxelData" || layout.order() != "zyx") return;
  const auto directions = numbers_in(file, image / "Directions");
  DeclaredPlace itk_place;
  if (directions.size() != 9 ||
      !set_three(itk_place.spacing, numbers_in(file, image / "Spacing")) ||
      !set_three(itk_place.origin, numbers_in(file, image / "Origin")))
    return;
  place = itk_place;
  place.directions.emplace();
  for (std::size_t i = 0; i < 9; ++i) (*place.directions)[i / 3][i % 3] = directions[i];
  place.set_unit("mm");
  place.space = Space::lps;
}

void read_vtk_image(DeclaredPlace& place, const std::filesystem::path& name, const Hdf5Handle& file,
                    const std::string& path, const ArrayLayout& layout) {
  const std::string order = layout.order();
  const bool is_of_cells = is_in(vtk_cells, path);
  if (order.size() != 3 || !(is_of_cells || is_in(vtk_points, path))) return;
  const Hdf5Handle group(H5Gopen2(file.id(), vtk_group, H5P_DEFAULT), H5Gclose);
  const VtkExtent extent = vtk_extent(name, "WholeExtent", numbers_of(group, "WholeExtent"));
  const DeclaredPlace declared =
      declared_place(name, numbers_of(group, "Spacing"), numbers_of(group, "Origin"),
                     numbers_of(group, "Direction"), extent, is_of_cells);
  place = declared;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<std::size_t>(order[2 - i] - 'x');
    const std::uint64_t voxels = layout.sizes[*layout.axes[axis]];
    if (vtk_size(extent, i, is_of_cells) != static_cast<std::int64_t>(voxels))
      fail(name,
           "the array has " + std::to_string(voxels) + " voxels along axis " +
               std::to_string(i + 1) + ", and WholeExtent " +
               std::to_string(vtk_size(extent, i, is_of_cells)),
           "write the file again");
    place.spacing[axis] = declared.spacing[i];
    (*place.directions)[axis] = (*declared.directions)[i];
  }
}

DeclaredPlace place_of(VolumeInfo& info, const std::filesystem::path& name, const Hdf5Handle& file,
                       const Hdf5Dataset& dataset, const std::vector<Hdf5Axis>& axes,
                       const ArrayLayout& layout, const VolumeOptions& options) {
  const Hdf5Handle& handle = dataset.handle();
  DeclaredPlace place;
  read_geometry(place, file, dataset.description().path);
  read_chimera_map(info, place, file, dataset.description().path);
  read_itk_image(place, file, dataset.description().path, layout);
  read_vtk_image(place, name, file, dataset.description().path, layout);
  set_sizes(place, layout, numbers_of(handle, "element_size_um"), {}, "um");
  const auto resolution = numbers_of(handle, "resolution");
  if (resolution.size() == 3) note(info, "resolution and offset are read as nm, as CREMI has them");
  set_sizes(place, layout, resolution, numbers_of(handle, "offset"), "nm");
  for (const char* const attribute : {"spacing", "voxel_size"})
    if (numbers_of(handle, attribute).size() == 3)
      note(info, std::string(attribute) +
                     " is not used, because its order and unit are unknown; give --spacing X,Y,Z");
  for (std::size_t i = 0; i < 3; ++i) {
    if (!layout.axes[i] || *layout.axes[i] >= axes.size()) continue;
    const Hdf5Axis& axis = axes[*layout.axes[i]];
    if (axis.coordinates.empty()) continue;
    place.axis_units[i] = place.space_units[i] = axis.unit;
    const std::uint64_t voxels = layout.sizes[*layout.axes[i]];
    std::vector<double> coordinates = axis.coordinates;
    // EMD may store the first two only.
    const bool are_two = coordinates.size() == 2;
    while (are_two && coordinates.size() < voxels)
      coordinates.push_back(2 * coordinates.back() - coordinates[coordinates.size() - 2]);
    set_place_from_coordinates(place, i, name, axis.name, std::move(coordinates), voxels, options);
  }
  return place;
}

// Reads by slices. If the samples of a slice are far apart, reads by regions along the slowest
// axis.
std::unique_ptr<VolumeReader> volume_of(const std::filesystem::path& name, VolumeInfo info,
                                        Hdf5Dataset dataset, const Hdf5Handle& file,
                                        const ArrayLayout& layout) {
  BlockLayout blocks;
  if (layout.axes[2] && !dataset.is_chunked())
    blocks.block_axis = static_cast<std::size_t>(layout.order().front() - 'x');
  std::size_t row = blocks.block_axis == 0 ? 1 : 0;
  std::size_t column = 3 - blocks.block_axis - row;
  if (*layout.axes[row] > *layout.axes[column]) std::swap(row, column);
  blocks.strides[row] = info.dims[column];
  blocks.strides[column] = 1;

  Hdf5Region first(layout.first.begin(), layout.first.end());
  Hdf5Region count(first.size(), 1);
  count[*layout.axes[row]] = info.dims[row];
  count[*layout.axes[column]] = info.dims[column];
  dataset.expect(file, count);
  VolumeInfo block_info = info;
  block_info.dims = {info.dims[column], info.dims[row], info.dims[blocks.block_axis]};
  // An image is one block.
  const std::size_t axis = layout.axes[blocks.block_axis].value_or(0);
  auto reader = std::make_unique<Hdf5Blocks>(name, std::move(block_info), std::move(dataset),
                                             std::move(first), std::move(count), axis);
  if (blocks.block_axis == 2 && column == 0) return reader;
  return turned(std::move(info), std::move(reader), blocks, name);
}

}  // namespace

std::unique_ptr<VolumeReader> open_hdf5(const std::filesystem::path& name,
                                        const VolumeOptions& options) {
  const std::filesystem::path path = array_name(name).file;
  if (is_read_once(path)) fail(name, "HDF5 cannot be read from a pipe", "store it in a file");
  const Hdf5Handle file = open_hdf5_file(path);
  const Hdf5Contents contents = hdf5_contents(file);
  require_plain(name, file, contents.datasets);
  Hdf5Dataset dataset(name, file, path_of(name, file, contents));
  VolumeInfo info;
  info.type = *dataset.description().type;
  info.format = "HDF5, " + without_control(dataset.description().path) + ", " + dataset.storage();
  if (!contents.dead_links.empty())
    note(info, "links that lead nowhere: " + list_of(contents.dead_links));
  const auto axes = axes_of(dataset.handle(), dataset.description().sizes.size());
  std::string letters = letters_of(dataset);
  if (letters.empty()) letters = letters_of(axes);
  if (letters.empty()) letters = vtk_letters(file, dataset.description());
  if (letters.empty() && is_of_chimera(dataset.description().path)) letters = "zyx";
  const ArrayLayout layout =
      find_volume_axes(info, name, {dataset.description().sizes, letters}, options);
  if (!text_of(dataset.handle(), "MATLAB_class").empty() && options.axes.empty())
    note(info, "an array of MATLAB: its first index is read as x; if it is y, give --axes zxy");
  if (!dataset.is_virtual()) require_possible(dataset.file(), "a slice", info.slice_bytes());
  set_place(info, place_of(info, name, file, dataset, axes, layout, options), options);
  const auto number = [&dataset](const char* attribute) {
    const auto numbers = numbers_of(dataset.handle(), attribute);
    return numbers.size() == 1 ? std::optional(numbers[0]) : std::nullopt;
  };
  auto values = declared_values(number, text_of(dataset.handle(), "_Unsigned"));
  if (is_of_big_data_viewer(dataset.description())) {
    values.is_unsigned = true;
    note(info, "signed numbers are read as unsigned ones, as BigDataViewer has them");
  }
  for (const char* const range : {"valid_range", "valid_min", "valid_max"})
    if (!numbers_of(dataset.handle(), range).empty())
      note(info, std::string(range) + " is not applied; values beyond it are read as they are");
  auto fill = set_values(info, name, values);
  if (options.holds_labels) fill.reset();
  auto volume = volume_of(name, std::move(info), std::move(dataset), file, layout);
  return fill ? without_fill(std::move(volume), *fill) : std::move(volume);
}

}  // namespace discmc::command

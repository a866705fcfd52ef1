#include "flying_edges.hpp"

#include <vtkCellArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "vtk_image.hpp"

namespace discmc::bench {

using namespace command;

namespace {

// The samples in a shell of one voxel that closes the surface half a voxel outside the volume.
std::vector<float> surrounded(VolumeReader& volume, float level) {
  const auto& dims = volume.info().dims;
  const std::size_t row = dims[0] + 2, slice = row * (dims[1] + 2);
  std::vector<float> all(slice * (dims[2] + 2));
  with_scanner_type(volume.info().type, [&](auto type) {
    std::vector<decltype(type)> samples(std::size_t{dims[0]} * dims[1]);
    for (std::size_t z = 1; z <= dims[2]; ++z) {
      volume.read_slice(samples.data());
      for (std::size_t y = 1; y <= dims[1]; ++y)
        std::copy_n(samples.begin() + static_cast<std::ptrdiff_t>((y - 1) * dims[0]), dims[0],
                    all.begin() + static_cast<std::ptrdiff_t>(z * slice + y * row + 1));
    }
  });
  const auto nearest = [](std::size_t at, std::size_t extent) {
    return std::clamp<std::size_t>(at, 1, extent);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t x = i % row, y = i % slice / row, z = i / slice;
    const std::size_t inside =
        nearest(z, dims[2]) * slice + nearest(y, dims[1]) * row + nearest(x, dims[0]);
    if (inside != i) all[i] = std::min(all[inside], 2 * level - all[inside]);
  }
  return all;
}

// The middle of the edge on which a vertex lies, or of a cell if the vertex is a voxel. at: in
// voxels.
Vertex edge_of(const std::array<double, 3>& at) {
  std::array<int, 3> middle{};
  int fractional = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double voxel = std::floor(at[axis]);
    const bool is_between = at[axis] != voxel;
    middle[axis] = 2 * static_cast<int>(voxel) + (is_between ? 1 : 0);
    fractional += is_between ? 1 : 0;
  }
  return fractional == 1 ? Vertex{middle[0], middle[1], middle[2]} : Vertex{1, 1, 1};
}

}  // namespace

FaceMesh flying_edges(VolumeReader& volume, double level) {
  const VolumeInfo& info = volume.info();
  const std::vector<float> samples = surrounded(volume, static_cast<float>(level));
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(
      image_of(samples, {info.dims[0] + 2, info.dims[1] + 2, info.dims[2] + 2}, -1));
  filter->SetValue(0, level);
  filter->ComputeNormalsOff();
  filter->Update();

  FaceMesh mesh;
  mesh.spacing_mm = info.spacing_mm;
  vtkPolyData& triangles = *filter->GetOutput();
  for (vtkIdType i = 0; i < triangles.GetNumberOfPoints(); ++i) {
    std::array<double, 3> at{};
    triangles.GetPoint(i, at.data());
    mesh.lattice.push_back(edge_of(at));
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] *= info.spacing_mm[axis];
    mesh.vertices_mm.push_back({at[0], at[1], at[2]});
  }
  vtkCellArray& faces = *triangles.GetPolys();
  for (vtkIdType face = 0; face < faces.GetNumberOfCells(); ++face) {
    vtkIdType count;
    const vtkIdType* corners;
    faces.GetCellAtId(face, count, corners);
    for (int i = 0; i < 3; ++i) mesh.corners.push_back(static_cast<std::uint32_t>(corners[i]));
    mesh.face_begin.push_back(mesh.corners.size());
  }
  return mesh;
}

}  // namespace discmc::bench

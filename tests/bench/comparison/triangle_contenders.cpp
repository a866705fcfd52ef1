#include <meshoptimizer.h>
#include <vtkCellArray.h>
#include <vtkDecimatePro.h>
#include <vtkDiscreteFlyingEdges3D.h>
#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#if __has_include(<vtkSurfaceNets3D.h>)
#include <vtkSurfaceNets3D.h>
#define DISCMC_BENCH_SURFACE_NETS
#endif

#include <algorithm>
#include <array>
#include <memory>

#include "../vtk_image.hpp"
#include "contenders.hpp"

namespace discmc::bench {

namespace {

// The maximum distance of merged triangles from their plane. Units: voxels.
constexpr double tolerance = 0.1;

std::array<uint32_t, 3> dims_of(const Volume& volume) {
  return {volume.width, volume.height, volume.depth};
}

template <class Filter>
void make_triangles_alone(Filter& filter) {
  filter.ComputeNormalsOff();
  filter.ComputeGradientsOff();
  filter.ComputeScalarsOff();
}

// Triangles through the middle of edges.
class MidpointTriangles {
 public:
  explicit MidpointTriangles(const Volume& volume) : on_(voxels_on(volume)) {
    filter_->SetInputData(image_of(on_, dims_of(volume)));
    filter_->SetValue(0, 1);
    make_triangles_alone(*filter_);
  }

  vtkDiscreteFlyingEdges3D* filter() { return filter_; }
  vtkPolyData* update() {
    filter_->Modified();
    filter_->Update();
    return filter_->GetOutput();
  }

 private:
  std::vector<uint8_t> on_;
  vtkNew<vtkDiscreteFlyingEdges3D> filter_;
};

std::vector<unsigned> indices_of(vtkPolyData& triangles) {
  vtkTypeInt64Array* const corners = triangles.GetPolys()->GetConnectivityArray64();
  std::vector<unsigned> indices(static_cast<size_t>(corners->GetNumberOfValues()));
  std::transform(corners->Begin(), corners->End(), indices.begin(),
                 [](vtkTypeInt64 index) { return static_cast<unsigned>(index); });
  return indices;
}

// Returns the number of remaining triangles.
uint64_t simplify(vtkPolyData& triangles) {
  if (triangles.GetNumberOfPolys() == 0) return 0;
  std::vector<unsigned> indices = indices_of(triangles);
  const auto* const points =
      static_cast<const float*>(triangles.GetPoints()->GetData()->GetVoidPointer(0));
  const auto vertices = static_cast<size_t>(triangles.GetNumberOfPoints());
  constexpr size_t stride = 3 * sizeof(float);
  const float error =
      static_cast<float>(tolerance) / meshopt_simplifyScale(points, vertices, stride);
  return meshopt_simplify(indices.data(), indices.data(), indices.size(), points, vertices, stride,
                          0, error, 0, nullptr) /
         3;
}

}  // namespace

Contender flying_edges(const Volume& volume) {
  const auto filter = vtkSmartPointer<vtkFlyingEdges3D>::New();
  filter->SetInputData(std::visit(
      [&](const auto& samples) { return image_of(samples, dims_of(volume)); }, volume.samples));
  // Between the samples, so that the same voxels are on and no triangle is empty.
  filter->SetValue(0, volume.threshold - 0.5);
  make_triangles_alone(*filter);
  return {"FlyingEdges3D", "triangles", [filter] {
            filter->Modified();
            filter->Update();
            return static_cast<uint64_t>(filter->GetOutput()->GetNumberOfPolys());
          }};
}

Contender decimated(const Volume& volume) {
  const auto triangles = std::make_shared<MidpointTriangles>(volume);
  const auto decimate = vtkSmartPointer<vtkDecimatePro>::New();
  decimate->SetInputConnection(triangles->filter()->GetOutputPort());
  decimate->SetTargetReduction(1);
  decimate->PreserveTopologyOn();
  decimate->SetErrorIsAbsolute(1);
  decimate->SetAbsoluteError(tolerance);
  return {"DecimatePro", "triangles", [triangles, decimate] {
            triangles->filter()->Modified();
            decimate->Update();
            return static_cast<uint64_t>(decimate->GetOutput()->GetNumberOfPolys());
          }};
}

Contender simplified(const Volume& volume) {
  const auto triangles = std::make_shared<MidpointTriangles>(volume);
  return {"meshoptimizer", "triangles", [triangles] { return simplify(*triangles->update()); }};
}

std::optional<Contender> surface_nets([[maybe_unused]] const Volume& volume) {
#ifdef DISCMC_BENCH_SURFACE_NETS
  const auto on = std::make_shared<std::vector<uint8_t>>(voxels_on(volume));
  const auto filter = vtkSmartPointer<vtkSurfaceNets3D>::New();
  filter->SetInputData(image_of(*on, dims_of(volume)));
  filter->SetValue(0, 1);
  filter->SmoothingOff();
  filter->SetOutputMeshTypeToTriangles();
  return Contender{"SurfaceNets3D", "triangles", [on, filter] {
                     filter->Modified();
                     filter->Update();
                     return static_cast<uint64_t>(filter->GetOutput()->GetNumberOfPolys());
                   }};
#else
  return std::nullopt;
#endif
}

}  // namespace discmc::bench

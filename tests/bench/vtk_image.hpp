// Samples in memory as an image of VTK.
#pragma once

#include <vtkAOSDataArrayTemplate.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstdint>
#include <vector>

namespace discmc::bench {

/// Uses the samples in place; they must outlive the image. first: the position of the first sample
/// along each axis.
template <class Sample>
vtkSmartPointer<vtkImageData> image_of(const std::vector<Sample>& samples,
                                       const std::array<uint32_t, 3>& dims, int first = 0) {
  vtkNew<vtkAOSDataArrayTemplate<Sample>> array;
  constexpr int keep_memory = 1;
  array->SetArray(const_cast<Sample*>(samples.data()), static_cast<vtkIdType>(samples.size()),
                  keep_memory);
  const auto image = vtkSmartPointer<vtkImageData>::New();
  const auto last = [&](size_t axis) { return first + static_cast<int>(dims[axis]) - 1; };
  image->SetExtent(first, last(0), first, last(1), first, last(2));
  image->GetPointData()->SetScalars(array);
  return image;
}

}  // namespace discmc::bench

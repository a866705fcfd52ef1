// A typical program of VTK that writes a mesh file of a volume: FlyingEdges3D, and the STL or PLY
// writer.
// Arguments: FILE TYPE WIDTH HEIGHT DEPTH SX SY SZ ISO OUTPUT THREADS. The file contains only
// samples.
#include <vtkFlyingEdges3D.h>
#include <vtkImageReader2.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkSMPTools.h>
#include <vtkSTLWriter.h>
#include <vtkType.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

template <class Writer>
bool write(vtkFlyingEdges3D& surface, const char* file) {
  vtkNew<Writer> writer;
  writer->SetInputConnection(surface.GetOutputPort());
  writer->SetFileTypeToBinary();
  writer->SetFileName(file);
  return writer->Write() == 1;
}

int main(int argc, char** argv) {
  const std::map<std::string, int> types = {{"u8", VTK_UNSIGNED_CHAR},   {"i8", VTK_SIGNED_CHAR},
                                            {"u16", VTK_UNSIGNED_SHORT}, {"i16", VTK_SHORT},
                                            {"u32", VTK_UNSIGNED_INT},   {"i32", VTK_INT},
                                            {"f32", VTK_FLOAT},          {"f64", VTK_DOUBLE}};
  if (argc != 12 || types.count(argv[2]) == 0) {
    std::fputs("vtk_mesh: FILE TYPE WIDTH HEIGHT DEPTH SX SY SZ ISO OUTPUT THREADS\n", stderr);
    return 2;
  }
  const int threads = std::atoi(argv[11]);
  if (!vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread")) {
    std::fputs("vtk_mesh: VTK has no such backend\n", stderr);
    return 1;
  }
  vtkSMPTools::Initialize(threads);
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName(argv[1]);
  reader->SetFileDimensionality(3);
  reader->SetDataScalarType(types.at(argv[2]));
  reader->SetDataByteOrderToLittleEndian();
  reader->SetDataExtent(0, std::atoi(argv[3]) - 1, 0, std::atoi(argv[4]) - 1, 0,
                        std::atoi(argv[5]) - 1);
  reader->SetDataSpacing(std::atof(argv[6]), std::atof(argv[7]), std::atof(argv[8]));
  vtkNew<vtkFlyingEdges3D> surface;
  surface->SetInputConnection(reader->GetOutputPort());
  surface->SetValue(0, std::atof(argv[9]));
  surface->ComputeNormalsOff();
  surface->ComputeGradientsOff();
  surface->ComputeScalarsOff();
  const std::string file = argv[10];
  const bool is_ply = file.size() > 4 && file.compare(file.size() - 4, 4, ".ply") == 0;
  const bool is_written =
      is_ply ? write<vtkPLYWriter>(*surface, argv[10]) : write<vtkSTLWriter>(*surface, argv[10]);
  return is_written ? 0 : 1;
}

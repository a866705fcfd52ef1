#include "file_mesh.hpp"

#include "volumes/length_unit.hpp"

namespace discmc::command {

void resize(FileMesh& mesh, const MeshSize& size) {
  const double factor = size.scale / millimetres_in(symbol(size.unit)).value();
  for (Point& vertex : mesh.vertices_mm)
    for (double& coordinate : vertex) coordinate *= factor;
  for (double& spacing : mesh.spacing_mm) spacing *= factor;
  mesh.unit = size.unit;
}

const char* symbol(MeshUnit unit) {
  switch (unit) {
    case MeshUnit::millimetre:
      break;
    case MeshUnit::micrometre:
      return "um";
    case MeshUnit::metre:
      return "m";
    case MeshUnit::inch:
      return "inch";
  }
  return "mm";
}

}  // namespace discmc::command

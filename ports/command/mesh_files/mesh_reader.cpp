#include "mesh_reader.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "text/words.hpp"

namespace discmc::command {
namespace {

std::string extension_of(const std::string& file) {
  return lower(std::filesystem::path(file).extension().string());
}

// glTF is in metres with y upwards.
bool is_gltf_name(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".glb" || extension == ".gltf";
}

Point in_mm(const aiVector3D& at, bool is_gltf) {
  const Point point = {static_cast<double>(at.x), static_cast<double>(at.y),
                       static_cast<double>(at.z)};
  return is_gltf ? Point{1000 * point[0], -1000 * point[2], 1000 * point[1]} : point;
}

void add(const aiMesh& part, const std::string& file, bool is_gltf, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices_mm.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& at = part.mVertices[i];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
      throw std::runtime_error(file + ": vertex " + std::to_string(first + i) +
                               " is not finite; export the mesh again");
    mesh.vertices_mm.push_back(in_mm(at, is_gltf));
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no area
    for (unsigned corner = 0; corner < 3; ++corner)
      mesh.corners.push_back(first + face.mIndices[corner]);
    mesh.face_begin.push_back(mesh.corners.size());
  }
}

}  // namespace

Mesh read_mesh(const std::string& file) {
  if (!std::filesystem::exists(file))
    throw std::runtime_error(file + ": there is no such file; check the name");
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr && !importer.IsExtensionSupported(extension_of(file)))
    throw std::runtime_error(file +
                             ": meshes of this format are not read; export it as .ply or .stl");
  if (scene == nullptr)
    throw std::runtime_error(file + ": the file cannot be read as a mesh (" +
                             importer.GetErrorString() + "); export it again as .ply or .stl");
  Mesh mesh;
  const bool is_gltf = is_gltf_name(file);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) add(*scene->mMeshes[i], file, is_gltf, mesh);
  if (mesh.face_count() == 0)
    throw std::runtime_error(file + ": the mesh has no triangle; give a mesh with faces");
  return mesh;
}

}  // namespace discmc::command

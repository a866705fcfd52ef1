#include "mesh_reader.hpp"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "text/words.hpp"

namespace discmc::command {
namespace {

std::string extension_of(const std::string& file) {
  return lower(std::filesystem::path(file).extension().string());
}

// Assimp invents materials for other files.
bool has_materials(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".glb" || extension == ".gltf" || extension == ".obj" || extension == ".3mf";
}

// glTF uses metres with y upwards.
bool is_gltf_name(const std::string& file) {
  const std::string extension = extension_of(file);
  return extension == ".glb" || extension == ".gltf";
}

Point in_mm(const aiVector3D& at, bool is_gltf) {
  const Point point = {static_cast<double>(at.x), static_cast<double>(at.y),
                       static_cast<double>(at.z)};
  return is_gltf ? Point{1000 * point[0], -1000 * point[2], 1000 * point[1]} : point;
}

// Returns the colour that all vertices share, if they do.
std::optional<Srgb> colour_of_vertices(const aiMesh& part) {
  const aiColor4D* colours = part.mColors[0];
  if (colours == nullptr ||
      std::any_of(colours, colours + part.mNumVertices,
                  [colours](const aiColor4D& each) { return each != colours[0]; }))
    return std::nullopt;
  return Srgb{byte_of_share(colours->r), byte_of_share(colours->g), byte_of_share(colours->b)};
}

// Returns nothing for a material that Assimp invented.
std::optional<Srgb> colour_of(const aiMaterial& material, bool is_gltf) {
  aiColor3D colour;
  if (std::string(material.GetName().C_Str()) == AI_DEFAULT_MATERIAL_NAME ||
      material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != AI_SUCCESS)
    return std::nullopt;
  Srgb parts;
  for (unsigned i = 0; i < 3; ++i) {
    const auto part = static_cast<double>(colour[i]);
    parts[i] = byte_of_share(is_gltf ? encoded_light(part) : part);  // glTF uses linear light
  }
  return parts;
}

FileMesh mesh_of(const aiMesh& part, const std::string& file, bool is_gltf) {
  FileMesh mesh;
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& at = part.mVertices[i];
    if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.z))
      throw std::runtime_error(file + ": vertex " + std::to_string(i) +
                               " is not finite; export the mesh again");
    mesh.vertices_mm.push_back(in_mm(at, is_gltf));
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines have no area
    mesh.corners.insert(mesh.corners.end(), face.mIndices, face.mIndices + 3);
    mesh.face_begin.push_back(mesh.corners.size());
  }
  mesh.polygons.resize(mesh.face_count());
  std::iota(mesh.polygons.begin(), mesh.polygons.end(), 0U);
  return mesh;
}

}  // namespace

std::vector<FileMesh> read_meshes(const std::string& file) {
  if (!std::filesystem::exists(file))
    throw std::runtime_error(file + ": there is no such file; check the name");
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr && !importer.IsExtensionSupported(extension_of(file)))
    throw std::runtime_error(
        file + ": meshes of this format are not supported; export it as .ply or .stl");
  if (scene == nullptr)
    throw std::runtime_error(file + ": the file cannot be read as a mesh (" +
                             importer.GetErrorString() + "); export it again as .ply or .stl");
  std::vector<FileMesh> meshes;
  const bool is_gltf = is_gltf_name(file);
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    const aiMesh& part = *scene->mMeshes[i];
    const aiMaterial& material = *scene->mMaterials[part.mMaterialIndex];
    FileMesh mesh = mesh_of(part, file, is_gltf);
    if (mesh.face_count() == 0) continue;
    mesh.colour = colour_of_vertices(part);
    if (has_materials(file)) mesh.colour = colour_of(material, is_gltf);
    if (scene->mNumMeshes > 1) mesh.name = material.GetName().C_Str();
    meshes.push_back(std::move(mesh));
  }
  if (meshes.empty())
    throw std::runtime_error(file + ": the mesh has no triangle; give a mesh with faces");
  return meshes;
}

}  // namespace discmc::command

#include "output_file.hpp"

#include <iostream>
#include <stdexcept>
#include <string>

#include "mesh.hpp"
#include "mesh_files.hpp"

namespace discmc::host {

Format format_of(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  if (path == "-" || extension == ".dmc") return Format::stream;
  if (extension == ".obj") return Format::obj;
  if (extension == ".ply") return Format::ply;
  if (extension == ".stl") return Format::stl;
  if (extension == ".jsonl") return Format::jsonl;
  throw std::invalid_argument(path.string() + ": cannot tell a format from \"" + extension +
                              "\": use .dmc, .obj, .ply, .stl or .jsonl");
}

OutputFile::OutputFile(const std::filesystem::path& path) : path_(path), temporary_(path) {
  if (is_standard_output()) return;
  temporary_ += ".part";
  file_.open(temporary_, std::ios::binary);
  if (!file_)
    throw std::runtime_error(path.string() +
                             ": cannot be written: check the folder and its permissions");
}

OutputFile::~OutputFile() {
  if (is_standard_output() || is_committed_) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

std::ostream& OutputFile::stream() {
  return is_standard_output() ? std::cout : static_cast<std::ostream&>(file_);
}

void OutputFile::commit() {
  stream().flush();
  if (!stream()) throw std::runtime_error(path_.string() + ": writing failed: is the disk full?");
  if (is_standard_output()) return;
  file_.close();
  std::filesystem::rename(temporary_, path_);
  is_committed_ = true;
}

void write_surface(const Surface& surface, Format format, bool conforming, std::ostream& out) {
  const Faces faces = format == Format::stl ? Faces::triangles : Faces::polygons;
  const MeshOptions options{conforming, faces};
  switch (format) {
    case Format::obj:
      return write_obj(build_mesh(surface, options), out);
    case Format::ply:
      return write_ply(build_mesh(surface, options), out);
    case Format::stl:
      return write_stl(build_mesh(surface, options), out);
    case Format::jsonl:
      return write_jsonl(surface, out);
    case Format::stream:
      break;
  }
  throw std::invalid_argument("a stream is not written from a surface");
}

}  // namespace discmc::host

#include "writer.hpp"

#include <stdexcept>

#include "files/write_failure.hpp"

namespace discmc::command {

std::string header_text(const FileMesh& mesh) {
  std::string text = std::string("discmc, ") + names_of(mesh.unit).plural;
  if (mesh.space == Space::lps) text += ", SPACE=LPS";
  if (mesh.space == Space::ras) text += ", SPACE=RAS";
  return text;
}

void require_triangles(const FileMesh& mesh, const std::string& format) {
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    if (mesh.face_size(face) != 3) throw std::invalid_argument(format + " holds triangles only");
}

Meshes with_faces(Meshes meshes) {
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                              [](const FileMesh* mesh) { return mesh->face_count() == 0; }),
               meshes.end());
  return meshes;
}

void Writer::text(std::string_view text) {
  while (!text.empty()) {
    const std::size_t part = std::min(text.size(), full);
    std::memcpy(room_for(part), text.data(), part);
    text.remove_prefix(part);
  }
}

void Writer::make_room(std::size_t count) {
  if (out_ != nullptr)
    flush();
  else
    buffer_.resize(2 * buffer_.size() + count);
}

void Writer::write_through(std::string_view bytes) {
  flush();
  out_->write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!*out_) throw std::runtime_error(write_failure());
}

void Writer::finish() {
  flush();
  out_->flush();
  if (!*out_) throw std::runtime_error(write_failure());
}

void Writer::finish_with_start(std::string_view start) {
  flush();
  out_->seekp(0);
  text(start);
  finish();
}

void Writer::flush() {
  out_->write(buffer_.data(), static_cast<std::streamsize>(used_));
  if (!*out_) throw std::runtime_error(write_failure());
  used_ = 0;
}

}  // namespace discmc::command

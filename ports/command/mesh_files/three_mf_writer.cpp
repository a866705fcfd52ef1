#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>

#include "mesh_files.hpp"
#include "text/name_text.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

la_ssize_t write_to_stream(archive*, void* out, const void* bytes, std::size_t count) {
  auto& stream = *static_cast<std::ostream*>(out);
  stream.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
  return stream ? static_cast<la_ssize_t>(count) : -1;
}

void require_ok(int result) {
  if (result != ARCHIVE_OK) throw std::runtime_error("writing failed");
}

// Writes its bytes to the last begun entry of the archive.
class EntryBuffer : public std::streambuf {
 public:
  explicit EntryBuffer(archive* to) : archive_(to) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    return archive_write_data(archive_, bytes, static_cast<std::size_t>(count));
  }

 private:
  archive* archive_;
};

// A ZIP archive, written from the first byte to the last. All functions that can fail throw
// std::runtime_error.
class ZipFile {
 public:
  // out: outlives this. largest: the maximum size of a file in the archive. Beyond 4 GiB the
  // archive needs the Zip64 extension, which some readers do not support.
  ZipFile(std::ostream& out, std::uint64_t largest)
      : archive_(archive_write_new(), archive_write_free) {
    if (!archive_) throw std::bad_alloc();
    require_ok(archive_write_set_format_zip(archive_.get()));
    if (largest <= 0xFFFFFFFFu)
      require_ok(archive_write_set_format_option(archive_.get(), "zip", "zip64", nullptr));
    require_ok(archive_write_set_bytes_in_last_block(archive_.get(), 1));
    require_ok(archive_write_open(archive_.get(), &out, nullptr, write_to_stream, nullptr));
  }

  // Adds a compressed file with the content that `write` sends to its stream.
  template <class Write>
  void add(const char* name, const Write& write) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                         archive_entry_free);
    if (!entry) throw std::bad_alloc();
    archive_entry_set_pathname(entry.get(), name);
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    require_ok(archive_write_header(archive_.get(), entry.get()));
    EntryBuffer buffer(archive_.get());
    std::ostream stream(&buffer);
    write(stream);
    if (!stream) throw std::runtime_error("writing failed");
    require_ok(archive_write_finish_entry(archive_.get()));
  }

  // Writes the directory. Call it last.
  void finish() { require_ok(archive_write_close(archive_.get())); }

 private:
  std::unique_ptr<archive, int (*)(archive*)> archive_;
};

constexpr const char* content_types =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";

constexpr const char* relationships =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";

// Returns #RRGGBB.
std::string hexadecimal(const Srgb& colour) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (const std::uint8_t part : colour) {
    text += digits[part / 16U];
    text += digits[part % 16U];
  }
  return text;
}

// Writes the names and colours of all meshes that have a colour.
void write_materials(const Meshes& meshes, const std::string& id, Writer& writer) {
  writer.text("<basematerials id=\"" + id + "\">\n");
  for (const FileMesh* mesh : meshes)
    if (mesh->colour)
      writer.text("<base name=\"" + (mesh->name.empty() ? "label" : xml_attribute(mesh->name)) +
                  "\" displaycolor=\"" + hexadecimal(*mesh->colour) + "\"/>\n");
  writer.text("</basematerials>\n");
}

void write_object(const FileMesh& mesh, const std::string& attributes, Writer& writer) {
  writer.text("<object" + attributes + ">\n<mesh>\n<vertices>\n");
  for (const Point& vertex : mesh.vertices_mm) {
    const char* before[] = {"<vertex x=\"", "\" y=\"", "\" z=\""};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      writer.text(before[axis]);
      writer.decimal(vertex[axis]);
    }
    writer.text("\"/>\n");
  }
  writer.text("</vertices>\n<triangles>\n");
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const char* before[] = {"<triangle v1=\"", "\" v2=\"", "\" v3=\""};
    for (std::size_t i = 0; i < 3; ++i) {
      writer.text(before[i]);
      writer.decimal(mesh.face(face)[i]);
    }
    writer.text("\"/>\n");
  }
  writer.text("</triangles>\n</mesh>\n</object>\n");
}

// Objects are numbered from 1; the materials have the next number.
void write_model(const Meshes& meshes, std::ostream& out) {
  Writer writer(out);
  writer.text(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<model unit=\"");
  writer.text(names_of(meshes.empty() ? MeshUnit::millimetre : meshes[0]->unit).word_of_3mf);
  writer.text(
      "\" xml:lang=\"en-US\" "
      "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\">\n"
      "<metadata name=\"Application\">discmc</metadata>\n<metadata name=\"Description\">");
  writer.text(meshes.empty() ? header_text({}) : header_text(*meshes[0]));
  writer.text("</metadata>\n<resources>\n");
  const std::string materials = std::to_string(meshes.size() + 1);
  if (std::any_of(meshes.begin(), meshes.end(),
                  [](const FileMesh* mesh) { return !!mesh->colour; }))
    write_materials(meshes, materials, writer);
  std::size_t number = 0, material = 0;
  std::string items;
  for (const FileMesh* mesh : meshes) {
    const std::string id = std::to_string(++number);
    std::string attributes = " id=\"" + id + "\" type=\"model\"";
    if (!mesh->name.empty()) attributes += " name=\"" + xml_attribute(mesh->name) + "\"";
    if (mesh->colour)
      attributes += " pid=\"" + materials + "\" pindex=\"" + std::to_string(material++) + "\"";
    write_object(*mesh, attributes, writer);
    items += "<item objectid=\"" + id + "\"/>\n";
  }
  writer.text("</resources>\n<build>\n" + items + "</build>\n</model>\n");
  writer.finish();
}

}  // namespace

void write_3mf(const Meshes& meshes, std::ostream& out) {
  // Upper bounds.
  constexpr std::uint64_t vertex_line = 100, triangle_line = 70, other_bytes = 1000;
  constexpr std::uint64_t letter = 12;  // per character of a name, escaped, in both places
  std::uint64_t bytes = other_bytes;
  const Meshes nonempty = with_faces(meshes);  // 3MF allows no object without triangles
  for (const FileMesh* mesh : nonempty) {
    require_triangles(*mesh, "3MF");
    bytes += vertex_line * mesh->vertices_mm.size() + triangle_line * mesh->face_count() +
             letter * mesh->name.size() + other_bytes;
  }
  ZipFile zip(out, bytes);
  zip.add("[Content_Types].xml", [](std::ostream& part) { part << content_types; });
  zip.add("_rels/.rels", [](std::ostream& part) { part << relationships; });
  zip.add("3D/3dmodel.model", [&nonempty](std::ostream& part) { write_model(nonempty, part); });
  zip.finish();
  Writer(out).finish();
}

}  // namespace discmc::command

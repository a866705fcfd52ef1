#include "mesh_files.hpp"
#include "writer.hpp"

namespace discmc::command {
namespace {

void write_vertex(const Vertex& vertex, Writer& writer) {
  writer.text("[");
  writer.decimal(vertex.x);
  writer.text(",");
  writer.decimal(vertex.y);
  writer.text(",");
  writer.decimal(vertex.z);
  writer.text("]");
}

void write_ring(const Ring& ring, Writer& writer) {
  writer.text("[");
  const char* separator = "";
  for (const Vertex& vertex : ring) {
    writer.text(separator);
    write_vertex(vertex, writer);
    separator = ",";
  }
  writer.text("]");
}

}  // namespace

void write_jsonl(const Surface& surface, std::ostream& out) {
  Writer writer(out);
  for (const Polygon& polygon : surface.polygons) {
    writer.text("{\"normal\":");
    write_vertex(incidence_normal(polygon.incidence), writer);
    writer.text(",\"rings\":[");
    const char* separator = "";
    for (const Ring& ring : polygon.rings) {
      writer.text(separator);
      write_ring(ring, writer);
      separator = ",";
    }
    writer.text("]}\n");
  }
  writer.finish();
}

}  // namespace discmc::command

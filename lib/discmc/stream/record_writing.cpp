#include <discmc/stream/record_writing.hpp>

namespace discmc::stream {

namespace {

// About what it costs to tell a vertex relative to the one before: a step in z most of all.
uint32_t cost_of_vertex(const Vertex& vertex, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const int32_t voxels = voxels_between(to, from);
    return static_cast<uint32_t>(voxels < 0 ? -voxels : voxels);
  };
  return 64 * distance(vertex.z, before.z) + 8 * distance(vertex.y, before.y) +
         distance(vertex.x, before.x);
}

}  // namespace

uint32_t closed_runs(const Record& record, uint32_t first) {
  const auto* const steps = plane_steps + first_of_class(class_of(record.incidence));
  uint32_t u = 0, v = 0;  // modulo 2^32
  uint32_t lengths = 0;
  uint32_t end = first;
  for (; end < record.count && record.word[end] != Record::ring_mark; ++end) {
    const Run run = Run::from_code(record.word[end]);
    u += run.length() * static_cast<uint32_t>(steps[run.direction()].u);
    v += run.length() * static_cast<uint32_t>(steps[run.direction()].v);
    lengths |= run.length();
  }
  return (u | v) == 0 && lengths <= max_compact_length ? end - first : 0;
}

RecordKind cheaper_end(const Record& record, const Vertex& before, Vertex& vertex) {
  const Vertex start = record.start_at(0);
  vertex = start;
  for (uint32_t i = Record::ring_words; i < record.count; ++i) {
    Run run = Run::from_code(record.word[i]);
    if (i + 1 == record.count) run = Run::straight(run.direction(), run.length() - 1);
    move(vertex, record.incidence, run.direction(), run.length());
  }
  if (cost_of_vertex(vertex, before) < cost_of_vertex(start, before)) return RecordKind::backwards;
  vertex = start;
  return RecordKind::forwards;
}

}  // namespace discmc::stream

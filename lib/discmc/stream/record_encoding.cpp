#include <discmc/stream/record_encoding.hpp>

namespace discmc {

namespace {

// About what it costs to tell a vertex relative to the one before: a step in z most of all.
uint32_t cost_of_vertex(const Vertex& vertex, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const uint32_t voxels = static_cast<uint32_t>(to >> 1) - static_cast<uint32_t>(from >> 1);
    return voxels < 0U - voxels ? voxels : 0U - voxels;
  };
  return 64 * distance(vertex.z, before.z) + 8 * distance(vertex.y, before.y) +
         distance(vertex.x, before.x);
}

}  // namespace

uint32_t compact_runs(const Record& record, uint32_t first) {
  Vertex way{0, 0, 0};
  uint32_t end = first;
  for (; end < record.count && record.word[end] != Record::ring_mark; ++end) {
    const Run run = Run::from_code(record.word[end]);
    if (run.length() > max_compact_length) return 0;
    move(way, record.incidence, run.direction(), run.length());
  }
  return way == Vertex{0, 0, 0} ? end - first : 0;
}

ChainKind cheaper_end(const Record& record, const Vertex& before, Vertex& vertex) {
  const Vertex start = record.start_at(0);
  vertex = start;
  for (uint32_t i = Record::ring_words; i < record.count; ++i) {
    Run run = Run::from_code(record.word[i]);
    if (i + 1 == record.count) run = Run::straight(run.direction(), run.length() - 1);
    move(vertex, record.incidence, run.direction(), run.length());
  }
  if (cost_of_vertex(vertex, before) < cost_of_vertex(start, before)) return ChainKind::backwards;
  vertex = start;
  return ChainKind::fragment;
}

}  // namespace discmc

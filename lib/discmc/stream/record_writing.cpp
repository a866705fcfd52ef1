#include <discmc/stream/record_writing.hpp>

namespace discmc::detail::stream {

namespace {

// The approximate cost of a vertex relative to the previous one; a step in z costs most.
uint32_t cost_of_vertex(const Vertex& vertex, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const int32_t voxels = (to >> 1) - (from >> 1);
    return static_cast<uint32_t>(voxels < 0 ? -voxels : voxels);
  };
  return 64 * distance(vertex.z, before.z) + 8 * distance(vertex.y, before.y) +
         distance(vertex.x, before.x);
}

}  // namespace

uint32_t closed_runs(const Record& record, uint32_t first) {
  const PlaneStep* const steps = plane_steps_of(class_of(record.incidence));
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

uint32_t corners_of(const uint32_t* runs, uint32_t count, uint32_t directions) {
  if (count - 3 > 1) return 0;
  const uint32_t turns = directions / 2 - 1;
  uint32_t code = 0, sum = 0;
  for (uint32_t i = 3; i > 0; --i) {
    const uint32_t to = runs[i < count ? i : 0];
    const uint32_t turn = turn_between(directions, direction_in(runs[i - 1]), direction_in(to)) - 1;
    if (turn >= turns) return 0;
    code = code * turns + turn;
    sum += turn + 1;
  }
  // The coded turns of four corners are less than a full turn.
  return sum + count > directions + 3 ? 0 : code + 1;
}

bool is_nearer_at_end(const Record& record, const Vertex& before, Vertex& vertex) {
  const Vertex start = record.start_at(0);
  Vertex end = start;
  Run run;
  for (uint32_t i = Record::ring_words; i < record.count; ++i) {
    run = Run::from_code(record.word[i]);
    translate(end, record.incidence, run.direction(), run.length());
  }
  translate(end, record.incidence, run.direction(), 0U - 1);
  const bool is_nearer = cost_of_vertex(end, before) < cost_of_vertex(start, before);
  vertex = is_nearer ? end : start;
  return is_nearer;
}

}  // namespace discmc::detail::stream

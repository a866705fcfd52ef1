#include <discmc/record_encoding.hpp>

namespace discmc {

namespace {

// Goes along a run. Wraps.
void go_along(Vertex& at, Incidence incidence, Run run) {
  const Vertex link = direction_vector(incidence, run.direction());
  const auto go = [run](int32_t& coordinate, int32_t step) {
    const uint32_t way = static_cast<uint32_t>(step) * run.length();
    coordinate = wrapped_sum(coordinate, static_cast<int32_t>(way));
  };
  go(at.x, link.x);
  go(at.y, link.y);
  go(at.z, link.z);
}

// About what it costs to tell a start relative to the one before: a step in z most of all.
uint32_t cost_of_start(const Vertex& start, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const uint32_t steps = static_cast<uint32_t>(to) - static_cast<uint32_t>(from);
    return steps < 0U - steps ? steps : 0U - steps;
  };
  return 64 * distance(start.z, before.z) + 8 * distance(start.y, before.y) +
         distance(start.x, before.x);
}

}  // namespace

uint32_t compact_runs(const Record& record, uint32_t first) {
  Vertex way{0, 0, 0};
  uint32_t end = first;
  for (; end < record.count && record.word[end] != Record::ring_mark; ++end) {
    const Run run = Run::from_code(record.word[end]);
    if (run.length() > max_compact_length) return 0;
    go_along(way, record.incidence, run);
  }
  return way == Vertex{0, 0, 0} ? end - first : 0;
}

Chain cheaper_end(const Record& record, const Vertex& before, Vertex& end) {
  const Vertex start = record.start_at(0);
  end = start;
  for (uint32_t i = Record::ring_words; i < record.count; ++i)
    go_along(end, record.incidence, Run::from_code(record.word[i]));
  if (cost_of_start(end, before) < cost_of_start(start, before)) return Chain::backwards;
  end = start;
  return Chain::fragment;
}

}  // namespace discmc

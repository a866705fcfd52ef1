// Records told to a region model: whole regions and fragments in few decisions, others item by
// item.
#ifndef DISCMC_RECORD_ENCODING_HPP
#define DISCMC_RECORD_ENCODING_HPP

#include <discmc/region_model.hpp>

namespace discmc {

/// How many runs the ring has whose first run is word `first`, when they are short and straight and
/// close it: then its last two lengths follow from the others. 0 when they are not or do not.
inline uint32_t compact_runs(const Record& record, uint32_t first) {
  Vertex way{0, 0, 0};
  uint32_t end = first;
  for (; end < record.count && record.word[end] != Record::ring_mark; ++end) {
    const Run run = Run::from_code(record.word[end]);
    if (run.length() > max_compact_length) return 0;
    way = way + displacement(record.incidence, &run, 1);
  }
  return way == Vertex{0, 0, 0} ? end - first : 0;
}

inline bool are_opposite(Incidence incidence, Run a, Run b) {
  return a.length() == b.length() &&
         link_of(incidence, a.direction()) == opposite_link(link_of(incidence, b.direction()));
}

/// Limit: as compact_runs() counts them.
template <class Model>
void encode_ring(Model& model, Incidence incidence, const uint32_t* runs, uint32_t count) {
  const auto run = [runs](uint32_t index) { return Run::from_code(runs[index]); };
  // As the ring is closed, the other two sides are opposite as well.
  const bool parallelogram = count == 4 && are_opposite(incidence, run(0), run(2));
  if (!model.parallelogram(parallelogram)) model.run_count(count);
  const uint32_t directions = parallelogram ? 2 : count;
  for (uint32_t i = 0; i < directions; ++i) {
    model.direction(run(i).direction());
    if (i + 2 < count) model.length(run(i).length());
  }
  if (!parallelogram && model.is_parallel()) model.length(run(count - 2).length());
}

template <class Model>
void encode_start(Model& model, const Record& record, uint32_t mark) {
  model.start(record.start_at(mark), mark > 0 || record.continues ? Chain::further : Chain::first);
}

/// A whole region of closed rings, in as few decisions as they take. False, with only some of it
/// told, when the record is anything else.
template <class Model>
bool encode_region(Model& model, const Record& record) {
  if (record.continues || record.rings == 0 || record.word[0] != Record::ring_mark) return false;
  model.record_kind(RecordKind::region);
  model.incidence(record.incidence);
  model.ring_count(record.rings);
  for (uint32_t mark = 0; mark < record.count;) {
    const uint32_t first = mark + Record::ring_words;
    const uint32_t count = compact_runs(record, first);
    if (count == 0) return false;
    encode_start(model, record, mark);
    encode_ring(model, record.incidence, record.word + first, count);
    mark = first + count;
  }
  return true;
}

/// About what it costs to tell a vertex relative to the one before: a step in z most of all.
inline uint32_t cost_of_vertex(const Vertex& vertex, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const uint32_t voxels = static_cast<uint32_t>(to >> 1) - static_cast<uint32_t>(from >> 1);
    return voxels < 0U - voxels ? voxels : 0U - voxels;
  };
  return 64 * distance(vertex.z, before.z) + 8 * distance(vertex.y, before.y) +
         distance(vertex.x, before.x);
}

/// A whole loose fragment, told from the end that costs less: the one where the sweep is. False,
/// with nothing told, when the record is a part or has no run.
template <class Model>
bool encode_fragment(Model& model, const Record& record) {
  if (record.continues || record.count == Record::ring_words) return false;
  const uint32_t* const runs = record.word + Record::ring_words;
  const uint32_t count = record.count - Record::ring_words;
  const auto run = [runs](uint32_t index) { return Run::from_code(runs[index]); };
  const Vertex start = record.start_at(0);
  Vertex last_link{0, 0, 0};
  Vertex end = start;
  for (uint32_t i = 0; i < count; ++i) {
    last_link = direction_vector(record.incidence, run(i).direction());
    end = after_links(end, last_link, run(i).length());
  }
  const Vertex before_end = after_links(end, -last_link, 1);
  const Vertex& before = model.last_start();
  const bool from_end = cost_of_vertex(before_end, before) < cost_of_vertex(start, before);
  model.record_kind(RecordKind::fragment);
  model.incidence(record.incidence);
  model.order(from_end ? Chain::backwards : Chain::fragment);
  for (uint32_t i = 0; i <= count; ++i) {
    const uint32_t link = from_end ? count - i : i;
    model.direction(link == 0 ? record.came : run(link - 1).direction());
    if (i == 0)
      model.fragment_vertex(from_end ? before_end : start);
    else
      model.is_last_link(i == count);
    if (link > 0) model.length(run(link - 1).length());
  }
  return true;
}

/// One item of a part. Returns how many words it takes.
template <class Model>
uint32_t encode_item(Model& model, const Record& record, uint32_t index) {
  if (record.word[index] == Record::ring_mark) {
    model.item_kind(Item::ring);
    encode_start(model, record, index);
    return Record::ring_words;
  }
  const Run run = Run::from_code(record.word[index]);
  model.item_kind(Item::run);
  model.direction(run.direction());
  model.length(run.length());
  return 1;
}

}  // namespace discmc

#endif

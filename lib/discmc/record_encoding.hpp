// Records told to a region model: whole regions in few decisions, anything else item by item.
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
    if (run.length() > max_compact_length) return 0;  // a stand-in looks longer than any run
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
  model.start(record.start_at(mark), mark > 0 || record.continues);
}

/// A whole region of closed rings, in as few decisions as they take. False, with only some of it
/// told, when the record is anything else.
template <class Model>
bool encode_region(Model& model, const Record& record) {
  if (record.continues || record.rings == 0 || record.word[0] != Record::ring_mark) return false;
  model.region_follows(true);
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

/// Begins a record that is no whole region.
template <class Model>
void encode_kind(Model& model, OtherKind kind) {
  model.region_follows(false);
  model.other_kind(kind);
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
  if (run.is_fragment()) {
    model.item_kind(Item::fragment);
    model.fragment_number(run.fragment_number(), true);
  } else {
    model.item_kind(Item::run);
    model.direction(run.direction());
    model.length(run.length());
  }
  return 1;
}

}  // namespace discmc

#endif

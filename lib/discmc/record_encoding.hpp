// Records told to a region model: whole regions and fragments in few decisions, others item by
// item.
#ifndef DISCMC_RECORD_ENCODING_HPP
#define DISCMC_RECORD_ENCODING_HPP

#include <discmc/region_model.hpp>

namespace discmc {

/// How many runs the ring has whose first run is word `first`, when they are short and straight and
/// close it: then its last two lengths follow from the others. 0 when they are not or do not.
uint32_t compact_runs(const Record& record, uint32_t first);

/// From which end a whole fragment is told: the one that costs less after the vertex `before`.
/// Returns Chain::fragment or Chain::backwards, and that end.
Chain cheaper_end(const Record& record, const Vertex& before, Vertex& end);

constexpr bool are_opposite(Incidence incidence, Run a, Run b) {
  const int turn = a.direction() - b.direction();
  return a.length() == b.length() && 2 * (turn < 0 ? -turn : turn) == direction_count(incidence);
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

/// A run of a record, its direction first.
template <class Model>
void encode_run(Model& model, uint32_t word) {
  const Run run = Run::from_code(word);
  model.direction(run.direction());
  model.length(run.length());
}

/// A whole loose fragment, told from the end that costs less: the one where the sweep is. False,
/// with nothing told, when the record is a part or has no run.
template <class Model>
bool encode_fragment(Model& model, const Record& record) {
  constexpr uint32_t first = Record::ring_words;
  if (record.continues || record.count == first) return false;
  Vertex end;
  const Chain chain = cheaper_end(record, model.last_start(), end);
  model.record_kind(RecordKind::fragment);
  model.incidence(record.incidence);
  model.order(chain);
  model.start(end, chain);
  model.fragment_run_count(record.count - first);
  if (chain == Chain::fragment) {
    model.direction(record.came);
    for (uint32_t i = first; i < record.count; ++i) encode_run(model, record.word[i]);
  } else {
    for (uint32_t i = record.count; i-- > first;) encode_run(model, record.word[i]);
    model.direction(record.came);
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
  model.item_kind(Item::run);
  encode_run(model, record.word[index]);
  return 1;
}

}  // namespace discmc

#endif

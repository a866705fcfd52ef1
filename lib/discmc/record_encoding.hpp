// Records told to a region model: whole regions in few decisions, anything else item by item.
#ifndef DISCMC_RECORD_ENCODING_HPP
#define DISCMC_RECORD_ENCODING_HPP

#include <discmc/region_model.hpp>

namespace discmc {

inline Run run_at(const Record& record, uint32_t index) {
  return Run::from_code(record.word[index]);
}

inline uint32_t runs_after(const Record& record, uint32_t mark) {
  uint32_t end = mark + Record::ring_words;
  while (end < record.count && record.word[end] != Record::ring_mark) ++end;
  return end - mark - Record::ring_words;
}

inline bool is_opposite(Incidence incidence, Run a, Run b) {
  return a.length() == b.length() && opposite_direction(incidence, a.direction()) == b.direction();
}

inline bool is_parallelogram(const Record& record, uint32_t first, uint32_t count) {
  return count == 4 &&
         is_opposite(record.incidence, run_at(record, first), run_at(record, first + 2)) &&
         is_opposite(record.incidence, run_at(record, first + 1), run_at(record, first + 3));
}

/// Whether encode_region() can tell the record: a whole region of closed chains, all runs short and
/// straight. Then the last two lengths of each follow from the others.
inline bool is_compact(const Record& record) {
  if (record.is_fragment || record.continues) return false;
  if (record.count == 0 || record.word[0] != Record::ring_mark) return false;
  for (uint32_t i = 0; i < record.count;) {
    const uint32_t first = i + Record::ring_words;
    Vertex way{0, 0, 0};
    for (i = first; i < record.count && record.word[i] != Record::ring_mark; ++i) {
      const Run run = run_at(record, i);
      if (run.is_fragment() || run.length() > max_compact_length) return false;
      way = way + displacement(record.incidence, &run, 1);
    }
    if (i < first + 2 || way != Vertex{0, 0, 0}) return false;
  }
  return true;
}

template <class Model>
void encode_ring(Model& model, const Record& record, uint32_t first, uint32_t count) {
  const bool parallelogram = is_parallelogram(record, first, count);
  if (!model.parallelogram(parallelogram)) model.run_count(count);
  const uint32_t directions = parallelogram ? 2 : count;
  const uint32_t lengths = parallelogram ? 2 : count - 2;
  for (uint32_t i = 0; i < directions; ++i) {
    model.direction(run_at(record, first + i).direction());
    if (i < lengths) model.length(run_at(record, first + i).length());
  }
  if (parallelogram) return;
  const Run last_but_one = run_at(record, first + count - 2);
  const Run last = run_at(record, first + count - 1);
  if (are_parallel(record.incidence, last_but_one.direction(), last.direction()))
    model.length(last_but_one.length());
}

/// Limit: is_compact(record).
template <class Model>
void encode_region(Model& model, const Record& record) {
  uint32_t rings = 0;
  for (uint32_t mark = 0; mark < record.count;
       mark += Record::ring_words + runs_after(record, mark))
    ++rings;
  model.region_follows(true);
  model.incidence(record.incidence);
  model.ring_count(rings);
  for (uint32_t mark = 0; mark < record.count;) {
    const uint32_t count = runs_after(record, mark);
    model.start(record.start_at(mark), mark > 0);
    encode_ring(model, record, mark + Record::ring_words, count);
    mark += Record::ring_words + count;
  }
}

/// One item of a part. Returns how many words it takes.
template <class Model>
uint32_t encode_item(Model& model, const Record& record, uint32_t index) {
  if (record.word[index] == Record::ring_mark) {
    model.item_kind(Item::ring);
    model.start(record.start_at(index), index > 0 || record.continues);
    return Record::ring_words;
  }
  const Run run = run_at(record, index);
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

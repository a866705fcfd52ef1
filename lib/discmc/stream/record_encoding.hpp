// Records told to a region model: whole regions and fragments in few decisions, others item by
// item.
#ifndef DISCMC_STREAM_RECORD_ENCODING_HPP
#define DISCMC_STREAM_RECORD_ENCODING_HPP

#include <discmc/compiler.hpp>
#include <discmc/stream/region_model.hpp>

namespace discmc {

/// How many runs the ring has whose first run is word `first`, when they are short and straight and
/// close it: then its last two lengths follow from the others. 0 when they are not or do not.
uint32_t compact_runs(const Record& record, uint32_t first);

/// From which end a whole fragment is told: the one that costs less after the vertex `before`.
/// Returns ChainKind::fragment and its start, or ChainKind::backwards and the vertex before its
/// end.
ChainKind cheaper_end(const Record& record, const Vertex& before, Vertex& vertex);

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
  model.start(record.start_at(mark),
              mark > 0 || record.continues ? ChainKind::further : ChainKind::first);
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

/// A whole loose fragment, link by link, from the end that costs less: the one where the sweep is.
/// False, with nothing told, when the record is a part or has no run.
template <class Model>
bool encode_fragment(Model& model, const Record& record) {
  constexpr uint32_t first = Record::ring_words;
  if (record.continues || record.count == first) return false;
  Vertex vertex;
  const ChainKind order = cheaper_end(record, model.last_start(), vertex);
  model.record_kind(RecordKind::fragment);
  model.incidence(record.incidence);
  model.order(order);
  // The link by which the chain comes to its start is told like a run, but for its length.
  const uint32_t runs = record.count - first;
  for (uint32_t i = 0; i <= runs; ++i) {
    const uint32_t link = order == ChainKind::backwards ? runs - i : i;
    const Run run = link == 0 ? Run::straight(record.incoming, 0)
                              : Run::from_code(record.word[first + link - 1]);
    model.direction(run.direction());
    if (i == 0)
      model.fragment_vertex(vertex);
    else
      model.is_last_link(i == runs);
    if (link > 0) model.length(run.length());
  }
  return true;
}

/// A record as a whole. False as the two above say.
template <class Model>
bool encode_record(Model& model, const Record& record) {
  return record.is_fragment ? encode_fragment(model, record) : encode_region(model, record);
}

/// The same for a host, with all that it calls in one function: 20 KiB, and a tenth faster.
template <class Model>
DISCMC_FLATTEN bool encode_record_in_place(Model& model, const Record& record) {
  return encode_record(model, record);
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
  const Run run = Run::from_code(record.word[index]);
  model.direction(run.direction());
  model.length(run.length());
  return 1;
}

}  // namespace discmc

#endif

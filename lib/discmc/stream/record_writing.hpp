// Records told to a model: whole regions and fragments in few symbols, what is longer in parts.
#ifndef DISCMC_STREAM_RECORD_WRITING_HPP
#define DISCMC_STREAM_RECORD_WRITING_HPP

#include <discmc/compiler.hpp>
#include <discmc/stream/record_model.hpp>

namespace discmc::stream {

/// How many runs the ring has whose first run is word `first`, when they are short and close it:
/// then its last two lengths follow from the others. 0 when they are not or do not.
uint32_t closed_runs(const Record& record, uint32_t first);

/// From which end a whole fragment is told: the one that costs less after the vertex `before`.
/// Returns RecordKind::forwards and its start, or backwards and the vertex before its end.
RecordKind cheaper_end(const Record& record, const Vertex& before, Vertex& vertex);

/// A ring of three or four corners that turns left at each, by less than a half turn: the turns at
/// its second, third and last corner, to the base of the class, and that to its first direction.
struct Corners {
  uint32_t code;  ///< 0 for any other ring
  uint32_t closing;
  bool is_parallelogram;
};

inline Corners corners_of(const uint32_t* runs, uint32_t count, uint32_t link_class,
                          uint32_t first_back) {
  constexpr Corners other{0, 4, false};
  if (count - 3 > 1) return other;
  const uint32_t directions = 4 + 2 * link_class;
  const uint32_t first = Run::from_code(runs[0]).direction();
  const auto turn = [&](uint32_t from, uint32_t to) {
    return to - from + (to < from ? directions : 0);
  };
  uint32_t from = first;
  uint32_t code = 0;
  uint32_t place = 1;
  uint32_t turns[4];
  for (uint32_t i = 0; i < 4; ++i) {
    const uint32_t to = i + 1 < count ? Run::from_code(runs[i + 1]).direction() : first;
    turns[i] = turn(from, to);
    from = to;
    if (i == 3) break;
    if (turns[i] - 1 > link_class) return other;
    code += place * (turns[i] - 1);
    place *= link_class + 1;
  }
  const uint32_t closing = count == 3 ? turns[2] : turns[3];
  const uint32_t back = turn(first_back == directions ? 0 : first_back, first);
  if (back >= closing) return other;
  return {link_class == 0 ? 1 : code, closing, count == 4 && turns[0] == turns[2]};
}

/// Limit: as closed_runs() counts them.
template <class Model>
void encode_ring(Model& model, Incidence incidence, const uint32_t* runs, uint32_t count) {
  const auto run = [runs](uint32_t index) { return Run::from_code(runs[index]); };
  const Corners corners = corners_of(runs, count, model.link_class(), first_back(incidence));
  if (model.corners(corners.code) == 0) model.run_count(count);
  model.ring_direction(run(0).direction(), corners.closing);
  if (corners.code == 0) {
    if (count > 2) model.length(run(0).length());
    for (uint32_t i = 1; i < count; ++i) {
      if (i + 2 < count)
        model.run(run(i));
      else
        model.last_direction(run(i).direction());
    }
    const Run before_last = run(count - 2);
    if (are_parallel(model.direction_count(), before_last.direction(), run(count - 1).direction()))
      model.length(before_last.length());
    return;
  }
  if (count == 3) {
    model.length(run(0).length());
    return;
  }
  const auto short_length = [&](uint32_t i) {
    const uint32_t length = run(i).length();
    return length < 4 ? length - 1 : 3;
  };
  model.two_lengths(corners.is_parallelogram, 4 * short_length(0) + short_length(1));
  for (uint32_t i = 0; i < 2; ++i) {
    model.set_direction(run(i).direction());
    if (run(i).length() > 3) model.longer(run(i).length() - 3);
  }
}

/// A whole region of closed rings, in as few symbols as they take. False, with only some of it
/// told, when the record is anything else.
template <class Model>
bool encode_region(Model& model, const Record& record) {
  if (record.continues || record.rings == 0 || record.word[0] != Record::ring_mark) return false;
  model.record_kind(record.rings == 1 ? RecordKind::region : RecordKind::holed);
  for (uint32_t mark = 0; mark < record.count;) {
    const uint32_t first = mark + Record::ring_words;
    const uint32_t count = closed_runs(record, first);
    if (count == 0) return false;
    model.start(record.start_at(mark), false);
    if (mark == 0) {
      model.incidence(record.incidence);
      if (record.rings > 1) model.plain_number(record.rings - 2);
    }
    encode_ring(model, record.incidence, record.word + first, count);
    mark = first + count;
  }
  return true;
}

/// The runs of a fragment or a part, from `first` to before `end`.
template <class Model>
void encode_runs(Model& model, const Record& record, uint32_t first, uint32_t end,
                 RecordKind kind) {
  const bool is_backwards = kind == RecordKind::backwards;
  for (uint32_t i = first; i < end; ++i) {
    const Run run = Run::from_code(record.word[is_backwards ? first + end - 1 - i : i]);
    if (i > first) {
      model.run(run);
    } else {
      if (is_backwards)
        model.cut_direction(run.direction());
      else if (kind == RecordKind::forwards)
        model.cut_turn(run.direction());
      else
        model.plain_direction(run.direction());
      model.length(run.length());
    }
    model.is_last_run(i + 1 == end);
  }
}

/// A whole loose fragment, from the end that costs less: the one where the sweep is. False, with
/// nothing told, when the record is a part or has no run.
template <class Model>
bool encode_fragment(Model& model, const Record& record) {
  constexpr uint32_t first = Record::ring_words;
  if (record.continues || record.count == first) return false;
  Vertex vertex;
  const RecordKind kind = cheaper_end(record, model.last_start(), vertex);
  model.record_kind(kind);
  model.start(vertex, true);
  model.incidence(record.incidence);
  if (kind == RecordKind::forwards) model.cut_direction(record.incoming);
  encode_runs(model, record, first, record.count, kind);
  if (kind == RecordKind::backwards) model.cut_turn(record.incoming);
  return true;
}

/// A record as a whole. False as the two above say.
template <class Model>
bool encode_record(Model& model, const Record& record) {
  return record.is_fragment ? encode_fragment(model, record) : encode_region(model, record);
}

/// The same for a host, with all that it calls in one function.
template <class Model>
DISCMC_FLATTEN bool encode_record_in_place(Model& model, const Record& record) {
  return encode_record(model, record);
}

/// The first words of a record, all of one ring, as a part.
template <class Model>
void encode_part(Model& model, Record& record, uint32_t words) {
  model.record_kind(RecordKind::part);
  const bool begins_ring = model.part(record, record.word[0] == Record::ring_mark);
  if (begins_ring) model.start(record.start_at(0), record.is_fragment);
  encode_runs(model, record, begins_ring ? Record::ring_words : 0, words, RecordKind::part);
}

}  // namespace discmc::stream

#endif

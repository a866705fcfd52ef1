// Writes records: whole regions and fragments in few symbols, longer records in parts.
#ifndef DISCMC_STREAM_RECORD_WRITING_HPP
#define DISCMC_STREAM_RECORD_WRITING_HPP

#include <discmc/base/compiler.hpp>
#include <discmc/stream/record_model.hpp>

namespace discmc::detail::stream {

constexpr Direction direction_in(uint32_t run) {
  return Run::from_code(run).direction();
}
constexpr uint32_t length_in(uint32_t run) {
  return Run::from_code(run).length();
}

/// The number of runs of the ring whose first run is word `first`, if they are short and close the
/// ring. Then its last two lengths follow from the others. Otherwise 0.
DISCMC_NOINLINE inline uint32_t closed_runs(const Record& record, uint32_t first) {
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

/// The symbol of a ring of three or four corners, if each is a left turn of less than half a turn.
/// Its digits are the turns at the second, third and last corner. 0 for any other ring.
DISCMC_NOINLINE inline uint32_t corners_of(const uint32_t* runs, uint32_t count,
                                           uint32_t directions) {
  if (count - 3 > 1) return 0;
  const uint32_t base = directions / 2 - 1;
  uint32_t code = 0, sum = 0;
  for (uint32_t i = 3; i > 0; --i) {
    const uint32_t next_run = runs[i < count ? i : 0];
    const uint32_t turn =
        turn_between(directions, direction_in(runs[i - 1]), direction_in(next_run)) - 1;
    if (turn >= base) return 0;
    code = code * base + turn;
    sum += turn + 1;
  }
  // The coded turns of four corners are less than a full turn.
  return sum + count > directions + 3 ? 0 : code + 1;
}

/// The approximate cost of a vertex relative to the previous one; a step in z costs most.
inline uint32_t cost_of_vertex(const Vertex& vertex, const Vertex& before) {
  const auto distance = [](int32_t to, int32_t from) {
    const int32_t voxels = (to >> 1) - (from >> 1);
    return static_cast<uint32_t>(voxels < 0 ? -voxels : voxels);
  };
  return 64 * distance(vertex.z, before.z) + 8 * distance(vertex.y, before.y) +
         distance(vertex.x, before.x);
}

/// Whether coding a whole fragment from its end costs less, after the vertex `before`. vertex: set
/// to the vertex before the end, or else to the start.
inline bool is_nearer_at_end(const Record& record, const Vertex& before, Vertex& vertex) {
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

/// Encodes runs one after the other up to the last one, after the direction of the first. run: the
/// run coded first.
template <class Model>
void encode_runs(Model& model, const uint32_t* run, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    const Run next = Run::from_code(*run);
    run += model.is_backwards() ? -1 : 1;
    if (i == 0)
      model.length(contexts::lengths, next.direction(), next.length());
    else
      model.run(next);
    model.is_last_run(i + 1 == count);
  }
}

/// Limit: the runs are as closed_runs() counts them.
template <class Model>
void encode_ring(Model& model, Incidence incidence, const uint32_t* runs, uint32_t count) {
  const Direction first = direction_in(runs[0]);
  const uint32_t corners = corners_of(runs, count, model.directions());
  model.corners(corners);
  model.ring_direction(turn_between(model.directions(), first_back(incidence), first));
  model.begin_chain(first);
  if (corners == 0) {
    encode_runs(model, runs, count - 1);  // the last run leads back to the start
  } else if (count == 3) {
    model.length(contexts::lengths, first, length_in(runs[0]));
  } else {
    uint32_t lengths = 0;
    for (uint32_t i = 0; i < 2; ++i)
      lengths = 4 * lengths + (length_in(runs[i]) < 4 ? length_in(runs[i]) - 1 : 3);
    model.two_lengths(lengths);
    for (uint32_t i = 0; i < 2; ++i)
      if (length_in(runs[i]) > 3)
        model.length(contexts::longer, direction_in(runs[i]), length_in(runs[i]) - 3);
  }
}

/// Encodes a whole region of closed rings in few symbols. Returns false if the record is anything
/// else; then some symbols may have been written.
template <class Model>
bool encode_region(Model& model, const Record& record) {
  if (record.continues || record.rings == 0 || record.word[0] != Record::ring_mark) return false;
  model.record_kind(record.rings == 1 ? RecordKind::region : RecordKind::holed);
  for (uint32_t mark = 0; mark < record.count;) {
    const uint32_t first = mark + Record::ring_words;
    const uint32_t count = closed_runs(record, first);
    if (count == 0) return false;
    model.start(record.start_at(mark));
    if (mark == 0) {
      model.incidence(record.incidence);
      if (record.rings > 1) model.plain_number(record.rings - 2);
    }
    encode_ring(model, record.incidence, record.word + first, count);
    mark = first + count;
  }
  return true;
}

/// Encodes a whole loose fragment from the end that costs less, which is the one near the sweep.
/// False, with nothing written, if the record is a part or has no run.
template <class Model>
bool encode_fragment(Model& model, const Record& record) {
  constexpr uint32_t first = Record::ring_words;
  if (record.continues || record.count == first) return false;
  Vertex vertex;
  const bool is_backwards = is_nearer_at_end(record, model.last_start(), vertex);
  model.record_kind(is_backwards ? RecordKind::backwards : RecordKind::forwards);
  model.start(vertex);
  model.incidence(record.incidence);
  const uint32_t* const run = record.word + (is_backwards ? record.count - 1 : first);
  if (!is_backwards) model.chain_direction(record.incoming);
  model.chain_direction(direction_in(*run));
  encode_runs(model, run, record.count - first);
  if (is_backwards) model.chain_direction(record.incoming);
  return true;
}

/// Encodes a whole record. Returns false like the two functions above.
template <class Model>
bool encode_record(Model& model, const Record& record) {
  return record.is_fragment ? encode_fragment(model, record) : encode_region(model, record);
}

/// As above for a host, with all called functions inlined.
template <class Model>
DISCMC_FLATTEN bool encode_record_in_place(Model& model, const Record& record) {
  Model copy = model;  // in registers
  const bool is_whole = encode_record(copy, record);
  model = copy;
  return is_whole;
}

/// Encodes the first words of a record, all of one ring, as a part.
template <class Model>
void encode_part(Model& model, Record& record, uint32_t words) {
  model.record_kind(RecordKind::part);
  const bool begins_ring = words > 0 && record.word[0] == Record::ring_mark;
  const uint32_t first = begins_ring ? Record::ring_words : 0;
  if (words == first) {  // A part without a run is invalid: decoders reject this one.
    model.raw_bits(4, 15);
    return;
  }
  model.part(record, begins_ring);
  if (begins_ring) model.start(record.start_at(0));
  if (record.is_fragment && !record.continues) model.chain_direction(record.incoming);
  model.chain_direction(direction_in(record.word[first]));
  encode_runs(model, record.word + first, words - first);
}

}  // namespace discmc::detail::stream

#endif

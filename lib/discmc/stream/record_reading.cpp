#include <discmc/stream/record_reading.hpp>

namespace discmc::detail::stream {

namespace {

constexpr Vertex no_vertex{0, 0, 0};

bool is_length(int32_t value) {
  return value >= 1 && value <= static_cast<int32_t>(max_compact_length);
}

// Reads the first direction of a ring; none if the plane does not have it.
Direction read_ring_direction(ReadingModel& model, Incidence incidence) {
  const uint32_t offset = model.ring_direction(0);
  if (offset >= model.directions()) return no_direction;
  const uint32_t direction = first_back(incidence) + offset;
  const auto first = static_cast<Direction>(
      direction < model.directions() ? direction : direction - model.directions());
  model.begin_chain(first);
  return first;
}

// Reads runs up to the last one, after the direction of the first.
bool read_runs(ReadingModel& model, Record& record, Direction first, uint32_t max_length) {
  const uint32_t length = model.length(contexts::lengths, first, 1);
  Run run = length <= max_length ? Run::straight(first, length) : Run();
  for (;;) {
    if (!record.has_room(1) || run.length() - 1 >= max_length) return false;
    record.add_run(run);
    if (model.is_last_run(false)) return true;
    run = model.run(run);
  }
}

// Returns the vector from the end of the runs back to their start, in steps of their plane.
PlaneVector vector_back(const Record& record, uint32_t first, const PlaneStep* steps) {
  PlaneVector vector{0, 0};
  for (uint32_t i = first; i < record.count; ++i) {
    const Run run = Run::from_code(record.word[i]);
    vector.u -= static_cast<int32_t>(run.length()) * steps[run.direction()].u;
    vector.v -= static_cast<int32_t>(run.length()) * steps[run.direction()].v;
  }
  return vector;
}

// Reads a ring of three or four corners from its turns. The last two lengths follow from the
// others.
bool read_corners(ReadingModel& model, Record& record, uint32_t code) {
  const uint32_t directions = model.directions();
  const uint32_t base = model.incidence_class() + 1;
  const uint32_t turns[] = {1 + code % base, 1 + code / base % base, 1 + code / base / base};
  const uint32_t sum = turns[0] + turns[1] + turns[2];
  const uint32_t coded_lengths = sum == directions ? 1 : 2;  // lengths of three runs, or of four
  const uint32_t first = read_ring_direction(model, record.incidence);
  if (first == no_direction || !record.has_room(coded_lengths + 2)) return false;
  Direction direction[4] = {static_cast<Direction>(first)};
  for (uint32_t i = 0; i < 3; ++i) {
    const uint32_t next = direction[i] + turns[i];
    direction[i + 1] = static_cast<Direction>(next < directions ? next : next - directions);
  }
  uint32_t lengths[2];
  if (coded_lengths == 1) {
    lengths[0] = model.length(contexts::lengths, direction[0], 1);
  } else {
    const uint32_t length_pair = model.two_lengths(0);
    lengths[0] = 1 + length_pair / 4;
    lengths[1] = 1 + length_pair % 4;
    for (uint32_t i = 0; i < 2; ++i)
      if (lengths[i] == 4) lengths[i] = 3 + model.length(contexts::longer, direction[i], 1);
  }
  const uint32_t begin = record.count;
  for (uint32_t i = 0; i < coded_lengths; ++i) {
    if (lengths[i] - 1 >= max_compact_length) return false;
    record.add_run(Run::straight(direction[i], lengths[i]));
  }
  const PlaneStep* const steps = plane_steps_of(model.incidence_class());
  const Closure closure =
      close_ring(steps[direction[coded_lengths]], steps[direction[coded_lengths + 1]],
                 vector_back(record, begin, steps));
  record.add_run(Run::straight(direction[coded_lengths], closure.first));
  record.add_run(Run::straight(direction[coded_lengths + 1], closure.second));
  return closure.is_valid;
}

// Reads a ring run by run; the last run leads back to the start.
bool read_long_ring(ReadingModel& model, Record& record) {
  const uint32_t begin = record.count;
  const Direction first = read_ring_direction(model, record.incidence);
  if (first == no_direction || !read_runs(model, record, first, max_compact_length)) return false;
  if (!record.has_room(1)) return false;
  const PlaneStep* const steps = plane_steps_of(model.incidence_class());
  const Run last = run_along(steps, model.directions(), vector_back(record, begin, steps));
  record.add_run(last);
  return !last.is_empty();
}

bool read_ring(ReadingModel& model, Record& record) {
  const uint32_t corners = model.corners(0);
  return corners == 0 ? read_long_ring(model, record) : read_corners(model, record, corners - 1);
}

}  // namespace

// Uses Cramer's rule.
Closure close_ring(PlaneStep a, PlaneStep b, PlaneVector vector) {
  const int32_t area = a.u * b.v - a.v * b.u;
  const int32_t first = vector.u * b.v - vector.v * b.u;
  const int32_t second = a.u * vector.v - a.v * vector.u;
  if (first % area != 0 || second % area != 0) return {};
  if (!is_length(first / area) || !is_length(second / area)) return {};
  return {true, static_cast<uint32_t>(first / area), static_cast<uint32_t>(second / area)};
}

Run run_along(const PlaneStep* steps, uint32_t directions, PlaneVector vector) {
  for (uint32_t d = 0; d < directions; ++d) {
    const PlaneStep step = steps[d];
    const int32_t length = step.u != 0 ? vector.u / step.u : vector.v / step.v;
    if (is_length(length) && length * step.u == vector.u && length * step.v == vector.v)
      return Run::straight(static_cast<Direction>(d), static_cast<uint32_t>(length));
  }
  return {};
}

bool read_region(ReadingModel& model, Record& record, RecordKind kind) {
  uint32_t rings = 1;
  for (uint32_t ring = 0; ring < rings; ++ring) {
    const Vertex start = model.start(no_vertex);
    if (ring == 0) {
      const Incidence incidence = model.incidence(no_incidence);
      if (!is_incidence(incidence)) return false;
      record.begin(incidence);
      record.is_last = true;
      if (kind == RecordKind::holed) rings = 2 + model.plain_number(0);
    }
    if (!record.has_room(Record::ring_words)) return false;
    record.add_ring(start);
    if (!read_ring(model, record)) return false;
  }
  return true;
}

// The link that leads to the start of the fragment is coded first; for a fragment coded backwards,
// last.
bool read_fragment(ReadingModel& model, Record& record, RecordKind kind) {
  const bool is_backwards = kind == RecordKind::backwards;
  Vertex start = model.start(no_vertex);
  const Incidence incidence = model.incidence(no_incidence);
  if (!is_incidence(incidence)) return false;
  record.begin(incidence);
  record.begin_fragment(0, no_vertex);
  record.is_last = true;
  if (!is_backwards) record.incoming = model.chain_direction(0);
  if (!read_runs(model, record, model.chain_direction(0), Run::max_length)) return false;
  if (is_backwards) {
    record.incoming = model.chain_direction(0);
    translate(start, incidence, Run::from_code(record.word[Record::ring_words]).direction(), 1);
    for (uint32_t i = Record::ring_words; i < record.count; ++i) {
      const Run run = Run::from_code(record.word[i]);
      translate(start, incidence, run.direction(), 0U - run.length());
    }
    record.reverse_runs();
  }
  record.set_start(0, start);
  return true;
}

bool read_part(ReadingModel& model, Record& record) {
  record.begin(no_incidence);
  const bool begins_ring = model.part(record, false);
  if (!is_incidence(record.incidence)) return false;
  // Every region and fragment begins with a ring; only a region has more rings.
  if (record.continues ? begins_ring && record.is_fragment : !begins_ring) return false;
  if (begins_ring) record.add_ring(model.start(no_vertex));
  if (record.is_fragment && !record.continues) record.incoming = model.chain_direction(0);
  return read_runs(model, record, model.chain_direction(0), Run::max_length);
}

}  // namespace discmc::detail::stream

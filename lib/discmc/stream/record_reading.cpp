#include <discmc/stream/record_reading.hpp>

namespace discmc::stream {

namespace {

constexpr Vertex no_vertex{0, 0, 0};

bool is_length(int32_t value) {
  return value >= 1 && value <= static_cast<int32_t>(max_compact_length);
}

// False when the record is full, or the run too long.
bool add(Record& record, Run run, uint32_t most) {
  if (!record.has_room(1) || run.is_empty() || run.length() > most) return false;
  record.add_run(run);
  return true;
}

// The first direction of a ring; none where it is none of the plane's.
Direction read_ring_direction(ReadingModel& model, Incidence incidence, uint32_t closing) {
  const uint32_t from = model.ring_direction(0, closing);
  if (from >= model.directions()) return no_direction;
  const uint32_t direction = first_back(incidence) + from;
  const auto first = static_cast<Direction>(
      direction < model.directions() ? direction : direction - model.directions());
  model.begin_chain(first);
  return first;
}

// A ring of three or four corners, where turns lead to the second and the further ones.
bool read_corners(ReadingModel& model, Record& record, uint32_t code) {
  const uint32_t directions = model.directions();
  const uint32_t base = model.link_class() + 1;
  const uint32_t turns[] = {1 + code % base, 1 + code / base % base, 1 + code / base / base};
  const uint32_t sum = turns[0] + turns[1] + turns[2];
  const bool is_triangle = sum == directions;
  uint32_t direction = read_ring_direction(model, record.incidence,
                                           is_triangle ? turns[2] : directions - sum);
  const uint32_t count = is_triangle ? 3 : 4;
  if (!record.has_room(count)) return false;
  const uint32_t two = is_triangle ? 0 : model.two_lengths(0);
  const uint32_t told[] = {1 + two / 4, 1 + two % 4};
  for (uint32_t i = 0; i < count; ++i) {
    const auto to = static_cast<Direction>(direction);
    uint32_t length = 0;
    if (is_triangle && i == 0) length = model.length(rows::lengths, to, 1);
    if (!is_triangle && i < 2)
      length = told[i] < 4 ? told[i] : 3 + model.length(rows::longer, to, 1);
    if (length > max_compact_length) return false;
    record.add_run(Run::straight(to, length));
    if (i < 3) direction += turns[i];
    if (direction >= directions) direction -= directions;
  }
  return true;
}

// A ring run by run; the last two lengths are 0 so far.
bool read_long_ring(ReadingModel& model, Record& record) {
  const uint32_t count = model.run_count(1);
  if (count < 2 || count > Record::max_words || !record.has_room(count)) return false;
  const Direction first = read_ring_direction(model, record.incidence, 4);
  if (first == no_direction) return false;
  for (uint32_t i = 0; i < count; ++i) {
    Run run = Run::straight(first, 0);
    if (i + 2 < count) {
      run = i > 0 ? model.run(run) : Run::straight(first, model.length(rows::lengths, first, 1));
      if (!add(record, run, max_compact_length)) return false;
      continue;
    }
    if (i > 0) run = Run::straight(model.last_direction(0), 0);
    record.add_run(run);
  }
  return true;
}

bool read_ring(ReadingModel& model, Record& record) {
  const uint32_t first = record.count;
  const uint32_t corners = model.corners(0);
  if (!(corners == 0 ? read_long_ring(model, record) : read_corners(model, record, corners - 1)))
    return false;
  const PlaneStep* const steps = plane_steps_of(model.link_class());
  int32_t u = 0, v = 0;
  const uint32_t last = record.count - 1;
  for (uint32_t i = first; i + 1 < last; ++i) {
    const Run run = Run::from_code(record.word[i]);
    u -= static_cast<int32_t>(run.length()) * steps[run.direction()].u;
    v -= static_cast<int32_t>(run.length()) * steps[run.direction()].v;
  }
  const Direction a = Run::from_code(record.word[last - 1]).direction();
  const Direction b = Run::from_code(record.word[last]).direction();
  const bool is_parallel = are_parallel(model.directions(), a, b);
  const uint32_t first_length = is_parallel ? model.length(rows::lengths, a, 1) : 0;
  const Closure closure = close_ring(steps[a], steps[b], u, v, first_length);
  record.word[last - 1] = Run::straight(a, closure.first).code();
  record.word[last] = Run::straight(b, closure.second).code();
  return closure.is_valid;
}

// One after the other up to the last one. follows_link: a link was told before.
bool read_runs(ReadingModel& model, Record& record, bool follows_link) {
  bool is_first = true;
  do {
    Run run;
    if (is_first) {
      const Direction direction = follows_link ? model.cut_turn(0) : model.first_direction(0);
      const uint32_t length = model.length(rows::lengths, direction, 1);
      if (length <= Run::max_length) run = Run::straight(direction, length);
    } else {
      run = model.run(run);
    }
    if (!add(record, run, Run::max_length)) return false;
    is_first = false;
  } while (!model.is_last_run(false));
  return true;
}

}  // namespace

Closure close_ring(PlaneStep a, PlaneStep b, int32_t u, int32_t v, uint32_t first_length) {
  constexpr Closure invalid{false, 0, 0};
  if (first_length > max_compact_length) return invalid;
  const int32_t area = a.u * b.v - a.v * b.u;
  int32_t first = static_cast<int32_t>(first_length);
  int32_t second = 0;
  if (area == 0) {
    second = b.u != 0 ? (u - first * a.u) / b.u : (v - first * a.v) / b.v;
  } else {  // Cramer's rule
    first = (u * b.v - v * b.u) / area;
    second = (a.u * v - a.v * u) / area;
  }
  if (!is_length(first) || !is_length(second)) return invalid;
  if (first * a.u + second * b.u != u || first * a.v + second * b.v != v) return invalid;
  return {true, static_cast<uint32_t>(first), static_cast<uint32_t>(second)};
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

// The link by which it comes to its start is told first, or from its end last.
bool read_fragment(ReadingModel& model, Record& record, RecordKind kind) {
  const bool is_backwards = kind == RecordKind::backwards;
  Vertex start = model.start(no_vertex);
  const Incidence incidence = model.incidence(no_incidence);
  if (!is_incidence(incidence)) return false;
  record.begin(incidence);
  record.begin_fragment(0, no_vertex);
  record.is_last = true;
  if (!is_backwards) record.incoming = model.first_direction(0);
  if (!read_runs(model, record, !is_backwards)) return false;
  if (is_backwards) {
    record.incoming = model.cut_turn(0);
    move(start, incidence, Run::from_code(record.word[Record::ring_words]).direction(), 1);
    for (uint32_t i = Record::ring_words; i < record.count; ++i) {
      const Run run = Run::from_code(record.word[i]);
      move(start, incidence, run.direction(), 0U - run.length());
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
  // A ring begins every region and fragment, and others go on in a region.
  if (record.continues ? begins_ring && record.is_fragment : !begins_ring) return false;
  if (begins_ring) record.add_ring(model.start(no_vertex));
  const bool follows_link = record.is_fragment && !record.continues;
  if (follows_link) record.incoming = model.first_direction(0);
  return read_runs(model, record, follows_link);
}

}  // namespace discmc::stream

#include "decoder.hpp"

#include <iterator>
#include <utility>

#include <discmc/plane.hpp>
#include <discmc/stream/region_model.hpp>

namespace discmc::host::version1 {

using Kind = Event::Kind;

namespace {

// A record has at most so many words: a ring's start has some, a run or a stand-in one.
constexpr std::uint32_t max_words = 96;
constexpr std::uint32_t ring_words = 4;

}  // namespace

Status Decoder::push(const std::uint8_t* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count && !packets_.is_refused(); ++i) open(packets_.take(bytes[i]));
  return packets_.is_refused() ? Status::wrong_version : Status::ok;
}

void Decoder::tell_start() {
  Event event{};
  event.kind = Kind::start;
  event.header = &header();
  tell(event);
  start_is_told_ = true;
}

void Decoder::finish() {
  packets_.finish();
  open(PacketReader::Arrival::nothing);
}

void Decoder::open(PacketReader::Arrival arrival) {
  if (packets_.take_gap()) lose_open();
  if (report().has_header && !start_is_told_) tell_start();
  if (arrival == PacketReader::Arrival::records) read_records();
  if (arrival == PacketReader::Arrival::trailer) tell_finish();
}

// ---- reading: false where no encoder wrote what is there ----

void Decoder::read_records() {
  model_ = Model(packets_.packet().payload, packets_.packet().payload_bytes);
  is_at_end_ = false;
  normals_are_ahead_ = false;
  bool is_good = true;
  while (is_good && !is_at_end_) is_good = read_record();
  if (is_good) return;
  packets_.note_unreadable();
  lose_open();
}

bool Decoder::read_record() {
  if (!normals_are_ahead_) normals_.clear();
  normals_are_ahead_ = false;
  Record record;
  if (model_.region_follows()) return read_region(record) && take(std::move(record));
  switch (model_.other_kind()) {
    case OtherKind::layer:
      return read_layer();
    case OtherKind::skipped:
      return read_skipped();
    case OtherKind::part:
      return read_part(record) && take(std::move(record));
    case OtherKind::extension:
      return read_extension();
    case OtherKind::end:
      is_at_end_ = true;
      return !model_.is_exhausted();
  }
  return false;
}

bool Decoder::read_region(Record& record) {
  record.head.incidence = model_.incidence();
  const std::uint32_t rings = model_.ring_count();
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    if (!read_ring(record)) return false;
  return true;
}

bool Decoder::read_ring(Record& record) {
  const Incidence incidence = record.head.incidence;
  Ring& ring = record.rings.emplace_back(Ring{model_.start(!record.rings.empty()), {}});
  const bool is_parallelogram = model_.is_parallelogram();
  const std::uint32_t count = is_parallelogram ? 4 : model_.run_count();
  if (count > max_words) return false;
  record.words += ring_words + count;
  if (record.words > max_words) return false;
  Direction direction[2] = {0, 0};
  std::uint32_t length[2] = {0, 0};
  Vertex way{0, 0, 0};
  for (std::uint32_t i = 0; i < (is_parallelogram ? 2 : count); ++i) {
    direction[0] = direction[1];
    direction[1] = model_.direction();
    if (!is_direction_of(incidence, direction[1])) return false;
    if (i + 2 >= count) continue;  // its length follows from the others
    length[0] = length[1];
    if (!read_compact_length(length[1])) return false;
    const Run run = Run::straight(direction[1], length[1]);
    way = way - displacement(incidence, &run, 1);
    ring.chain.emplace_back(run);
  }
  if (is_parallelogram) {
    for (int i = 0; i < 2; ++i)
      ring.chain.emplace_back(
          Run::straight(opposite_direction(incidence, direction[i]), length[i]));
    return true;
  }
  std::uint32_t told = 0;
  if (model_.is_parallel() && !read_compact_length(told)) return false;
  const Closure closure = close_ring(direction_vector(incidence, direction[0]),
                                     direction_vector(incidence, direction[1]), way, told);
  if (!closure.is_valid) return false;
  ring.chain.emplace_back(Run::straight(direction[0], closure.first));
  ring.chain.emplace_back(Run::straight(direction[1], closure.second));
  return true;
}

bool Decoder::read_compact_length(std::uint32_t& length) {
  length = model_.length();
  return length <= max_compact_length;
}

bool Decoder::read_part(Record& record) {
  record.head = model_.part();
  if (record.head.number > Side::max_number) return false;
  for (Item item = model_.item(); item != Item::end; item = model_.item())
    if (!read_item(item, record)) return false;
  record.is_last = model_.is_last_part();
  return true;
}

bool Decoder::read_item(Item item, Record& record) {
  record.words += item == Item::ring ? ring_words : 1;
  if (record.words > max_words) return false;
  Chain& chain = record.rings.empty() ? record.rest : record.rings.back().chain;
  if (item == Item::ring) {
    const bool is_first = !record.head.continues && record.rings.empty() && record.rest.empty();
    record.rings.push_back({model_.start(!is_first), {}});
    return !record.head.is_fragment;
  }
  if (item == Item::run) return read_run(record.head.incidence, chain);
  const std::uint32_t number = model_.stand_in();
  if (number > Side::max_number) return false;
  chain.push_back(Side::stand_in(number));
  return true;
}

bool Decoder::read_run(Incidence incidence, Chain& chain) {
  const Direction direction = model_.direction();
  if (!is_direction_of(incidence, direction)) return false;
  const std::uint32_t length = model_.length();
  if (length > Run::max_length) return false;
  chain.emplace_back(Run::straight(direction, length));
  return true;
}

bool Decoder::read_layer() {
  Event event{};
  event.kind = Kind::layer;
  event.slice = model_.layer();
  if (model_.is_exhausted()) return false;
  lose_open();
  tell(event);
  return true;
}

bool Decoder::read_skipped() {
  Event event{};
  event.kind = Kind::skipped;
  event.slice = model_.plain_number();
  event.row = model_.plain_number();
  event.repeated = model_.plain_bits(1) != 0;
  if (model_.is_exhausted()) return false;
  lose_open();
  tell(event);
  return true;
}

bool Decoder::read_extension() {
  const std::uint32_t type = model_.plain_bits(8);
  const std::uint32_t bytes = model_.plain_bits(8);
  normals_are_ahead_ = type >= first_normals_extension && type <= last_normals_extension;
  if (normals_are_ahead_) {
    normals_.decode(model_, type, bytes);
  } else {
    for (std::uint32_t i = 0; i < bytes; ++i) model_.plain_bits(8);
  }
  return !model_.is_exhausted();
}

// ---- what has been read ----

// False when the record breaks the grammar.
bool Decoder::take(Record&& record) {
  if (model_.is_exhausted()) return false;
  const bool goes_on = goes_on_with(record);
  if (!goes_on) lose_open();
  if (record.head.continues && !goes_on) {
    skip(record);
    return true;
  }
  if (!rings_are_whole(record)) return false;
  if (!has_room_for(record)) {
    lose_open();
    skip(record);
    return true;
  }
  set_normals(record);
  const bool is_last = record.is_last;
  append(std::move(record));
  if (is_last) end_open();
  return true;
}

// A part goes on with what the part before began.
bool Decoder::goes_on_with(const Record& record) const {
  const PartHead& head = record.head;
  return is_open_ && head.continues && open_.head.incidence == head.incidence &&
         open_.head.is_fragment == head.is_fragment && open_.head.number == head.number;
}

// Whether every run of a region is in a ring, and every ring has a run.
bool Decoder::rings_are_whole(const Record& record) const {
  if (record.head.is_fragment) return true;
  const bool is_first = !record.head.continues;
  if (is_first && (record.rings.empty() || !record.rest.empty())) return false;
  bool is_empty = !is_first && record.rest.empty() && open_.rings.back().chain.empty();
  for (const Ring& ring : record.rings) {
    if (is_empty) return false;
    is_empty = ring.chain.empty();
  }
  return !record.is_last || !is_empty;
}

// What is told at once needs none.
bool Decoder::has_room_for(const Record& record) const {
  if (!record.head.is_fragment && record.is_last && !is_open_) return true;
  std::size_t bytes = fragments_.bytes() + open_bytes_ + bytes_of(record.rest.size());
  for (const Ring& ring : record.rings) bytes += bytes_of(ring.chain.size());
  return bytes <= most_bytes_;
}

// In the order of the record.
void Decoder::set_normals(Record& record) const {
  std::uint32_t told = 0;
  for (Side& side : record.rest) side.normal = normals_.at(told++);
  for (Ring& ring : record.rings)
    for (Side& side : ring.chain) side.normal = normals_.at(told++);
}

void Decoder::append(Record&& record) {
  open_bytes_ += bytes_of(record.rest.size());
  for (const Ring& ring : record.rings) open_bytes_ += bytes_of(ring.chain.size());
  if (!is_open_) {
    open_ = std::move(record);
    is_open_ = true;
    return;
  }
  Chain& chain = open_.head.is_fragment ? open_.rest : open_.rings.back().chain;
  chain.insert(chain.end(), record.rest.begin(), record.rest.end());
  open_.rings.insert(open_.rings.end(), std::make_move_iterator(record.rings.begin()),
                     std::make_move_iterator(record.rings.end()));
}

// A part has nothing to go on with, or finds no room. With its last one a region is known to be
// lost.
void Decoder::skip(const Record& record) {
  if (record.is_last && !record.head.is_fragment) packets_.lose_region();
}

void Decoder::end_open() {
  if (open_.head.is_fragment) {
    fragments_.add(open_.head.number, open_.head.incidence, std::move(open_.rest));
    ++packets_.report().fragments;
  } else {
    bool is_whole = true;
    for (Ring& ring : open_.rings)
      is_whole =
          fragments_.put_back(open_.head.incidence, ring.chain) && !ring.chain.empty() && is_whole;
    if (is_whole) {
      for (Ring& ring : open_.rings) arrange(open_.head.incidence, ring);
      tell_open();
      packets_.pass_region();
    } else {
      tell_open_lost();
      packets_.lose_region();
    }
  }
  forget_open();
}

void Decoder::lose_open() {
  if (!is_open_) return;
  if (!open_.head.is_fragment) tell_open_lost();
  forget_open();
}

void Decoder::forget_open() {
  open_ = Record();
  is_open_ = false;
  open_bytes_ = 0;
}

// ---- events ----

void Decoder::tell_open() {
  Event event{};
  event.kind = Kind::region;
  event.incidence = open_.head.incidence;
  tell(event);
  for (const Ring& ring : open_.rings) {
    event.kind = Kind::ring;
    event.start = ring.start;
    event.hole = &ring != &open_.rings.front();
    tell(event);
    event.kind = Kind::run;
    for (const Side& side : ring.chain) {
      event.run = side.run();
      event.normal = side.normal;
      tell(event);
    }
  }
  event.kind = Kind::region_end;
  tell(event);
}

void Decoder::tell_open_lost() {
  Event event{};
  event.kind = Kind::region;
  event.incidence = open_.head.incidence;
  tell(event);
  event.kind = Kind::lost;
  tell(event);
}

void Decoder::tell_finish() {
  Statistics totals = report().totals;
  totals.fragments = 0;  // none was told
  Event event{};
  event.kind = Kind::finish;
  event.slice = report().slices;
  event.abandoned = report().abandoned;
  event.statistics = &totals;
  tell(event);
}

}  // namespace discmc::host::version1

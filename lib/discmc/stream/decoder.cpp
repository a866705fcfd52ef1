#include <discmc/chain.hpp>
#include <discmc/decoder.hpp>

namespace discmc {

Status Decoder::start(const Sink& sink, uint8_t channel) {
  if (sink.take == nullptr) return Status::bad_sink;
  sink_ = sink;
  packet_sink_ = {};
  packets_.start(channel);
  is_started_ = true;
  start_is_sent_ = false;
  stage_ = Stage::collect;
  lost_is_due_ = false;
  is_open_ = false;
  return Status::ok;
}

Decoded Decoder::push(const uint8_t* bytes, size_t count) {
  if (!is_started_) return {Status::not_started, 0};
  for (size_t taken = 0;; ++taken) {
    if (packets_.is_refused()) return {Status::wrong_version, taken};
    if (!deliver()) return {status_of(answer_), taken};
    if (taken == count) return {Status::ok, count};
    open(packets_.take(bytes[taken]));
  }
}

Status Decoder::finish() {
  if (!is_started_) return Status::not_started;
  if (!deliver()) return status_of(answer_);
  packets_.finish();
  open(PacketReader::Completed::nothing);
  return deliver() ? Status::ok : status_of(answer_);
}

void Decoder::open(PacketReader::Completed arrival) {
  if (packets_.take_gap()) lose_open();
  if (arrival == PacketReader::Completed::records) {
    model_ = Model(Coder{RangeDecoder(packets_.payload(), packets_.payload_bytes())});
    normals_are_ahead_ = false;
    const bool may_pass = packets_.whole_regions() > 0 && packet_sink_.take != nullptr;
    if (may_pass) lose_open();
    stage_ = may_pass ? Stage::whole_regions : Stage::records;
  } else if (arrival == PacketReader::Completed::application) {
    note_application();
  } else if (arrival == PacketReader::Completed::trailer) {
    note_finish();
  }
}

// What is under way cannot be ended: the sink is told.
void Decoder::lose_open() {
  lost_is_due_ = lost_is_due_ || is_open_;
  is_open_ = false;
}

// A packet without records is an event.
Event& Decoder::packet_mark(Event::Kind kind) {
  lose_open();
  mark_ = Event{};
  mark_.kind = kind;
  stage_ = Stage::packet_mark;
  return mark_;
}

void Decoder::note_application() {
  application_ = packets_.application();
  packet_mark(Event::Kind::application).application = &application_;
}

void Decoder::note_finish() {
  Event& finish = packet_mark(Event::Kind::finish);
  finish.slice = report().slices;
  finish.abandoned = report().abandoned;
  finish.statistics = &report().totals;
}

// ---- records ----

// Reads the next record of the packet and sets the stage for its delivery.
void Decoder::read_record() {
  bool is_good = true;
  if (!normals_are_ahead_) normals_.clear();
  normals_are_ahead_ = false;
  const RecordKind kind = model_.record_kind(RecordKind::end);
  stage_ = Stage::record;
  switch (kind) {
    case RecordKind::region:
      is_good = read_region();
      break;
    case RecordKind::fragment:
      is_good = read_fragment();
      break;
    case RecordKind::part:
      is_good = read_part();
      break;
    case RecordKind::layer:
    case RecordKind::skipped:
      read_mark(kind);
      break;
    case RecordKind::extension:
      read_extension();
      stage_ = Stage::records;
      break;
    case RecordKind::end:
      stage_ = Stage::collect;
      break;
    default:
      is_good = false;
  }
  is_good = is_good && !model_.coder().range.is_exhausted();
  if (is_good && (stage_ != Stage::record || begin_record())) return;
  packets_.note_unreadable();
  lose_open();
  stage_ = Stage::collect;
}

void Decoder::read_extension() {
  const uint32_t type = model_.plain_bits(8, 0);
  uint32_t bytes = model_.plain_bits(8, 0);
  if (type >= first_normals_extension && type <= last_normals_extension) {
    normals_.decode(model_, type, bytes);
    normals_are_ahead_ = true;
    return;
  }
  for (; bytes > 0; --bytes) model_.plain_bits(8, 0);
}

bool Decoder::read_region() {
  record_.begin(model_.incidence(no_incidence));
  record_.is_last = true;
  const uint32_t rings = model_.ring_count(1);
  for (uint32_t ring = 0; ring < rings; ++ring)
    if (!read_ring(ring > 0 ? ChainKind::further : ChainKind::first)) return false;
  return true;
}

bool Decoder::read_ring(ChainKind kind) {
  const Vertex start = model_.start(Vertex{0, 0, 0}, kind);
  const bool is_parallelogram = model_.parallelogram(false);
  const uint32_t count = is_parallelogram ? 4 : model_.run_count(2);
  if (count < 2 || count > Record::max_words || !record_.has_room(Record::ring_words + count))
    return false;
  record_.add_ring(start);
  Direction direction[2] = {0, 0};
  uint32_t length[2] = {0, 0};
  Vertex way{0, 0, 0};
  for (uint32_t i = 0; i < (is_parallelogram ? 2 : count); ++i) {
    direction[0] = direction[1];
    direction[1] = model_.direction(0);
    if (!is_direction_of(record_.incidence, direction[1])) return false;
    if (i + 2 >= count) continue;
    length[0] = length[1];
    length[1] = model_.length(1);
    if (length[1] > max_compact_length) return false;
    const Vertex step = direction_vector(record_.incidence, direction[1]);
    const int32_t steps = static_cast<int32_t>(length[1]);
    way = way - Vertex{steps * step.x, steps * step.y, steps * step.z};
    record_.add_run(Run::straight(direction[1], length[1]));
  }
  if (is_parallelogram) {
    for (int i = 0; i < 2; ++i)
      record_.add_run(
          Run::straight(opposite_direction(record_.incidence, direction[i]), length[i]));
    return true;
  }
  const Vertex u = direction_vector(record_.incidence, direction[0]);
  const Vertex v = direction_vector(record_.incidence, direction[1]);
  uint32_t first_length = 0;
  if (model_.is_parallel()) first_length = model_.length(1);
  if (first_length > max_compact_length) return false;
  const Closure closure = close_ring(u, v, way, first_length);
  if (!closure.is_valid) return false;
  record_.add_run(Run::straight(direction[0], closure.first));
  record_.add_run(Run::straight(direction[1], closure.second));
  return true;
}

// The link by which it comes to its start is told first, or from its end last.
bool Decoder::read_fragment() {
  const Incidence incidence = model_.incidence(no_incidence);
  const bool is_backwards = model_.order(ChainKind::fragment) == ChainKind::backwards;
  record_.begin(incidence);
  record_.begin_fragment(0, Vertex{0, 0, 0});
  record_.is_last = true;
  Vertex start{0, 0, 0};
  bool is_last = false;
  for (bool is_first = true; !is_last; is_first = false) {
    const Direction direction = model_.direction(0);
    if (!is_direction_of(incidence, direction)) return false;
    if (is_first) {
      start = model_.fragment_vertex(Vertex{0, 0, 0});
      if (is_backwards) move(start, incidence, direction, 1);
    } else {
      is_last = model_.is_last_link(false);
    }
    if (is_backwards ? is_last : is_first) {
      record_.incoming = direction;
      continue;
    }
    const uint32_t length = model_.length(1);
    if (length > Run::max_length || !record_.has_room(1)) return false;
    record_.add_run(Run::straight(direction, length));
    if (is_backwards) move(start, incidence, direction, 0U - length);
  }
  record_.set_start(0, start);
  if (is_backwards) record_.reverse_runs();
  return true;
}

bool Decoder::read_part() {
  record_.begin(no_incidence);
  model_.part(record_);
  if (record_.is_fragment && !is_direction_of(record_.incidence, record_.incoming)) return false;
  for (;;) {
    if (!record_.has_room(1)) {
      if (model_.item_kind(Item::end) != Item::end) return false;
      break;
    }
    const Item kind = model_.item_kind(Item::end);
    if (kind == Item::end) break;
    const bool is_first = record_.count == 0 && !record_.continues;
    if (kind == Item::ring) {
      if (!record_.has_room(Record::ring_words) || (record_.is_fragment && !is_first)) return false;
      record_.add_ring(
          model_.start(Vertex{0, 0, 0}, is_first ? ChainKind::first : ChainKind::further));
    } else {
      const Direction direction = model_.direction(0);
      if (!is_direction_of(record_.incidence, direction)) return false;
      const uint32_t length = model_.length(1);
      if (length > Run::max_length) return false;
      record_.add_run(Run::straight(direction, length));
    }
  }
  record_.is_last = model_.end_part(false);
  return true;
}

void Decoder::read_mark(RecordKind kind) {
  lose_open();
  mark_ = Event{};
  if (kind == RecordKind::layer) {
    mark_.kind = Event::Kind::layer;
    mark_.slice = model_.layer(0);
  } else {
    mark_.kind = Event::Kind::skipped;
    mark_.slice = model_.plain_number(0);
    mark_.row = model_.plain_number(0);
    mark_.repeated = model_.plain_bit(false);
  }
  stage_ = Stage::mark;
}

// A part goes on with what the part before began; without that it is of no use.
// False when the record breaks the grammar: a run that is in no ring, or a ring without a run.
bool Decoder::begin_record() {
  sent_words_ = 0;
  sent_runs_ = 0;
  const bool goes_on =
      is_open_ && open_.incidence == record_.incidence && open_.is_fragment == record_.is_fragment;
  if (record_.continues && !goes_on) {
    lose_open();
    if (record_.is_last) {
      ++packets_.report().lost_pieces;
      packets_.pass_pieces(1);
    }
    stage_ = Stage::records;
    return true;
  }
  if (!record_.continues) {
    lose_open();
    ring_is_empty_ = false;
  }
  if (!rings_are_whole()) return false;
  begin_is_due_ = !record_.continues;
  return true;
}

bool Decoder::rings_are_whole() {
  if (!record_.continues && (record_.count == 0 || record_.word[0] != Record::ring_mark))
    return false;
  for (uint32_t i = 0; i < record_.count;) {
    const bool is_ring = record_.word[i] == Record::ring_mark;
    if (is_ring && ring_is_empty_) return false;
    ring_is_empty_ = is_ring;
    i += is_ring ? Record::ring_words : 1;
  }
  return !record_.is_last || !ring_is_empty_;
}

// ---- delivery ----

// Offers all that is known to the sink. False when it said "not now".
bool Decoder::deliver() {
  for (;;) {
    if (lost_is_due_) {
      Event event{};
      event.kind = Event::Kind::lost;
      if (!offer(event)) return false;
      lost_is_due_ = false;
    }
    if (!send_start()) return false;
    switch (stage_) {
      case Stage::collect:
        return true;
      case Stage::whole_regions:
        pass_whole_regions();
        break;
      case Stage::records:
        read_record();
        break;
      case Stage::record:
        if (!deliver_record()) return false;
        stage_ = Stage::records;
        break;
      default:  // a mark
        if (!offer(mark_)) return false;
        stage_ = stage_ == Stage::mark ? Stage::records : Stage::collect;
        break;
    }
  }
}

// Before any header the sink has no scan, and gets events as ever.
void Decoder::pass_whole_regions() {
  stage_ = start_is_sent_ ? Stage::collect : Stage::records;
  if (!start_is_sent_) return;
  const uint32_t count = packets_.whole_regions();
  packet_sink_.take(packet_sink_.context,
                    {packets_.payload(), packets_.payload_bytes(), count, true});
  packets_.report().regions += count;
  packets_.pass_pieces(count);
}

// Tells of the header once it is there, and between two pieces. A stream of slices is not for this
// decoder.
bool Decoder::send_start() {
  const bool is_there = report().has_header && !report().holds_slices;
  if (start_is_sent_ || !is_there || is_open_) return true;
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header();
  start_is_sent_ = offer(event);
  return start_is_sent_;
}

bool Decoder::deliver_record() {
  Event event{};
  event.incidence = record_.incidence;
  if (begin_is_due_) {
    event.kind = record_.is_fragment ? Event::Kind::fragment : Event::Kind::region;
    if (record_.is_fragment) {
      event.start = record_.start_at(0);
      event.incoming_direction = record_.incoming;
    }
    if (!offer(event)) return false;
    begin_is_due_ = false;
    open_ = {record_.incidence, record_.is_fragment};
    is_open_ = true;
    is_first_ring_ = true;
    if (record_.is_fragment) sent_words_ = Record::ring_words;
  }
  while (sent_words_ < record_.count) {
    const bool is_ring = record_.word[sent_words_] == Record::ring_mark;
    if (is_ring) {
      event.kind = Event::Kind::ring;
      event.start = record_.start_at(sent_words_);
      event.hole = !is_first_ring_;
    } else {
      event.kind = Event::Kind::run;
      event.run = Run::from_code(record_.word[sent_words_]);
      event.normal = normals_.at(sent_runs_);
    }
    if (!offer(event)) return false;
    if (is_ring)
      is_first_ring_ = false;
    else
      ++sent_runs_;
    sent_words_ += is_ring ? Record::ring_words : 1;
  }
  if (!record_.is_last) return true;
  event.kind = record_.is_fragment ? Event::Kind::fragment_end : Event::Kind::region_end;
  if (!offer(event)) return false;
  is_open_ = false;
  StreamReport& report = packets_.report();
  ++(record_.is_fragment ? report.fragments : report.regions);
  packets_.pass_pieces(1);
  return true;
}

}  // namespace discmc

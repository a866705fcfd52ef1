#include <discmc/chain.hpp>
#include <discmc/decoder.hpp>

namespace discmc {

using detail::stream::Record;
using detail::stream::RecordKind;

Status Decoder::start(const Sink& sink, uint8_t channel) {
  if (sink.accept == nullptr) return Status::bad_sink;
  if (!StreamLabel::is_receivable(channel)) return Status::bad_label;
  sink_ = sink;
  packet_sink_ = {};
  packets_.start(channel);
  clear();
  return Status::ok;
}

void Decoder::start_next(const detail::stream::PacketReader& before) {
  clear();
  open(packets_.start_next(before));
}

void Decoder::clear() {
  is_started_ = true;
  is_start_sent_ = false;
  stage_ = Stage::collect;
  is_loss_due_ = false;
  is_open_ = false;
}

Decoded Decoder::push(const uint8_t* bytes, size_t count) {
  if (!is_started_) return {Status::not_started, 0};
  for (size_t consumed = 0;; ++consumed) {
    if (packets_.is_refused()) return {Status::wrong_version, consumed};
    if (!deliver()) return {status_of(answer_), consumed};
    if (consumed == count) return {Status::ok, count};
    open(packets_.add(bytes[consumed]));
  }
}

Status Decoder::finish() {
  if (!is_started_) return Status::not_started;
  if (!deliver()) return status_of(answer_);
  packets_.finish();
  open(detail::stream::PacketReader::Completed::nothing);
  return deliver() ? Status::ok : status_of(answer_);
}

void Decoder::open(detail::stream::PacketReader::Completed arrival) {
  if (packets_.remove_gap()) lose_open();
  if (arrival == detail::stream::PacketReader::Completed::records) {
    model_ =
        detail::stream::ReadingModel({RangeDecoder(packets_.payload(), packets_.payload_bytes())});
    are_normals_ahead_ = false;
    const bool may_pass = packets_.whole_regions() > 0 && packet_sink_.accept != nullptr;
    if (may_pass) lose_open();
    stage_ = may_pass ? Stage::whole_regions : Stage::records;
  } else if (arrival == detail::stream::PacketReader::Completed::application) {
    note_application();
  } else if (arrival == detail::stream::PacketReader::Completed::trailer) {
    note_finish();
  }
}

// The current piece cannot be completed: the sink receives `lost`.
void Decoder::lose_open() {
  is_loss_due_ = is_loss_due_ || is_open_;
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
  finish.is_abandoned = report().is_abandoned;
  finish.statistics = &report().totals;
}

// ---- records ----

// Reads the next record of the packet, and selects the stage that delivers it.
void Decoder::read_record() {
  bool is_good = true;
  if (!are_normals_ahead_) normals_.clear();
  are_normals_ahead_ = false;
  const RecordKind kind = model_.record_kind(RecordKind::end);
  stage_ = Stage::record;
  switch (kind) {
    case RecordKind::region:
    case RecordKind::holed:
      is_good = detail::stream::read_region(model_, record_, kind);
      break;
    case RecordKind::forwards:
    case RecordKind::backwards:
      is_good = detail::stream::read_fragment(model_, record_, kind);
      break;
    case RecordKind::part:
      is_good = detail::stream::read_part(model_, record_);
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
  }
  if (is_good && !model_.coder().range.is_exhausted()) {
    if (stage_ == Stage::record) begin_record();
    return;
  }
  packets_.note_unreadable();
  lose_open();
  stage_ = Stage::collect;
}

void Decoder::read_extension() {
  const uint32_t type = model_.raw_bits(8, 0);
  uint32_t bytes = model_.raw_bits(8, 0);
  if (type >= detail::stream::first_normals_extension &&
      type <= detail::stream::last_normals_extension) {
    normals_.decode(model_, type, bytes);
    are_normals_ahead_ = true;
    return;
  }
  for (; bytes > 0; --bytes) model_.raw_bits(8, 0);
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
    mark_.is_repeated = model_.raw_bits(1, 0) != 0;
  }
  stage_ = Stage::mark;
}

// A part continues the part before; without that part it is useless.
void Decoder::begin_record() {
  sent_words_ = 0;
  sent_runs_ = 0;
  is_begin_due_ = !record_.continues;
  const bool is_continuation = record_.continues && is_open_ &&
                               open_.incidence == record_.incidence &&
                               open_.is_fragment == record_.is_fragment;
  if (is_continuation) return;
  lose_open();
  if (!record_.continues) return;
  if (record_.is_last) {
    ++packets_.report().lost_pieces;
    packets_.pass_pieces(1);
  }
  stage_ = Stage::records;
}

// ---- delivery ----

// Offers all pending events to the sink. Returns false if the sink does not accept one.
bool Decoder::deliver() {
  for (;;) {
    if (is_loss_due_) {
      Event event{};
      event.kind = Event::Kind::lost;
      if (!offer(event)) return false;
      is_loss_due_ = false;
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

// Before the first header the sink has no scan, and receives events as usual.
void Decoder::pass_whole_regions() {
  stage_ = is_start_sent_ ? Stage::collect : Stage::records;
  if (!is_start_sent_) return;
  const uint32_t count = packets_.whole_regions();
  packet_sink_.accept(packet_sink_.context,
                      {packets_.payload(), packets_.payload_bytes(), count, true});
  packets_.report().regions += count;
  packets_.pass_pieces(count);
}

// Sends `start` when the header has arrived, between two pieces. A stream of slices is not for this
// decoder.
bool Decoder::send_start() {
  const bool is_there = report().has_header && !report().holds_slices;
  if (is_start_sent_ || !is_there || is_open_) return true;
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header();
  is_start_sent_ = offer(event);
  return is_start_sent_;
}

bool Decoder::deliver_record() {
  Event event{};
  event.incidence = record_.incidence;
  if (is_begin_due_) {
    event.kind = record_.is_fragment ? Event::Kind::fragment : Event::Kind::region;
    if (record_.is_fragment) {
      event.start = record_.start_at(0);
      event.incoming_direction = record_.incoming;
    }
    if (!offer(event)) return false;
    is_begin_due_ = false;
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
      event.is_hole = !is_first_ring_;
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

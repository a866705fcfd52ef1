// Builds streams from recorded events, and splits and repairs their packets.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/stream/crc32.hpp>
#include <stdexcept>
#include <vector>

#include "event_log.hpp"
#include "scan.hpp"

namespace discmc::test {

using Bytes = std::vector<uint8_t>;

using reference::EventLog;
using reference::Events;
using reference::RecordedEvent;

// ---- chance ----

/// Random numbers from a portable generator.
class Chance {
 public:
  explicit Chance(uint64_t seed) : state_(seed) {}
  uint64_t next() { return reference::next_random(state_); }
  uint32_t below(uint32_t limit) { return static_cast<uint32_t>(next() % limit); }
  uint8_t byte() { return static_cast<uint8_t>(next()); }

 private:
  uint64_t state_;
};

// ---- scans ----

inline Events events_of(const reference::BitVolume& volume, const Capacities& capacities,
                        const reference::Plan& plan = {}) {
  EventLog log;
  reference::scan_into<uint32_t>(log, volume, plan, capacities);
  return log.events;
}

inline Events events_of(const reference::BitVolume& volume, const reference::Plan& plan = {}) {
  return events_of(volume, reference::ample, plan);
}

inline StreamHeader header_of(const reference::BitVolume& volume, Border border = Border::closed) {
  return {volume.width, volume.height, volume.depth, {1000000, 1000000, 1000000}, {1}, border};
}

/// Returns a small header for streams without a volume.
inline StreamHeader any_header() {
  return header_of(reference::BitVolume({1, 1, 1}));
}

// ---- encoding ----

/// Accepts bytes like a slow line: at most max_bytes at every second call, none at the others. 0:
/// all.
class Line {
 public:
  explicit Line(size_t max_bytes = 0) : max_bytes_(max_bytes) {}
  ByteOutput output() {
    return {this,
            [](void* context, const uint8_t* data, size_t count) {
              return static_cast<Line*>(context)->write(data, count);
            },
            [](void*) { return size_t{0}; }};
  }

  Bytes bytes;

 private:
  size_t write(const uint8_t* data, size_t count) {
    was_busy_ = max_bytes_ > 0 && !was_busy_;
    if (was_busy_) return 0;
    const size_t accepted = max_bytes_ > 0 && max_bytes_ < count ? max_bytes_ : count;
    bytes.insert(bytes.end(), data, data + accepted);
    return accepted;
  }

  size_t max_bytes_;
  bool was_busy_ = false;
};

/// Accepts bytes while there is room, and none until there is room again.
struct LimitedLine {
  size_t room = 0;
  Bytes bytes{};

  ByteOutput output() {
    return {this, [](void* context, const uint8_t* data, size_t count) {
              auto& line = *static_cast<LimitedLine*>(context);
              const size_t accepted = std::min(count, line.room);
              line.bytes.insert(line.bytes.end(), data, data + accepted);
              line.room -= accepted;
              return accepted;
            }};
  }
};

inline Event start_of(const StreamHeader& header) {
  Event event{};
  event.kind = Event::Kind::start;
  event.header = &header;
  return event;
}

/// Begins a stream as an extractor does. Returns the reason of a refusal.
template <class Encoding>
Status begin_stream(Encoding& encoder, const StreamHeader& header, const ByteOutput& output) {
  const Status status = encoder.start(header.label(), output);
  if (status != Status::ok) return status;
  return encoder.accept(start_of(header)) == SinkResult::accepted ? Status::ok : Status::bad_sink;
}

template <class Encoding>
void encode_all(Encoding& encoder, const Events& events) {
  for (const RecordedEvent& recorded : events)
    for (int tries = 0; encoder.accept(recorded.event()) != SinkResult::accepted; ++tries)
      if (tries > 10000) throw std::runtime_error("an event that is never accepted");
}

/// An encoder that also encodes normals.
struct NormalEncoder : Encoder {
  NormalEncoder() { encode_normals(); }
};

template <class Encoding = Encoder>
Bytes encode(const Events& events, const StreamHeader& header = any_header(),
             size_t bytes_at_once = 0) {
  Line line(bytes_at_once);
  Encoding encoder;
  reference::require_ok(begin_stream(encoder, header, line.output()));
  encode_all(encoder, events);
  while (encoder.flush() == Status::suspended) continue;
  if (encoder.bytes() != line.bytes.size()) throw std::runtime_error("bytes() is wrong");
  return line.bytes;
}

// ---- decoding ----

struct Received {
  Events events;
  StreamReport report;
  StreamHeader header;
  Status status;
};

/// Decodes `chunk` bytes at a time (0: all at once), with a sink that may refuse every event once.
inline Received decode(const Bytes& bytes, size_t chunk = 0, bool refuses = false,
                       uint8_t channel = any_channel) {
  EventLog log(refuses ? EventLog::Refuses(reference::refuses_first) : nullptr);
  Decoder decoder;
  reference::require_ok(decoder.start(make_sink(log), channel));
  Status status = Status::ok;
  for (size_t at = 0; at < bytes.size() && status != Status::wrong_version;) {
    const size_t left = bytes.size() - at;
    const Decoded decoded =
        decoder.push(bytes.data() + at, chunk == 0 || chunk > left ? left : chunk);
    at += decoded.bytes;
    status = decoded.status;
  }
  reference::finish_all(decoder);
  if (decoder.push(nullptr, 0).status == Status::wrong_version) status = Status::wrong_version;
  return {log.events, decoder.report(), decoder.header(), status};
}

/// Returns the events of each frame of a whole stream.
inline std::vector<Events> events_by_frame(const std::vector<Bytes>& frames) {
  EventLog log;
  Decoder decoder;
  reference::require_ok(decoder.start(make_sink(log)));
  std::vector<Events> result;
  for (const Bytes& frame : frames) {
    const Decoded decoded = decoder.push(frame.data(), frame.size());
    reference::require_ok(decoded.status);
    result.push_back(std::move(log.events));
    log.events.clear();
  }
  return result;
}

/// Returns the complete regions and loose fragments of a decoder's events. Errors: throws if the
/// events break the grammar of sink.hpp, including `lost`.
inline std::vector<Events> pieces_of(const Events& events) {
  using Kind = Event::Kind;
  enum class State {
    between,
    region,
    ring,
    runs,
    fragment,
    fragment_runs,
    over
  } state = State::between;
  const auto require = [](bool holds) {
    if (!holds) throw reference::GrammarError("events in an order that the grammar does not have");
  };
  std::vector<Events> pieces;
  Events open;
  uint32_t directions = 0;
  for (const RecordedEvent& recorded : events) {
    const Event event = recorded.event();
    const bool is_in_ring = state == State::ring || state == State::runs;
    const bool is_in_fragment = state == State::fragment || state == State::fragment_runs;
    require(state != State::over);
    if (recorded.is(Kind::run)) {
      require(is_in_ring || is_in_fragment);
      require(event.run.length() > 0 && event.run.direction() < directions);
      state = is_in_ring ? State::runs : State::fragment_runs;
    } else if (recorded.is(Kind::ring)) {
      require(state == State::region || state == State::runs);
      require(event.is_hole == (state == State::runs));
      require((event.start.x ^ event.start.y ^ event.start.z) & 1);
      state = State::ring;
    } else if (recorded.is(Kind::region_end)) {
      require(state == State::runs);
      state = State::between;
    } else if (recorded.is(Kind::fragment_end)) {
      require(state == State::fragment_runs);
      state = State::between;
    } else if (recorded.is(Kind::lost)) {
      require(state != State::between);
      state = State::between;
      open.clear();
    } else {
      require(state == State::between);
      if (recorded.is(Kind::region)) state = State::region;
      if (recorded.is(Kind::fragment)) state = State::fragment;
      if (recorded.is(Kind::finish)) state = State::over;
      if (state == State::region || state == State::fragment)
        directions = direction_count(event.incidence);
      if (state == State::fragment) {
        require((event.start.x ^ event.start.y ^ event.start.z) & 1);
        require(event.incoming_direction < directions);
      }
      open.clear();
    }
    open.push_back(recorded);
    if (recorded.is(Kind::region_end) || recorded.is(Kind::fragment_end)) pieces.push_back(open);
  }
  return pieces;
}

// ---- packets ----

struct Packet {
  uint8_t kind = 0;
  uint8_t number = 0;
  uint16_t pieces = 0;
  Bytes payload;
  uint16_t scan = 0;
  uint8_t channel = 0;

  bool is(detail::wire::PacketKind which) const { return kind == static_cast<uint8_t>(which); }
};

inline Bytes frame_of(const Packet& packet) {
  Bytes frame{0, packet.kind, packet.number, static_cast<uint8_t>(packet.pieces),
              static_cast<uint8_t>(packet.pieces >> 8)};
  for (const uint8_t byte : packet.payload) frame.push_back(byte);
  for (const int byte : {packet.scan & 0xFF, packet.scan >> 8, int{packet.channel}})
    frame.push_back(static_cast<uint8_t>(byte));
  const uint32_t check = crc32(frame.data() + 1, frame.size() - 1);
  for (int i = 0; i < 4; ++i) frame.push_back(static_cast<uint8_t>(check >> 8 * i));
  const size_t plain = frame.size() - 1;
  frame.push_back(0);
  detail::cobs::stuff(frame.data(), plain);
  return frame;
}

/// Limit: a whole frame with its zero.
inline Packet packet_of(Bytes frame) {
  const size_t plain = detail::cobs::unstuff(frame.data(), frame.size() - 1);
  if (plain < detail::wire::packet_head + detail::wire::packet_tail)
    throw std::runtime_error("no packet");
  Packet packet;
  packet.kind = frame[1];
  packet.number = frame[2];
  packet.pieces = static_cast<uint16_t>(frame[3] | frame[4] << 8);
  const size_t tag = 1 + plain - detail::wire::packet_tail;
  packet.payload.assign(frame.begin() + 5, frame.begin() + static_cast<std::ptrdiff_t>(tag));
  packet.scan = static_cast<uint16_t>(frame[tag] | frame[tag + 1] << 8);
  packet.channel = frame[tag + 2];
  return packet;
}

/// Returns the frames of a stream, each with its zero.
inline std::vector<Bytes> frames_of(const Bytes& stream) {
  std::vector<Bytes> frames(1);
  for (const uint8_t byte : stream) {
    frames.back().push_back(byte);
    if (byte == 0) frames.emplace_back();
  }
  frames.pop_back();
  return frames;
}

/// Returns the digest of a trailer behind these frames.
inline uint32_t digest_of(const std::vector<Bytes>& frames) {
  uint32_t digest = 0;
  for (Bytes frame : frames) {
    const size_t plain = detail::cobs::unstuff(frame.data(), frame.size() - 1);
    const uint8_t* const crc = frame.data() + 1 + plain - detail::wire::packet_crc;
    digest = detail::wire::digest_with(
        digest, static_cast<uint32_t>(detail::wire::ByteReader(crc, 4).get(4)));
  }
  return digest;
}

inline Bytes joined(const std::vector<Bytes>& frames) {
  Bytes stream;
  for (const Bytes& frame : frames) stream.insert(stream.end(), frame.begin(), frame.end());
  return stream;
}

/// Returns the stream with a header of another version.
inline Bytes with_version(uint8_t version, const Bytes& stream) {
  std::vector<Bytes> frames = frames_of(stream);
  Packet header = packet_of(frames[0]);
  header.payload[3] = version;
  frames[0] = frame_of(header);
  return joined(frames);
}

// ---- payloads by hand ----

/// The payload of a packet of records, written symbol by symbol with the model.
class Payload {
 public:
  Payload()
      : bytes_(detail::wire::max_payload), model({RangeEncoder(bytes_.data(), bytes_.size())}) {}
  Payload(const Payload&) = delete;
  Payload& operator=(const Payload&) = delete;

  /// Ends the records and the code. Errors: throws if they do not fit.
  Bytes finish() {
    model.record_kind(detail::stream::RecordKind::end);
    return close();
  }
  /// Ends the code without ending the records.
  Bytes close() {
    if (!model.coder().range.fits()) throw std::runtime_error("the payload is too long");
    bytes_.resize(model.coder().range.finish());
    return bytes_;
  }

 private:
  Bytes bytes_;

 public:
  detail::stream::RecordModel<detail::stream::SymbolWriter> model;
};

}  // namespace discmc::test

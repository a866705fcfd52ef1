// The decoder: bytes of a stream in, the events of the scan out.
//
// Any bytes are safe. It never reads beyond what it is given nor writes beyond its own object, it
// allocates nothing, and what was whole is delivered, whatever came before or after.
//
// A decoder takes one stream, up to its trailer. On a link that carries scan after scan push up to
// the next zero byte at a time, which is a frame at most. When push() has answered `ok` and
// report().has_trailer, all events of the scan are out: start() anew for the next one. What comes
// in one push behind a trailer is no part of that stream, and would be missing in the next.
//
// Where the trailer itself is lost the next scan's packets, which have another number, are counted
// as foreign. On a link of one channel begin anew, then, too: finish(), start(), and push the frame
// that was foreign once more. So for SliceDecoder and SurfaceDecoder; examples/link.cpp does it.
#ifndef DISCMC_DECODER_HPP
#define DISCMC_DECODER_HPP

#include <discmc/records_packet.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/normal_encoding.hpp>
#include <discmc/stream/packet_reader.hpp>
#include <discmc/stream/record_reading.hpp>

namespace discmc {

/// What push() came to, and how many of the bytes it took. The rest must be pushed again.
struct [[nodiscard]] Decoded {
  Status status;
  size_t bytes;
};

/// Runs come with the normals where they start, if the stream tells any. It points into itself, so
/// it is neither copied nor moved.
class Decoder {
 public:
  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Begins a stream: the one of the first whole packet that comes on this channel. Packets of
  /// other scans and channels are counted and left alone, so every decoder of a link may get all
  /// bytes. Errors: bad_sink.
  [[nodiscard]] Status start(const Sink& sink, uint8_t channel = any_channel);

  /// Until the next start() packets of whole regions, as RecordsPacket has them, go there in place
  /// of the events of their regions. They come after the scan's start, and between two pieces.
  void set_packet_passthrough(const RecordsPacketSink& sink) { packet_sink_ = sink; }

  /// Takes bytes, any number at a time. Status::suspended: the sink said "not now", push the rest
  /// again, be it none. Status::wrong_version: the header names a version this decoder does not
  /// know; nothing more of this stream is delivered. Errors: also not_started, and bad_sink: the
  /// sink said "never", as an encoder does that was not started, or that gets anything before the
  /// header of its stream. The events of packets that arrive before any header are delivered too.
  Decoded push(const uint8_t* bytes, size_t count);

  /// Tells that no byte follows: an unfinished region or fragment is reported lost.
  /// Status::suspended as push(). Errors: not_started, bad_sink.
  [[nodiscard]] Status finish();

  const StreamHeader& header() const { return packets_.header(); }
  const StreamReport& report() const { return packets_.report(); }

 private:
  // What is under way between two bytes.
  enum class Stage : uint8_t { collect, whole_regions, records, record, mark, packet_mark };

  void open(PacketReader::Completed arrival);
  void pass_whole_regions();
  void lose_open();
  void note_application();
  void note_finish();
  Event& packet_mark(Event::Kind kind);
  void read_record();
  void read_mark(stream::RecordKind kind);
  void read_extension();
  void begin_record();

  bool deliver();
  bool send_start();
  bool deliver_record();
  bool offer(const Event& event) {
    answer_ = sink_.take(sink_.context, event);
    return answer_ == SinkResult::accepted;
  }

  Sink sink_;
  RecordsPacketSink packet_sink_;
  PacketReader packets_;
  bool is_started_ = false;
  bool start_is_sent_ = false;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event

  Stage stage_ = Stage::collect;
  stream::ReadingModel model_;
  stream::Record record_;
  uint32_t sent_words_ = 0;         // words of the record that the sink has taken
  uint32_t sent_runs_ = 0;          // of them runs
  stream::RecordNormals normals_;   // of the record
  bool normals_are_ahead_ = false;  // of the next record
  bool begin_is_due_ = false;
  bool lost_is_due_ = false;
  bool is_first_ring_ = true;
  // What the sink has begun and waits for the next part of.
  struct Open {
    Incidence incidence;
    bool is_fragment;
  };
  Open open_{};
  bool is_open_ = false;
  Event mark_{};
  ApplicationRecord application_;
};

}  // namespace discmc

#endif

// The decoder: bytes of a stream in, events of the scan out.
//
// Any bytes are safe. The decoder never reads beyond its input, never writes beyond its object, and
// allocates nothing. It delivers every region and fragment whose packets all arrive intact.
//
// A decoder decodes one stream, up to its trailer, and only counts later packets. For streams of
// either kind, and for links that carry scan after scan, use a Receiver.
#ifndef DISCMC_DECODER_HPP
#define DISCMC_DECODER_HPP

#include <discmc/status.hpp>
#include <discmc/stream/normal_encoding.hpp>
#include <discmc/stream/packet_reader.hpp>
#include <discmc/stream/record_reading.hpp>
#include <discmc/stream/records_packet.hpp>

namespace discmc {

/// The result of push().
struct [[nodiscard]] Decoded {
  Status status;
  size_t bytes;  ///< the bytes accepted, counted from the first; push only the others again
};

/// Decodes one stream of regions. Runs have the normal at their start if the stream contains
/// normals. A decoder contains pointers to itself, so it is neither copied nor moved.
class Decoder {
 public:
  Decoder() = default;
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;

  /// Prepares to receive a stream. channel: 0 to 63, or any_channel. The first intact packet on the
  /// channel determines the scan. The decoder counts and ignores packets of other scans and
  /// channels, so every decoder of a link may receive all bytes. Errors: bad_sink (no function),
  /// bad_label (another channel).
  [[nodiscard]] Status start(const Sink& sink, uint8_t channel = any_channel);

  /// Sends packets of whole regions (see RecordsPacket) to this sink, instead of the events of
  /// their regions. The packets come after the `start` event, between two regions or fragments.
  /// start() removes the sink, so call this function after start().
  void set_packet_passthrough(const RecordsPacketSink& sink) { packet_sink_ = sink; }

  /// Decodes bytes, any number at a time, and sends the events that they complete. A packet before
  /// the first header is decoded, too; then `start` comes late. Status::suspended: the sink is
  /// busy; call push() again with the remaining bytes, even if there are none. Errors: not_started;
  /// wrong_version (another format version: no byte is accepted until start()); bad_sink (the sink
  /// answered not_started). An encoder answers so before its start(), and before the header of its
  /// stream.
  Decoded push(const uint8_t* bytes, size_t count);

  /// For a Receiver: begins the next scan, with the packet that the reader `before` holds.
  void start_next(const detail::stream::PacketReader& before);
  const detail::stream::PacketReader& packets() const { return packets_; }

  /// Ends the input: an unfinished region or fragment is reported as lost. Without a trailer there
  /// is no `finish` event. Status::suspended: call finish() again. Errors: not_started, bad_sink.
  [[nodiscard]] Status finish();

  /// The header of the stream; all zero until report().has_header.
  const StreamHeader& header() const { return packets_.header(); }
  /// What has arrived and what is missing, since start().
  const StreamReport& report() const { return packets_.report(); }

 private:
  // The work in progress between two bytes.
  enum class Stage : uint8_t { collect, whole_regions, records, record, mark, packet_mark };

  void clear();
  void open(detail::stream::PacketReader::Completed arrival);
  void pass_whole_regions();
  void lose_open();
  void note_application();
  void note_finish();
  Event& packet_mark(Event::Kind kind);
  void read_record();
  void read_mark(detail::stream::RecordKind kind);
  void read_extension();
  void begin_record();

  bool deliver();
  bool send_start();
  bool deliver_record();
  bool offer(const Event& event) {
    answer_ = sink_.accept(sink_.context, event);
    return answer_ == SinkResult::accepted;
  }

  Sink sink_;
  RecordsPacketSink packet_sink_;
  detail::stream::PacketReader packets_;
  bool is_started_ = false;
  bool is_start_sent_ = false;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event

  Stage stage_ = Stage::collect;
  detail::stream::ReadingModel model_;
  detail::stream::Record record_;
  uint32_t sent_words_ = 0;                // words of the record that the sink has accepted
  uint32_t sent_runs_ = 0;                 // runs of the record that the sink has accepted
  detail::stream::RecordNormals normals_;  // of the record
  bool are_normals_ahead_ = false;         // of the next record
  bool is_begin_due_ = false;
  bool is_loss_due_ = false;
  bool is_first_ring_ = true;
  // The piece that the sink has begun to receive.
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

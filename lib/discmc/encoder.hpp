// The encoder: a sink that writes a stream to any byte output.
#ifndef DISCMC_ENCODER_HPP
#define DISCMC_ENCODER_HPP

#include <discmc/checkpoint.hpp>
#include <discmc/records_packet.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/packet_writer.hpp>
#include <discmc/stream/symbol_coders.hpp>

namespace discmc {

/// Writes the stream of one scan. It buffers one packet and one record. The output may stop
/// accepting at any byte: take() then returns busy, and the next take() of the same event
/// continues. An encoder contains pointers to itself, so only save() and restore() copy it.
class Encoder {
 public:
  Encoder() = default;

  /// Also encodes the normals of runs, for the streams to come. Call it before start() and
  /// restore(). Programs without this call do not link the code for normals. Cost: 2 to 3 bytes per
  /// normal; the stream is about five times as long.
  void encode_normals();

  /// Prepares a stream. The `start` event of the extractor supplies the rest of the header, and the
  /// header is the first packet. Each further scan is a further stream with the next scan number.
  /// If a reset may have cut off a frame, send a zero byte first: it ends that frame. start()
  /// during a scan ends the stream abruptly; start the extractor again, too. Errors: bad_label,
  /// bad_sink (no write).
  [[nodiscard]] Status start(const StreamLabel& label, const ByteOutput& output);

  /// Encodes an event of an extractor or decoder. Returns SinkResult::not_started before start(),
  /// and before the `start` event: a stream begins with its header. Returns SinkResult::busy while
  /// the output has not accepted the sealed packet. Cost: a few coding decisions per run, and the
  /// bytes.
  SinkResult take(const Event& event);

  /// Encodes a region in one call, to the same bytes as its events. For hosts: see
  /// HostExtractor::set_region_receiver(). Returns SinkResult::busy if the encoder needs the events
  /// instead: the output is busy, the region does not fit, or the stream has normals.
  SinkResult take_region(const WholeRegion& region);

  /// Sends an application record now, in the order of the stream. Set its slice and row to
  /// extractor.slices() and rows(). Status::suspended: the output is busy, or a region is in
  /// progress; call resume() of the extractor, then call this again. Errors: not_started, finished,
  /// bad_record.
  [[nodiscard]] Status write_record(const ApplicationRecord& record);

  /// Sends a packet of records that another encoder of the same surface has made, unchanged.
  /// Packets that share a piece must follow each other. Limit: wire::max_payload bytes, or
  /// wire::max_whole_regions if the packet is whole. Status::suspended: as write_record(). Errors:
  /// not_started, finished, bad_record. Cost: the bytes.
  [[nodiscard]] Status append(const RecordsPacket& packet);

  /// Continues with another output, and repeats the header for a late receiver. Without a write
  /// function the encoder drops the stream but counts its bytes, so that a scan continues while its
  /// link is dead. Limit: after start().
  void set_output(const ByteOutput& output);

  /// Sends an incomplete packet instead of waiting for a full one; costs some bytes of stream.
  /// Returns false if the output did not accept all of it: call again. Does nothing before start().
  [[nodiscard]] bool flush();

  /// Saves the encoder's state, at the beginning of a frame; restore() may send that frame again.
  /// Errors: not_started. Cost: a checksum of the object.
  [[nodiscard]] Status save(Checkpoint<Encoder>& checkpoint) const;

  /// Restores a saved state; bytes() is the length of the stream up to it. Errors: bad_checkpoint,
  /// bad_sink (no write). Cost: as save().
  [[nodiscard]] Status restore(const Checkpoint<Encoder>& checkpoint, const ByteOutput& output);

  /// Resumes a stream whose object was restored byte for byte in place, as in C. Call it instead of
  /// restore(). Limit: the bytes are unchanged. Errors: bad_sink (no write).
  [[nodiscard]] Status resume_in_place(const ByteOutput& output);

  /// The bytes of stream so far, including those dropped without an output. The difference between
  /// two calls of set_output() is the number of dropped bytes.
  uint64_t bytes() const { return packets_.bytes(); }

  /// For CheckpointHead::layout.
  static constexpr uint32_t layout = sizeof(void*) << 4;

 private:
  friend struct Checkpoint<Encoder>;
  Encoder(const Encoder&) = default;
  Encoder& operator=(const Encoder&) = default;

  using Record = stream::Record;
  using Model = stream::RecordModel<stream::SymbolWriter>;

  enum class State : uint8_t {
    idle,      // no scan has begun
    between,   // no region or fragment is in progress
    in_piece,  // one is, and the record collects its rings and runs
    in_parts,  // one is, but the record is being sent in parts and accepts nothing
    ended,     // the trailer is sealed
  };

  SinkResult begin_stream(const StreamHeader& scan);
  SinkResult take_other(const Event& event);
  // Whether the record accepts this many words.
  bool takes(uint32_t words) const { return state_ != State::in_parts && record_.has_room(words); }
  void add_run(const Event& event) {
    normals_[record_.count] = event.normal;
    record_.add_run(event.run);
  }
  bool put_parts(const Event& event);
  bool put(const Event& event);
  bool fill_packet(const Event& event);
  bool encode_whole(Model& model, const Event& event);
  Status ready_for_packet(bool is_good);

  bool packet_is_empty() const { return model_.coder().range.is_empty(); }
  static bool fits(const Model& model);
  void open_packet();
  void seal_records();
  bool drain();

  // Small members come first, within reach of short instructions.
  State state_ = State::idle;
  Model model_;
  // Encodes the normals of the record's first words; null without normals.
  void (*write_normals_)(Encoder& encoder, Model& model, uint32_t words) = nullptr;
  Record record_;
  OctahedralNormal normals_[Record::max_words] = {};  // by the word of the record
  PacketWriter packets_;
};

}  // namespace discmc

#endif

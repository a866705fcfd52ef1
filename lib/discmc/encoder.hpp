// The encoder: a sink that writes the stream into any byte-out function.
#ifndef DISCMC_ENCODER_HPP
#define DISCMC_ENCODER_HPP

#include <discmc/checkpoint.hpp>
#include <discmc/records_packet.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/packet_writer.hpp>
#include <discmc/stream/symbol_coders.hpp>

namespace discmc {

/// Writes the stream of one scan. One packet and one record are all that is held. The encoder may
/// be suspended after any byte: while the output takes nothing, take() answers busy, and goes on
/// where it was when asked again. It points into itself, so it is neither copied nor moved, but by
/// save() and restore().
class Encoder {
 public:
  Encoder() = default;

  /// Encodes the normals of runs, too; without this call they are left out. Call it before start()
  /// and restore(). Programs without this call do not link the code for normals. Cost: 2 to 3 bytes
  /// per normal; the stream is about four times as long.
  void encode_normals();

  /// Gets ready for a scan: the stream begins with the extractor's start, which tells the rest of
  /// its header, the first packet. A further scan is a further stream; its number is one more.
  /// Where a reset may have cut off a frame, send a zero byte first: it ends the frame, and is
  /// none. In the middle of a scan this breaks its stream off: start the extractor anew, too.
  /// Errors: bad_label, bad_sink (no write).
  [[nodiscard]] Status start(const StreamLabel& label, const ByteOutput& output);

  /// Takes an event of the extractor (or of a decoder). SinkResult::not_started before start(), and
  /// before the start of a scan: a stream begins with its header. SinkResult::busy while the output
  /// has not taken what was sealed before. Cost: a few decisions a run, and the bytes.
  SinkResult take(const Event& event);

  /// Sends an application record now, in the order of the stream. Its slice and row are the
  /// caller's to fill in: extractor.slices() and rows(). Status::suspended: the output takes
  /// nothing now, or a region is on its way: resume() the extractor and call again. Errors:
  /// not_started, finished, bad_record.
  [[nodiscard]] Status write_record(const ApplicationRecord& record);

  /// Sends a packet of records that another encoder of the same surface has made, as it is. The
  /// parts of a piece that goes through several packets must follow each other. Limit:
  /// wire::max_payload bytes, or wire::max_whole_regions where it is whole. Status::suspended: as
  /// of write_record(). Errors: not_started, finished, bad_record. Cost: the bytes.
  [[nodiscard]] Status append(const RecordsPacket& packet);

  /// Goes on with another output, and with a header, so that a receiver may come late. Without a
  /// function the stream is dropped, but counted: so a scan goes on though its link is dead, and
  /// stream there is again once it has an output. Limit: start().
  void set_output(const ByteOutput& output);

  /// Hands over what is there so far instead of waiting for a full packet; costs some bytes of
  /// stream. False when the output does not take all of it now: call again. Nothing before start().
  [[nodiscard]] bool flush();

  /// Writes down where the stream is: at the beginning of a frame, which restore() may thus send
  /// once more. Errors: not_started. Cost: a checksum of the object.
  [[nodiscard]] Status save(Checkpoint<Encoder>& checkpoint) const;

  /// Goes on where a checkpoint was saved; bytes() says how many bytes of stream were before.
  /// Errors: bad_checkpoint, bad_sink (no write). Cost: as save().
  [[nodiscard]] Status restore(const Checkpoint<Encoder>& checkpoint, const ByteOutput& output);

  /// Goes on as restore() does, where the bytes of this object itself have been read back: for
  /// objects that are saved where they lie, as those of C. Limit: they are as they were. Errors:
  /// bad_sink (no write).
  [[nodiscard]] Status continue_to(const ByteOutput& output);

  /// The bytes of stream so far: what the output has taken, and what was dropped without one. How
  /// many those are is what this has grown by between the two calls of set_output().
  uint64_t bytes() const { return packets_.bytes(); }

  /// Of what a checkpoint holds: see CheckpointHead.
  static constexpr uint32_t layout = sizeof(void*) << 4;

 private:
  friend struct Checkpoint<Encoder>;
  Encoder(const Encoder&) = default;
  Encoder& operator=(const Encoder&) = default;

  using Record = stream::Record;
  using Model = stream::RecordModel<stream::SymbolWriter>;

  enum class State : uint8_t {
    idle,      // no scan has begun
    between,   // no region or fragment is under way
    in_piece,  // one is, and the record takes its rings and runs
    in_parts,  // one is, but the record is being sent in parts and takes nothing
    ended,     // the trailer is sealed
  };

  SinkResult begin_stream(const StreamHeader& scan);
  SinkResult take_other(const Event& event);
  // Whether the record has room for so many words and takes them.
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

  // Small members stand first, where they are reached by short instructions.
  State state_ = State::idle;
  Model model_;
  // Encodes the normals of the record's first words; null where they are left out.
  void (*write_normals_)(Encoder& encoder, Model& model, uint32_t words) = nullptr;
  Record record_;
  OctahedralNormal normals_[Record::max_words] = {};  // by the word of the record
  PacketWriter packets_;
};

}  // namespace discmc

#endif

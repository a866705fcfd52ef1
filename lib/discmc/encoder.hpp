// The encoder: a sink that writes a stream to any byte output.
#ifndef DISCMC_ENCODER_HPP
#define DISCMC_ENCODER_HPP

#include <discmc/checkpoint.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/packet_writer.hpp>
#include <discmc/stream/records_packet.hpp>
#include <discmc/stream/symbol_coders.hpp>

namespace discmc {

/// Writes one stream per scan. The encoder buffers one packet and one record. The output may stop
/// accepting at any byte: accept() then returns busy, and the next accept() of the same event
/// continues there. An encoder contains pointers to itself, so it is not copied.
class Encoder {
 public:
  Encoder() = default;

  /// Also encodes the normals of runs, in all later streams. Call it before start() and after
  /// restore().
  /// Programs without this call do not link the code for normals. Cost: 2 to 3 bytes per normal;
  /// the stream is about five times as long.
  void encode_normals();

  /// Prepares a stream. The `start` event of the extractor supplies the rest of its header, which
  /// is the first packet. Each further scan of the extractor becomes a further stream with the next
  /// scan number. start() during a scan ends the stream without a trailer; start the extractor
  /// again, too. If a reset of the device may have cut off a frame, send a zero byte to the link
  /// first: it ends that frame. Errors: bad_label (the channel), bad_sink (no write function).
  [[nodiscard]] Status start(const StreamLabel& label, const ByteOutput& output);

  /// Encodes an event of an extractor or decoder. Returns SinkResult::not_started before start(),
  /// and before the `start` event: a stream begins with its header. Returns SinkResult::busy while
  /// a finished packet waits for the output. Cost: a few coding decisions per run, and the bytes.
  SinkResult accept(const Event& event);

  /// Sends an application record now, in the order of the stream. Set its slice and row to slices()
  /// and rows() of the extractor. Status::suspended: nothing is sent, because the output is busy or
  /// a region is in progress; call resume() of the extractor, then write_record() again. Errors:
  /// not_started, finished, bad_record (too long).
  [[nodiscard]] Status write_record(const ApplicationRecord& record);

  /// Sends a packet that another encoder of the same surface made, unchanged (records_packet.hpp).
  /// Packets that share a region or fragment must follow each other. Status::suspended: as
  /// write_record(). Errors: not_started, finished, bad_record (more than 243 bytes, or 241 if the
  /// packet is whole, or more than 65,535 pieces). Cost: a copy.
  [[nodiscard]] Status append(const RecordsPacket& packet);

  /// Continues with another output, and repeats the header, so that a new receiver can join. The
  /// rest of a frame in progress goes to the new output. Without a write function the encoder drops
  /// the stream but counts its bytes, so that a scan can continue while its link is dead. Limit:
  /// after start().
  void set_output(const ByteOutput& output);

  /// Sends the packet in progress although it is not full, for a receiver that must not wait.
  /// Without a stream it does nothing. Status::suspended: the output did not accept all of it, call
  /// again. Cost: at least 15 bytes of stream per packet sent.
  [[nodiscard]] Status flush();

  /// Seals the encoder's state, and sets parts[0] to its bytes: this object. Copy them before the
  /// next call (checkpoint.hpp). Status::suspended: the output has unsent bytes, call again.
  /// Errors: not_started, bad_sink (the output has no unsent()). Cost: a checksum of the object.
  [[nodiscard]] Status save(Memory* parts);

  /// Continues from the part of save(), which was read back into this object. The frame that was
  /// being sent is sent again; bytes() is the length of the stream before it. Errors:
  /// bad_checkpoint, bad_sink (no write function). After an error read the part back again, or call
  /// start(). Cost: as save().
  [[nodiscard]] Status restore(const ByteOutput& output);

  /// The bytes of stream so far, including bytes that were dropped because there was no output. The
  /// growth from set_output({}) to the next set_output() is the number of dropped bytes.
  uint64_t bytes() const { return packets_.bytes(); }

  /// Differs between builds; for discmc.h.
  static constexpr uint32_t layout = sizeof(void*) << 4;

 private:
  Encoder(const Encoder&) = default;
  Encoder& operator=(const Encoder&) = default;

  using Record = detail::stream::Record;
  using Model = detail::stream::RecordModel<detail::stream::SymbolWriter>;

  enum class State : uint8_t {
    idle,      // no scan has begun
    between,   // no region or fragment is in progress
    in_piece,  // one is, and the record collects its rings and runs
    in_parts,  // one is, but the record is being sent in parts and accepts nothing
    ended,     // the trailer is sealed
  };

  SinkResult begin_stream(const StreamHeader& scan);
  SinkResult accept_other(const Event& event);
  // Whether the record accepts this many words.
  bool has_room_for(uint32_t words) const {
    return state_ != State::in_parts && record_.has_room(words);
  }
  void add_run(const Event& event) {
    normals_[record_.count] = event.normal;
    record_.add_run(event.run);
  }
  bool put_parts(const Event& event);
  bool put(const Event& event);
  bool fill_packet(const Event& event);
  bool encode_whole(Model& model, const Event& event);
  Status ready_for_packet(bool is_good);
  Status put_application(const ApplicationRecord& record);

  bool is_packet_empty() const { return model_.coder().range.is_empty(); }
  bool fits(const Model& model) const;
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
  detail::stream::PacketWriter packets_;
  detail::Seal seal_;
};

}  // namespace discmc

#endif

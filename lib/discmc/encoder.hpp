// The encoder: a sink that writes the stream into any byte-out function.
#ifndef DISCMC_ENCODER_HPP
#define DISCMC_ENCODER_HPP

#include <discmc/checkpoint.hpp>
#include <discmc/records_packet.hpp>
#include <discmc/status.hpp>
#include <discmc/stream/normal_encoding.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

/// The bits of a symbol, encoded where they are decided.
class SymbolCoder {
 public:
  explicit SymbolCoder(RangeEncoder& range) : range_(range) {}
  bool code_bit(uint32_t context, bool bit) noexcept {
    range_.encode(bit, region_model[context]);
    return bit;
  }
  bool code_bit(context::Even, bool bit) noexcept {
    range_.encode_even(bit);
    return bit;
  }

 private:
  RangeEncoder::Bits range_;
};

/// Writes the stream of one scan. One packet and one record are all that is held. The encoder may
/// be suspended after any byte: while the output takes nothing, take() answers not_now, and goes on
/// where it was when asked again. Use it as Encoder, or as NormalEncoder where the normals of runs
/// are to be told too; a stream without any is the same from both. It points into itself, so it is
/// neither copied nor moved, but by save() and restore(). max_payload: of a packet. Units: bytes.
template <class Normals, size_t max_payload = wire::max_payload>
class BasicEncoder : private Normals {
 public:
  BasicEncoder() = default;

  /// Gets ready for a scan: the stream begins with the extractor's start, which tells the rest of
  /// its header, the first packet. A further scan is a further stream; its number is one more.
  /// Where a reset may have cut off a frame, send a zero byte first: it ends the frame, and is
  /// none. In the middle of a scan this breaks its stream off: start the extractor anew, too.
  /// Errors: bad_label, bad_sink (no write).
  [[nodiscard]] Status start(const StreamLabel& label, const ByteOutput& output);

  /// Takes an event of the extractor (or of a decoder). Answer::never before start(), and before
  /// the start of a scan: a stream begins with its header. Answer::not_now while the output has not
  /// taken what was sealed before.
  /// Cost: a few decisions a run, and the bytes.
  Answer take(const Event& event) {
    // Most events: on a host they are worth a shortcut.
    if constexpr (is_host) {
      if (only_waits(event)) {
        add_run(event);
        return Answer::taken;
      }
    }
    return take_any(event);
  }

  /// Sends an application record now, in the order of the stream. Its slice and row are the
  /// caller's to fill in: extractor.slices() and rows(). Status::more: the output takes nothing
  /// now, or a region is on its way: resume() the extractor and call again. Errors: not_started,
  /// finished, bad_record.
  [[nodiscard]] Status tell(const ApplicationRecord& record);

  /// Sends a packet of records that a PartEncoder of the same surface has made, as it is. The
  /// parts of a piece that goes through several packets must follow each other. Status::more: as of
  /// tell(). Errors: not_started, finished, bad_record. Cost: the bytes.
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
  [[nodiscard]] Status save(Checkpoint<BasicEncoder>& checkpoint) const;

  /// Goes on where a checkpoint was saved; bytes() says how many bytes of stream were before.
  /// Errors: bad_checkpoint, bad_sink (no write). Cost: as save().
  [[nodiscard]] Status restore(const Checkpoint<BasicEncoder>& checkpoint,
                               const ByteOutput& output);

  /// Goes on as restore() does, where the bytes of this object itself have been read back: for
  /// objects that are saved where they lie, as those of C. Limit: they are as they were. Errors:
  /// bad_sink (no write).
  [[nodiscard]] Status continue_to(const ByteOutput& output);

  /// The bytes of stream so far: what the output has taken, and what was dropped without one. How
  /// many those are is what this has grown by between the two calls of set_output().
  uint64_t bytes() const { return packets_.bytes(); }

  /// Of what a checkpoint holds: see CheckpointHead.
  static constexpr uint32_t layout = sizeof(void*) << 4 | (Normals::are_told ? 1 : 0);

 private:
  friend struct Checkpoint<BasicEncoder>;
  BasicEncoder(const BasicEncoder&) = default;
  BasicEncoder& operator=(const BasicEncoder&) = default;

  struct Coder {
    RangeEncoder range;
    bool code_bit(uint32_t context, bool bit) {
      tell(context, bit);
      return bit;
    }
    void tell(uint32_t context, bool bit);
    // Firmware is smaller without.
    friend decltype(auto) symbol_coder(Coder& coder) {
      if constexpr (is_host)
        return SymbolCoder(coder.range);
      else
        return (coder);
    }
  };
  using Model = RegionModel<Coder>;

  // Whether it is a run, and an encoder that is started and idle has room for it.
  bool only_waits(const Event& event) const {
    return event.kind == Event::Kind::run && record_.has_room(1) && packets_.is_open() &&
           !is_emptying_ && packets_.is_started();
  }
  Answer take_any(const Event& event);
  Answer begin_stream(const StreamHeader& scan);
  bool put(const Event& event);
  bool encode_whole(const Event& event);
  bool encode_part(uint32_t& words, Event::Kind cause);
  bool put_trailer(const Event& event);
  void add_run(const Event& event) {
    if constexpr (Normals::are_told) Normals::set(record_.count, event.normal);
    record_.add_run(event.run);
  }
  void drop(uint32_t words);
  void encode_normals(uint32_t words);

  bool fits(size_t reserve) const;
  void open_packet();
  void seal_records();
  bool drain();

  // Small members stand first, where they are reached by short instructions.
  bool packet_is_empty_ = false;
  bool piece_is_open_ = false;  // it has begun and not ended
  bool is_emptying_ = false;    // the record is on its way out in parts, and takes nothing
  Model model_;
  Record record_;
  PacketWriter packets_;
};

extern template class BasicEncoder<NoRecordNormals>;
extern template class BasicEncoder<RecordNormals>;
extern template class BasicEncoder<NoRecordNormals, wire::max_appended>;

using Encoder = BasicEncoder<NoRecordNormals>;
/// A normal takes 2 to 3 bytes, and a stream with them about four times the bytes of one without.
/// The object has 192 bytes more.
using NormalEncoder = BasicEncoder<RecordNormals>;
/// Of a part of a scan: its packets go to append() of one of the two above.
using PartEncoder = BasicEncoder<NoRecordNormals, wire::max_appended>;

}  // namespace discmc

#endif

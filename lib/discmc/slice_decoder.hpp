// The slice decoder: bytes of a stream of slices in, rows of bits out.
//
// Any bytes are safe. The decoder never reads beyond its input, never writes beyond its object and
// its memory, and allocates nothing. After a loss it continues at the next key slice, and reports
// the missing rows as lost. It decodes one stream. For polygons instead of rows, and for links that
// carry scan after scan, use a Receiver.
#ifndef DISCMC_SLICE_DECODER_HPP
#define DISCMC_SLICE_DECODER_HPP

#include <discmc/decoder.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/slices/coded_surfaces.hpp>
#include <discmc/slices/fraction_code.hpp>
#include <discmc/slices/row_coders.hpp>

namespace discmc {

/// One event of a SliceDecoder: the start, every row of the scan in order, and the end. With
/// several surfaces, each row comes once per surface, in the order of their channels. Only the
/// members that the kind names are valid.
struct RowEvent {
  enum class Kind : uint8_t {
    start,        ///< the first event: header
    row,          ///< slice, row, channel, bits
    fractions,    ///< before the row that has them: slice, row, channel, fractions
    skipped,      ///< a row that the encoder never received: slice, row, channel, is_repeated, and
                  ///< the bits that replace the row
    lost,         ///< rows of all surfaces that were lost in transit: count, and slice and row of
                  ///< the first
    application,  ///< an application record: application
    finish,       ///< the last event: slice (the number of slices), is_abandoned
  };
  Kind kind;
  bool is_repeated;  ///< the row was replaced by the previous row
  bool is_abandoned;
  uint8_t channel;
  uint32_t slice;
  uint32_t row;
  uint64_t count;  ///< of lost rows per surface
  /// Owner: the decoder; valid during the call.
  union {
    const uint8_t* bits;  ///< (width + 7) / 8 bytes, eight voxels per byte, the first in bit 0
    const StreamHeader* header;
    const ApplicationRecord* application;
    const uint16_t* fractions;  ///< one entry per voxel: fraction_of() in fraction.hpp
  };
};

/// A sink of rows; the rules of Sink (sink.hpp) hold. Owner: the context belongs to the caller and
/// must outlive the decoder.
struct RowSink {
  void* context = nullptr;
  SinkResult (*accept)(void* context, const RowEvent& event) = nullptr;
};

/// Returns a row sink that calls `object.accept(event)`. Owner: the object must outlive the sink.
template <class Object>
RowSink make_row_sink(Object& object) {
  return {&object, [](void* context, const RowEvent& event) {
            return static_cast<Object*>(context)->accept(event);
          }};
}

/// Decodes one stream of slices, and sends its rows to a RowSink. A decoder contains pointers to
/// itself, so it is neither copied nor moved.
class SliceDecoder {
 public:
  /// The memory for slices of this size. levels: of fractions, as in the header. Limit: valid
  /// limits.
  static constexpr uint64_t minimum_bytes(const Limits& limits, uint32_t surfaces = 1,
                                          uint32_t levels = 0) {
    return SliceEncoder::minimum_bytes({limits, {}, 0, static_cast<uint8_t>(surfaces)}) +
           Arena::bytes_of((limits.width + 7) / 8, sizeof(uint8_t)) +
           (levels == 0 ? 0
                        : detail::slices::Fractions::bytes_for(limits, surfaces, levels) +
                              Arena::bytes_of(limits.width, sizeof(uint16_t)));
  }

  SliceDecoder() = default;
  SliceDecoder(const SliceDecoder&) = delete;
  SliceDecoder& operator=(const SliceDecoder&) = delete;

  /// Prepares to receive a stream, and to deliver the rows of all its surfaces. memory: at least
  /// minimum_bytes() for the size and the number of surfaces in the header; {} while they are
  /// unknown, see set_memory(). Owner: the caller, while the decoder is in use. channel: the
  /// channel of any surface of the stream; any_channel: the first stream that arrives. Errors:
  /// bad_sink (no function), bad_label (a channel above 63).
  [[nodiscard]] Status start(Memory memory, const RowSink& sink, uint8_t channel = any_channel);

  /// Decodes bytes, any number at a time. Status::suspended: the sink is busy; call push() again
  /// with the remaining bytes, even if there are none. Errors: not_started; bad_sink (the sink
  /// answered not_started); wrong_version (no byte is accepted until start()); too_little_memory
  /// (call set_memory(), then push the remaining bytes). Packets before the first header are
  /// dropped; their rows count as lost. A stream of regions delivers nothing: report().holds_slices
  /// is false. Cost: the coding decisions of SliceEncoder::push().
  Decoded push(const uint8_t* bytes, size_t count);

  /// After too_little_memory: continues with this memory, at least minimum_bytes(). Does
  /// nothing at any other time. Owner: as of start(). Errors: not_started, too_little_memory,
  /// wrong_version.
  [[nodiscard]] Status set_memory(Memory memory);

  /// For a Receiver: as Decoder::start_next().
  void start_next(const detail::stream::PacketReader& before);
  const detail::stream::PacketReader& packets() const { return packets_; }

  /// Ends the input; without a trailer there is no `finish` event. Status::suspended: call finish()
  /// again. Errors: as push().
  [[nodiscard]] Status finish();

  /// The header of the stream; all zero until report().has_header.
  const StreamHeader& header() const { return packets_.header(); }
  /// What has arrived and what is missing, since start().
  const StreamReport& report() const { return packets_.report(); }

 private:
  // Between two bytes.
  enum class Stage : uint8_t { collect, start, lose, read, deliver_rows, application, finish };

  void clear();
  void open(detail::stream::PacketReader::Completed arrival);
  void lay_out();
  void clear_rows();
  void open_slices();
  bool begin_key_slice();
  void wait_for_key_slice();
  void read();
  bool can_read() const;
  bool is_at_cut() const;
  bool begin_row();
  bool read_step();
  void begin_fractions();
  bool is_row_done() const { return row_.is_done() && fraction_code_.is_done(); }
  bool read_note();
  bool deliver();
  bool deliver_rows();
  bool report_loss();
  bool offer(RowEvent::Kind kind);

  RowSink sink_;
  Memory memory_;
  detail::stream::PacketReader packets_;
  Stage stage_ = Stage::collect;
  bool is_started_ = false;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event
  Status refusal_ = Status::ok;               // of the stream's contents
  bool is_laid_out_ = false;
  bool is_whole_ = false;      // nothing is lost since the last key slice began
  bool is_key_ahead_ = false;  // the next row is the first of a key slice
  bool is_code_over_ = false;  // its last packet has come
  bool is_row_begun_ = false;
  uint8_t rest_bytes_ = 0;
  uint8_t rest_[detail::wire::packet_head];  // of the code, before the next packet of it
  uint8_t surface_ = 0;                      // whose row is read
  detail::slices::RowNote note_ = detail::slices::RowNote::none;
  uint32_t cut_row_ = 0;   // where the code is cut: in this row of those of all surfaces
  uint32_t cut_left_ = 0;  // what is left of its part behind the cut
  bool has_cut_ = false;
  uint32_t slice_ = 0;
  uint32_t next_slice_ = 0;   // after what is lost
  uint64_t lost_rows_ = 0;    // not yet reported
  uint64_t passed_rows_ = 0;  // handed out or lost
  detail::slices::RowReader coder_;
  detail::slices::RowCode row_;
  detail::slices::CodedSurfaces surfaces_;
  uint8_t* bits_ = nullptr;
  detail::slices::Fractions fractions_;
  uint16_t* fractions_of_row_ = nullptr;
  detail::slices::FractionCode fraction_code_;
  bool is_slice_before_known_ = false;   // of a key slice
  uint8_t surfaces_with_fractions_ = 0;  // to be handed out: a bit per surface
};

}  // namespace discmc

#endif

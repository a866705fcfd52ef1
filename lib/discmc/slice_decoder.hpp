// The slice decoder: bytes of a stream of slices in, rows out.
//
// Any bytes are safe. It never reads beyond what it is given nor writes beyond its object and its
// memory, it allocates nothing, and what was whole is handed out, whatever came before or after.
#ifndef DISCMC_SLICE_DECODER_HPP
#define DISCMC_SLICE_DECODER_HPP

#include <discmc/decoder.hpp>
#include <discmc/slice_encoder.hpp>
#include <discmc/slices/row_coders.hpp>
#include <discmc/slices/surfaces.hpp>

namespace discmc {

/// What a SliceDecoder hands out: every row of a scan in its order, of each surface in turn, and
/// its end. Only the members that its kind names have a meaning.
struct RowEvent {
  enum class Kind : uint8_t {
    start,    ///< the first event: header
    row,      ///< slice, row, channel, bits
    skipped,  ///< it never came to the encoder: as row, with bits that stand in for it; repeated
    lost,     ///< so many rows of all were lost on the way: slice, row (of the first), count
    application,  ///< the user's own data: application
    finish,       ///< the last event: slice (how many), abandoned
  };
  Kind kind;
  bool repeated;  ///< the row before stands in, not a row that is off
  bool abandoned;
  uint8_t channel;
  uint32_t slice;
  uint32_t row;
  uint64_t count;
  /// Owner: the decoder; valid during the call.
  union {
    const uint8_t* bits;  ///< eight voxels a byte, the first in bit 0
    const StreamHeader* header;
    const ApplicationRecord* application;
  };
};

/// Where rows go. Owner: the context belongs to the caller and must outlive the decoder.
struct RowSink {
  void* context = nullptr;
  SinkResult (*take)(void* context, const RowEvent& event) = nullptr;
};

/// A row sink that calls `receiver.take(event)`. Owner: the receiver must outlive the sink.
template <class Receiver>
RowSink row_sink_to(Receiver& receiver) {
  return {&receiver, [](void* context, const RowEvent& event) {
            return static_cast<Receiver*>(context)->take(event);
          }};
}

/// Reads one stream of slices, and hands its rows to a RowSink. It points into itself, so it is
/// neither copied nor moved.
class SliceDecoder {
 public:
  SliceDecoder() = default;
  SliceDecoder(const SliceDecoder&) = delete;
  SliceDecoder& operator=(const SliceDecoder&) = delete;

  /// Begins a stream. memory: at least slice_decoder_bytes() for the size and the surfaces that the
  /// header will tell, or none before it is known; Owner: the caller, as long as the decoder is
  /// used. channel: as of the Decoder; the rows of all surfaces of its stream are handed out.
  /// Errors: bad_sink.
  [[nodiscard]] Status start(Memory memory, const RowSink& sink, uint8_t channel = any_channel);

  /// Takes bytes, any number at a time. Status::suspended: the sink said "not now", push the rest
  /// again. Status::wrong_version: as of the Decoder. Status::too_little_memory: the header tells
  /// of larger slices than the memory serves: give_memory(), and push the rest. Errors: also
  /// not_started, and bad_sink (the sink said "never"). Packets that arrive before any header are
  /// lost. Of a stream of regions nothing is handed out: report().holds_slices says what it is.
  /// Cost: as the encoder's.
  Decoded push(const uint8_t* bytes, size_t count);

  /// Goes on with other memory, of slice_decoder_bytes(), after Status::too_little_memory; at
  /// any other time it does nothing. Errors: not_started, too_little_memory, wrong_version.
  [[nodiscard]] Status give_memory(Memory memory);

  /// Tells that no byte follows. Status::suspended and errors as push().
  [[nodiscard]] Status finish();

  const StreamHeader& header() const { return packets_.header(); }
  const StreamReport& report() const { return packets_.report(); }

 private:
  // Between two bytes.
  enum class Stage : uint8_t { collect, start, lose, read, hand_out, application, finish };

  void open(PacketReader::Completed arrival);
  void lay_out();
  void open_slices();
  bool begin_key_slice();
  void give_up();
  void read();
  bool can_read() const;
  bool is_at_cut() const;
  bool begin_row();
  bool read_note();
  bool deliver();
  bool hand_out();
  bool report_loss();
  bool offer(RowEvent::Kind kind);

  RowSink sink_;
  Memory memory_;
  PacketReader packets_;
  Stage stage_ = Stage::collect;
  bool is_started_ = false;
  SinkResult answer_ = SinkResult::accepted;  // of the sink, to the last event
  Status refusal_ = Status::ok;               // of what the stream holds
  bool is_laid_out_ = false;
  bool is_whole_ = false;      // nothing is lost since the last key slice began
  bool is_key_ahead_ = false;  // the next row is the first of a key slice
  bool code_is_over_ = false;  // its last packet has come
  bool row_is_begun_ = false;
  uint8_t rest_bytes_ = 0;
  uint8_t rest_[wire::packet_head];  // of the code, before the next packet of it
  uint8_t surface_ = 0;              // whose row is read
  slices::RowNote note_ = slices::RowNote::none;
  uint32_t cut_row_ = 0;   // where the code is cut: in this row of those of all surfaces
  uint32_t cut_left_ = 0;  // before so many of its voxels; 0 where it is not
  uint32_t slice_ = 0;
  uint32_t next_slice_ = 0;   // after what is lost
  uint64_t lost_rows_ = 0;    // to be told
  uint64_t passed_rows_ = 0;  // handed out or lost
  slices::RowReader coder_;
  slices::RowCode row_;
  slices::Surfaces surfaces_;
  uint8_t* bits_ = nullptr;
};

}  // namespace discmc

#endif

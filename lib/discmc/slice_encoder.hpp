// The slice encoder: samples in, a stream of slices out. For a device that leaves the surface to
// whoever receives it.
//
//   start(header, key_slices, memory, output)
//   push(samples, count)      as often as samples arrive, any number at a time
//   resume()                  after Status::suspended, when the output may take again
//   finish()                  after the last slice
//
// Every voxel is told by its neighbours, and what they say of it is learnt on the way (WIRE.md,
// "Slices"). The stream of a CT head is a tenth of that of its regions, in a quarter of the
// instructions. But the receiver must extract the surface, in as much memory as the device would
// have needed; and what is lost on the way costs all slices up to the next key slice.
#ifndef DISCMC_SLICE_ENCODER_HPP
#define DISCMC_SLICE_ENCODER_HPP

#include <discmc/arena.hpp>
#include <discmc/checkpoint.hpp>
#include <discmc/row_input.hpp>
#include <discmc/slices/row_code.hpp>
#include <discmc/slices/row_coders.hpp>
#include <discmc/slices/surfaces.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

// ---- How often a stream of slices can be begun, and what memory its two ends need.

/// How often a slice is told without the ones before, so that a receiver who has lost some, or who
/// comes late, may begin.
struct KeySlices {
  /// The slices from one key slice to the next; 0 where only the first is one. A packet that is
  /// lost takes the slices up to the next key slice with it, so about half of the interval.
  ///
  /// For an interval take the loss that you can bear, no less than what fills a packet: a slice of
  /// a CT head takes about 200 bytes, so 16 slices are 13 packets, and the stream is 4 % longer
  /// than with one key slice; 8 slices: 8 %, 4 slices: 16 %. 1 takes least memory, but longer
  /// streams: the CT head 62 %, an engine 83 %, a ball, of which a slice says nearly all of the
  /// next, 253 %.
  uint32_t interval = 0;

  constexpr bool is_every() const { return interval == 1; }
  constexpr bool is_key(uint32_t slice) const {
    return slice == 0 || (interval > 0 && slice % interval == 0);
  }
};

namespace slices {

/// The bytes of the rows and probabilities of some surfaces.
constexpr uint64_t surface_bytes(const Limits& limits, uint32_t rows, uint32_t surfaces) {
  uint64_t bytes = 0;
  for (uint32_t surface = 0; surface < surfaces; ++surface)
    bytes += trace::bit_row_bytes(limits.width, rows) + SliceModel::bytes_for(surface > 0);
  return bytes;
}

}  // namespace slices

/// The bytes of memory that a SliceEncoder needs (FOOTPRINT.md has a table). For every surface four
/// rows of bits and one more where every slice is a key slice, else those of a slice and three; and
/// 548 bytes for the first surface, 1,060 for each further one. Limit: valid limits.
constexpr uint64_t slice_encoder_bytes(const Limits& limits, KeySlices key_slices,
                                       uint32_t surfaces = 1) {
  const uint32_t rows = slices::rows_kept(limits.height, key_slices.is_every());
  return slices::surface_bytes(limits, rows, surfaces) + Arena::alignment - 1;
}

/// The bytes of memory that a SliceDecoder needs for slices of this size. Limit: valid limits.
constexpr uint64_t slice_decoder_bytes(const Limits& limits, uint32_t surfaces = 1) {
  return slice_encoder_bytes(limits, KeySlices{}, surfaces) +
         Arena::bytes_of((limits.width + 7) / 8, sizeof(uint8_t));
}

// ---- The encoder.

/// Takes the samples of a scan, and writes one stream of the bits of its surfaces. It points into
/// itself, so it is neither copied nor moved, but by save() and restore().
class SliceEncoder {
 public:
  SliceEncoder() = default;

  /// Begins a scan and its stream; the header is the first packet, and its thresholds those of the
  /// samples. Where it has several surfaces each gets all samples; bits of the further ones are
  /// told by those of the first, so let that be the one that the others are like. memory: at least
  /// slice_encoder_bytes(); Owner: the caller, for as long as the scan lasts. After a reset send a
  /// zero byte first, as with Encoder::start(). Errors: bad_limits, bad_label, bad_sink (no write),
  /// too_little_memory.
  [[nodiscard]] Status start(const StreamHeader& header, KeySlices key_slices, Memory memory,
                             const ByteOutput& output);

  /// Takes samples of consecutive voxels, rows and slices in x, y, z order. Calls may end anywhere.
  /// samples: Owner: the caller; free again when the call returns. stride: from one sample to the
  /// next, in samples. Errors: not_started, finished, too_deep.
  /// With Status::suspended all samples up to the end of the row that caused it have been taken.
  /// Sample is uint8_t, uint16_t or int16_t. Cost: a comparison a sample, and of a row one decision
  /// where it is as its neighbours say, else about one a voxel of outline and two.
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");
    return push_samples(samples, count, stride);
  }

  /// Takes a whole row that is thresholded already: eight voxels a byte, the first in bit 0; of
  /// several surfaces one row behind the other, each of which begins with a byte. Errors: as
  /// push(), row_in_progress. PushResult::samples is the width when the row was taken, else 0.
  PushResult push_bits(const uint8_t* bits);

  /// Stands in for a row that never came; the stream says so. The first row of a key slice has none
  /// before it, and is taken as off. Result and errors: as push_bits().
  PushResult skip_row(Substitute substitute);

  /// Goes on after Status::suspended; the output may take nothing again, then it is
  /// Status::suspended again. Harmless at any other time. Errors: not_started.
  [[nodiscard]] Status resume();

  /// Hands over what is there so far instead of waiting for a full packet; costs about 15 bytes of
  /// stream a call. Errors: not_started. After Status::suspended call it again.
  [[nodiscard]] Status flush();

  /// Sends an application record now, before the next row; its slice and row are filled in. Errors:
  /// not_started, finished, bad_record. Status::suspended: not taken yet, call again.
  [[nodiscard]] Status write_record(const ApplicationRecord& record);

  /// Goes on with another output, as Encoder::set_output(). The next slice is a key slice.
  void set_output(const ByteOutput& output);

  /// Ends the scan and the stream. Errors: not_started, slice_in_progress. After Status::suspended
  /// go on with resume(). Calling it again is harmless.
  [[nodiscard]] Status finish();

  /// Ends the scan wherever it is: the stream says so, and the receiver takes the rest of the slice
  /// as off. Samples of a row that is not complete are dropped. Errors: not_started.
  /// Status::suspended as finish().
  [[nodiscard]] Status abandon();

  /// Whether a row, or the end, waits for the output: then resume() before save().
  bool is_suspended() const { return row_is_due_ || state_ == State::finishing; }

  /// Writes down where scan and stream are, the stream at the beginning of a frame; with the first
  /// bytes_used() bytes of the memory that is all of both. Errors: not_started. Status::suspended:
  /// resume() first. Cost: a checksum of those bytes.
  [[nodiscard]] Status save(Checkpoint<SliceEncoder>& checkpoint) const;

  /// Goes on where a checkpoint was saved: with row rows() of slice slices(), bytes() bytes of
  /// stream before it. memory: as many bytes as start() was given, the first ones as they were
  /// then; it may lie elsewhere, with the same alignment modulo 4; Owner: as of start(). Errors:
  /// too_little_memory, bad_checkpoint, bad_sink (no write). Cost: as save().
  [[nodiscard]] Status restore(const Checkpoint<SliceEncoder>& checkpoint, Memory memory,
                               const ByteOutput& output);

  /// Goes on as restore() does, where the bytes of this object itself have been read back, with
  /// those of the memory: for objects that are saved where they lie, as those of C. Limit: they are
  /// as they were. Errors: bad_sink (no write), too_little_memory.
  [[nodiscard]] Status continue_in(Memory memory, const ByteOutput& output);

  /// The bytes of stream so far: what the output has taken, and what was dropped without one. How
  /// many those are is what this has grown by between the two calls of set_output().
  uint64_t bytes() const { return packets_.bytes(); }
  /// So many bytes at the beginning of the caller's memory the scan uses: slice_encoder_bytes().
  size_t bytes_used() const;
  /// Complete slices so far, and complete rows of the current one.
  uint32_t slices() const { return surfaces_.rows().slices(); }
  uint32_t rows() const { return surfaces_.rows().rows(); }

  /// Of what a checkpoint holds: see CheckpointHead.
  static constexpr uint32_t layout = sizeof(void*) << 4;

 private:
  friend struct Checkpoint<SliceEncoder>;
  SliceEncoder(const SliceEncoder&) = default;
  SliceEncoder& operator=(const SliceEncoder&) = default;

  enum class State : uint8_t { idle, scanning, finishing, finished };

  void lay_out(Memory memory);
  template <class Sample>
  PushResult push_samples(const Sample* samples, uint32_t count, uint32_t stride);
  Status ready_for_row();
  uint32_t column() const { return surfaces_.rows().column(); }
  PushResult take_row(slices::RowNote note);
  bool work();
  bool encode_row();
  bool begin_row();
  bool encode_what_precedes();
  bool is_at_key_slice() const;
  void encode_note(slices::RowNote note);
  bool make_room();
  void begin_code();
  bool end_code();
  bool cut_code();
  bool close_code(uint8_t bits);
  uint8_t* code_end(size_t code_bytes);
  void seal(uint8_t* end);

  State state_ = State::idle;
  slices::RowNote note_ = slices::RowNote::none;  // of the row that is due
  bool row_is_due_ = false;
  bool row_is_begun_ = false;
  bool code_is_open_ = false;
  bool key_is_due_ = false;  // whatever key_slices_ says
  bool is_abandoned_ = false;
  uint8_t packet_bits_ = 0;  // of the packet: see wire::SliceBits
  uint8_t surface_ = 0;      // whose row is told
  KeySlices key_slices_;
  uint64_t encoded_rows_ = 0;
  uint64_t skipped_rows_ = 0;
  void* memory_ = nullptr;
  slices::RowWriter coder_;
  slices::RowCode row_;
  slices::Surfaces surfaces_;
  PacketWriter packets_;
};

}  // namespace discmc

#endif

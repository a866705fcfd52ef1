// The slice encoder: samples in, a stream of thresholded slices out. The receiver extracts the
// surface.
//
//   start(config, memory, output)
//   push(samples, count)      as often as samples arrive, any number at a time
//   resume()                  after Status::suspended, when the output is ready again
//   finish()                  after the last slice
//
// Each voxel is coded from its neighbours, with probabilities that adapt to the scan (WIRE.md,
// "Slices"). For CT head (Stanford), a stream of slices has a tenth of the bytes of a stream of
// regions, for a third of the instructions. But the receiver must extract the surface. That takes
// up to twice the memory that an extractor on the device takes. A lost packet costs all slices up
// to the next key slice.
#ifndef DISCMC_SLICE_ENCODER_HPP
#define DISCMC_SLICE_ENCODER_HPP

#include <discmc/base/arena.hpp>
#include <discmc/checkpoint.hpp>
#include <discmc/row_input.hpp>
#include <discmc/slices/coded_surfaces.hpp>
#include <discmc/slices/row_code.hpp>
#include <discmc/slices/row_coders.hpp>
#include <discmc/stream/packet_writer.hpp>

namespace discmc {

/// A scan and its stream of slices, for SliceEncoder::start(). As constant expression it also sizes
/// the memory:
///
///   constexpr SliceEncoderConfig config{limits, {threshold}, 16};
///   static uint8_t memory[SliceEncoder::minimum_bytes(config)];
struct SliceEncoderConfig {
  Limits limits;  ///< of the whole volume: a slab is refused by bad_limits
  /// Per surface: on if the sample is at least this. Put first the surface that most resembles the
  /// others: its bits predict the bits of the others.
  int32_t thresholds[StreamHeader::max_surfaces] = {};
  /// The number of slices from one key slice to the next; 0: only the first slice is a key slice. A
  /// key slice decodes without the slices before it. A receiver starts at a key slice, and resumes
  /// at one after a loss. A lost packet costs on average half of the interval.
  ///
  /// Choose the most slices that you can afford to lose, but at least as many as fit in one packet.
  /// A slice of CT head (Stanford) has about 200 bytes, so 16 slices are 13 packets. Key slices
  /// make that stream longer:
  ///
  ///   interval   16    8    4     1
  ///   growth     4 %   8 %  16 %  62 %
  ///
  /// The interval 1 needs the least memory.
  uint32_t key_slice_interval = 0;
  uint8_t surface_count = 1;  ///< on consecutive channels; Limit: 1 to StreamHeader::max_surfaces
  StreamLabel label = {};     ///< as of an Encoder
  uint8_t levels = 0;         ///< for a FractionSliceEncoder, see there; a SliceEncoder ignores it
};

namespace detail::slices {

/// The bytes of the rows and probabilities of this many surfaces.
constexpr uint64_t surface_bytes(const Limits& limits, uint32_t rows, uint32_t surfaces) {
  static_assert(StreamHeader::max_surfaces *
                        detail::trace::bit_row_bytes(Limits::max_extent, Limits::max_extent + 2) <
                    UINT32_MAX / 2,
                "32 bits count them");
  uint32_t bytes = 0;
  for (uint32_t surface = 0; surface < surfaces; ++surface)
    bytes += static_cast<uint32_t>(detail::trace::bit_row_bytes(limits.width, rows)) +
             static_cast<uint32_t>(SliceModel::bytes_for(surface > 0));
  return bytes;
}

/// A step or a note takes up to 4 bytes and the end of the code 1. A note before it takes 2, or a
/// cut after it 6.
constexpr size_t code_reserve = 4 + 1 + detail::wire::cut_tail;

/// Whether the interval makes a slice a key slice.
constexpr bool is_key_slice(uint32_t slice, uint32_t interval) {
  return slice == 0 || (interval > 0 && slice % interval == 0);
}

}  // namespace detail::slices

/// Accepts the samples of a scan, and writes one stream with the bits of its surfaces. An encoder
/// contains pointers to itself, so it is not copied.
class SliceEncoder {
  template <class Sample>
  friend class FractionSliceEncoder;

 public:
  /// The memory of start(), which needs no more (FOOTPRINT.md has a table). The first surface needs
  /// 548 bytes, each further one 1,060. In addition each surface needs rows of bits: five if every
  /// slice is a key slice, otherwise the rows of a slice and three more. Limit: valid limits.
  static constexpr uint64_t minimum_bytes(const SliceEncoderConfig& config) {
    return bytes_for(config, config.key_slice_interval != 1);
  }

  SliceEncoder() = default;

  /// Begins a scan and its stream, with the header of the stream. memory: at least
  /// minimum_bytes(config); Owner: the caller, for as long as the scan lasts. If a reset of the
  /// device may have cut off a frame, send a zero byte to the link first: it ends that frame.
  /// Errors: bad_limits, bad_label, bad_sink (no write function), too_little_memory.
  [[nodiscard]] Status start(const SliceEncoderConfig& config, Memory memory,
                             const ByteOutput& output);

  /// Accepts samples of consecutive voxels: x first, then y, then z. A call may begin and end
  /// anywhere in a row. samples: `count` samples that are `stride` samples apart; Owner: the
  /// caller; free again when the call returns. Sample is uint8_t, uint16_t or int16_t.
  ///
  /// Status::suspended: the output is busy, and PushResult::samples samples are accepted, up to the
  /// end of a row. Call resume() until it returns another status, then push the remaining samples.
  /// Errors: not_started, finished, too_many_slices. Cost, per surface: one comparison per sample,
  /// one or two coding decisions per row, and about one coding decision per voxel whose neighbours
  /// differ.
  template <class Sample>
  PushResult push(const Sample* samples, uint32_t count, uint32_t stride = 1) {
    static_assert(is_sample<Sample>, "samples must be uint8_t, uint16_t or int16_t");
    return push_samples(samples, count, stride);
  }

  /// Accepts a whole row that you thresholded. bits: (width + 7) / 8 bytes per surface, one surface
  /// after another. A byte has eight voxels, the first in bit 0; bits beyond the width are ignored.
  /// Owner: as of push().
  /// The row is accepted if PushResult::samples is the width, even with Status::suspended;
  /// otherwise samples is 0. Errors: as push(), row_in_progress.
  PushResult push_bits(const uint8_t* bits);

  /// Replaces a missing row; the stream records that the row was skipped. If the first row of a key
  /// slice is skipped, the row is off, because a key slice has no previous row. Result and errors:
  /// as push_bits().
  PushResult skip_row(Substitute substitute);

  /// Continues after Status::suspended, and returns it again if the output is still busy. Does
  /// nothing at any other time. Errors: not_started.
  [[nodiscard]] Status resume();

  /// Sends an incomplete packet instead of waiting for a full one; costs about 15 bytes of stream
  /// per call. Errors: not_started. After Status::suspended call it again.
  [[nodiscard]] Status flush();

  /// Sends an application record now, before the next row, and fills in its slice and row. Errors:
  /// not_started, finished, bad_record. Status::suspended: not accepted yet, call again.
  [[nodiscard]] Status write_record(const ApplicationRecord& record);

  /// Continues with another output, as Encoder::set_output(). The next slice is a key slice.
  void set_output(const ByteOutput& output);

  /// Ends the scan and the stream. Errors: not_started, slice_in_progress. After Status::suspended
  /// call resume(). A second call is harmless.
  [[nodiscard]] Status finish();

  /// Ends the scan anywhere: the stream records it, and for the receiver the rest of the slice is
  /// off. Samples of an incomplete row are dropped. Errors: not_started. Status::suspended as
  /// finish().
  [[nodiscard]] Status abandon();

  /// Whether a row or the trailer is not encoded yet because the output is busy. If so, call
  /// resume() before save(). If not, encoded bytes may still wait for the output; resume() then
  /// returns Status::suspended.
  bool is_suspended() const { return is_row_due_ || state_ == State::finishing; }

  /// Seals the encoder's state, and sets parts[0] and parts[1] to its bytes: the object, and the
  /// first bytes_used() bytes of the memory. Copy them before the next call (checkpoint.hpp).
  /// Status::suspended: call resume() first; or the output has unsent bytes, call again. Errors:
  /// not_started, bad_sink (the output has no unsent()). Cost: a checksum of both.
  [[nodiscard]] Status save(Memory* parts);

  /// Continues from the parts of save(), which were read back into this object and into the
  /// beginning of the memory. The next row is row rows() of slice slices(); the stream has bytes()
  /// bytes. The frame that was being sent is sent again. memory: at least bytes_used(), at an
  /// address that is the same modulo 4; Owner: as of start(). Errors: bad_checkpoint,
  /// too_little_memory (null), bad_sink. After an error read the parts back again, or call start().
  /// Cost: as save().
  [[nodiscard]] Status restore(Memory memory, const ByteOutput& output) {
    return restore_object(sizeof *this, 0, memory, output);
  }

  Limits limits() const {
    return {packets_.header().width, packets_.header().height, packets_.header().border};
  }
  /// The bytes of stream so far, including bytes that were dropped because there was no output. The
  /// growth from set_output({}) to the next set_output() is the number of dropped bytes.
  uint64_t bytes() const { return packets_.bytes(); }
  /// The number of bytes at the beginning of the caller's memory that the scan uses:
  /// minimum_bytes().
  size_t bytes_used() const { return state_ == State::idle ? 0 : bytes_used_; }
  /// The complete slices so far.
  uint32_t slices() const { return surfaces_.rows().slices(); }
  /// The complete rows of the current slice.
  uint32_t rows() const { return surfaces_.rows().rows(); }

  /// Differs between builds; for discmc.h.
  static constexpr uint32_t layout = sizeof(void*) << 4;

 private:
  SliceEncoder(const SliceEncoder&) = default;
  SliceEncoder& operator=(const SliceEncoder&) = default;

  enum class State : uint8_t { idle, scanning, finishing, finished };

  // keeps_slice: the slice before has neighbours or edges.
  static constexpr uint64_t bytes_for(const SliceEncoderConfig& config, bool keeps_slice) {
    const uint32_t rows = detail::slices::rows_kept(config.limits.height, !keeps_slice);
    return detail::slices::surface_bytes(config.limits, rows, config.surface_count) +
           Arena::alignment - 1;
  }

  bool lay_out(Memory memory);
  // type: sample_type of the fractions; 0 without fractions.
  Status restore_object(uint32_t object_bytes, uint32_t type, Memory memory,
                        const ByteOutput& output);
  template <class Sample>
  PushResult push_samples(const Sample* samples, uint32_t count, uint32_t stride);
  // Calls process(samples, count) with parts of rows, before their row is complete.
  template <class Sample, class Process>
  PushResult push_parts(const Sample* samples, uint32_t count, uint32_t stride, Process process) {
    PushResult result{ready_for_row(), 0};
    while (result.status == Status::ok && result.samples < count) {
      const uint32_t part_count =
          samples_of_row(count - result.samples, column(), packets_.header().width);
      process(samples + size_t{result.samples} * stride, part_count);
      result.samples += part_count;
      if (!surfaces_.rows().is_row_complete()) break;
      note_ = detail::slices::RowNote::none;
      is_row_due_ = true;
      result.status = result.samples == count ? resume() : ready_for_row();
    }
    return result;
  }
  template <class Sample>
  void append(const Sample* samples, uint32_t count, uint32_t stride) {
    for (uint32_t surface = 0; surface < surfaces_.count(); ++surface)
      surfaces_[surface].rows.append(samples, count, stride, packets_.header().thresholds[surface]);
  }
  Status ready_for_row();
  uint32_t column() const { return surfaces_.rows().column(); }
  PushResult process_row(detail::slices::RowNote note);
  bool work();
  bool encode_row();
  bool begin_row();
  bool encode_row_start();
  bool keeps_slice() const { return key_slice_interval_ != 1 || fraction_flags_ != 0; }
  bool is_at_key_slice() const;
  void encode_note(detail::slices::RowNote note);
  // Whether the packet has room for a step or a note.
  DISCMC_ALWAYS_INLINE bool has_room() const {
    return is_code_open_ && coder_.range.has_room(detail::slices::code_reserve);
  }
  bool make_room();
  void begin_code();
  bool end_code();
  bool cut_code();
  bool close_code(uint8_t bits);
  uint8_t* code_end(size_t code_bytes);
  void seal(uint8_t* end);

  State state_ = State::idle;
  detail::slices::RowNote note_ = detail::slices::RowNote::none;  // of the row that is due
  bool is_row_due_ = false;
  bool is_row_begun_ = false;
  bool is_code_open_ = false;
  bool is_key_due_ = false;  // regardless of the interval
  bool is_abandoned_ = false;
  uint8_t packet_bits_ = 0;  // of the packet: see detail::wire::SliceBits
  uint8_t surface_ = 0;      // whose row is being coded
  uint32_t key_slice_interval_ = 0;
  uint64_t encoded_rows_ = 0;
  uint64_t skipped_rows_ = 0;
  void* memory_ = nullptr;
  size_t bytes_used_ = 0;
  detail::slices::RowWriter coder_;
  detail::slices::RowCode row_;
  detail::slices::CodedSurfaces surfaces_;
  detail::stream::PacketWriter packets_;
  detail::Seal seal_;
  // A FractionSliceEncoder sets these members.
  bool (*code_fractions_)(SliceEncoder& encoder) = nullptr;  // false if the output is busy
  uint16_t fraction_object_bytes_ = 0;                       // of its own members
  uint8_t fraction_flags_ = 0;                               // of the header
  uint8_t fraction_type_ = 0;                                // sample_type of the samples
};

}  // namespace discmc

#endif

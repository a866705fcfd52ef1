// The decoder: bytes of a stream in, the events of the scan out.
//
// Any bytes are safe. It never reads beyond what it is given nor writes beyond its own object, it
// allocates nothing, and what was whole is delivered, whatever came before or after.
#ifndef DISCMC_DECODER_HPP
#define DISCMC_DECODER_HPP

#include <discmc/status.hpp>
#include <discmc/stream/normal_encoding.hpp>
#include <discmc/stream/wire.hpp>

namespace discmc {

/// How a stream arrived. Lost counts grow when the next whole packet reveals the gap.
struct StreamReport {
  bool has_header = false;
  bool has_trailer = false;
  bool abandoned = false;  ///< the scan was ended before its time; the surface is closed
  uint64_t bytes = 0;
  uint64_t packets = 0;  ///< whole ones, repeated ones not counted
  uint64_t repeated_packets = 0;
  uint64_t damaged_packets = 0;  ///< frames that are no packet, or fail their checksum
  bool is_unreadable = false;    ///< a packet was whole, but its records are of no known kind
  uint64_t lost_packets = 0;     ///< missing by their numbers
  uint64_t regions = 0;          ///< delivered complete
  uint64_t fragments = 0;        ///< loose ones delivered complete
  uint64_t lost_pieces = 0;      ///< regions and fragments missing by the running count of both
  uint32_t slices = 0;           ///< of the trailer
  Statistics totals{};           ///< of the trailer

  /// Nothing is missing from header to trailer, and nothing came that the trailer does not count.
  bool is_complete() const {
    return has_header && has_trailer && lost_packets == 0 && lost_pieces == 0 &&
           regions == totals.regions && fragments == totals.fragments && !is_unreadable;
  }
};

/// What push() came to, and how many of the bytes it took. The rest must be pushed again.
struct [[nodiscard]] Decoded {
  Status status;
  size_t bytes;
};

/// Runs come with the normals where they start, if the stream tells any.
class Decoder {
 public:
  /// Begins a stream. Errors: bad_sink.
  [[nodiscard]] Status start(const Sink& sink);

  /// Takes bytes, any number at a time. Status::more: the sink said "not now", push the rest again.
  /// Status::wrong_version: the header names a version this decoder does not know; nothing more of
  /// this stream is delivered. Errors: also not_started.
  /// The events of packets that arrive before any header are delivered too.
  Decoded push(const uint8_t* bytes, size_t count);

  /// Tells that no byte follows: an unfinished region or fragment is reported lost. Status::more as
  /// push().
  [[nodiscard]] Status finish();

  const StreamHeader& header() const { return header_; }
  const StreamReport& report() const { return report_; }

 private:
  struct Coder {
    RangeDecoder range;
    bool bit(uint32_t context, bool) { return range.decode(region_model[context]); }
  };
  using Model = RegionModel<Coder>;

  // What is under way between two bytes.
  enum class Stage : uint8_t { collect, records, record, mark, finish };

  void open_frame(size_t bytes);
  bool is_expected(const uint8_t* packet);
  // What the next packet is to be numbered.
  uint64_t packets_passed() const { return report_.packets + report_.lost_packets; }
  void note_gap(uint64_t packets, uint64_t pieces);
  void lose_open();
  bool read_header(const uint8_t* payload, size_t bytes);
  void read_trailer(const uint8_t* payload, size_t bytes);
  void read_record();
  bool read_region();
  bool read_ring(Chain chain);
  bool read_fragment();
  bool read_part();
  void read_mark(RecordKind kind);
  void read_extension();
  bool begin_record();
  bool rings_are_whole();
  void damage();

  bool deliver();
  bool deliver_record();
  bool offer(const Event& event) { return sink_.take(sink_.context, event) == Answer::taken; }

  Sink sink_;
  StreamHeader header_;
  StreamReport report_;
  bool is_started_ = false;
  bool is_refused_ = false;     // by its version
  uint64_t pieces_passed_ = 0;  // regions and fragments sent before now, lost ones included
  bool gap_is_noted_ = true;    // since the last header; what came before the start is a gap

  uint8_t frame_[wire::max_frame];
  size_t frame_bytes_ = 0;  // what is more than a frame is dropped: it is none

  Stage stage_ = Stage::collect;
  Model model_{Coder{}};
  Record record_;
  uint32_t told_ = 0;               // words of the record that the sink has taken
  uint32_t told_runs_ = 0;          // of them runs
  ToldNormals normals_;             // of the record
  bool normals_are_ahead_ = false;  // of the next record
  bool begin_is_untold_ = false;
  bool lost_is_untold_ = false;
  bool is_first_ring_ = true;
  // What the sink has begun and waits for the next part of.
  struct Open {
    Incidence incidence;
    bool is_fragment;
  };
  Open open_{};
  bool is_open_ = false;
  bool ring_is_empty_ = false;  // the record so far ends with a ring's start
  Event mark_{};
};

}  // namespace discmc

#endif

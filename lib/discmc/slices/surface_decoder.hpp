// Decodes one stream of either kind for a Receiver, and sends the events of one of its surfaces. A
// stream of slices passes an extractor.
#ifndef DISCMC_SLICES_SURFACE_DECODER_HPP
#define DISCMC_SLICES_SURFACE_DECODER_HPP

#include <discmc/extractor.hpp>
#include <discmc/slice_decoder.hpp>

namespace discmc {

class SurfaceDecoder {
 public:
  /// The most lost rows that one call skips, because a hostile stream can claim any number of them.
  static constexpr uint32_t max_skipped_rows = uint32_t{1} << 16;

  SurfaceDecoder() = default;
  SurfaceDecoder(const SurfaceDecoder&) = delete;
  SurfaceDecoder& operator=(const SurfaceDecoder&) = delete;

  /// Like the functions of a Receiver, for one stream.
  [[nodiscard]] Status start(Memory memory, const Sink& sink, uint8_t channel = any_channel);
  void set_packet_passthrough(const RecordsPacketSink& sink) {
    regions_.set_packet_passthrough(sink);
  }
  Decoded push(const uint8_t* bytes, size_t count);
  [[nodiscard]] Status set_memory(Memory memory);
  [[nodiscard]] Status finish();
  static constexpr uint64_t minimum_bytes(const Limits& limits, uint32_t surfaces = 1,
                                          uint32_t levels = 0) {
    return SliceDecoder::minimum_bytes(limits, surfaces, levels) +
           Extractor32::minimum_bytes(limits);
  }

  /// Whether a packet of the next scan has arrived, and the start of that scan with it.
  bool holds_next_scan() const { return packets().holds_next_scan(); }
  void start_next();

  const StreamHeader& header() const { return regions_.header(); }
  const StreamReport& report() const {
    return is_of_slices_ ? slices_.report() : regions_.report();
  }

 private:
  const detail::stream::PacketReader& packets() const {
    return is_of_slices_ ? slices_.packets() : regions_.packets();
  }
  Decoded push_to_both(const uint8_t* byte);
  void note_kind();
  Status begin_sweep();
  uint8_t wanted_channel() const { return channel_ == any_channel ? header().channel : channel_; }
  SinkResult accept(const RowEvent& event);
  SinkResult begin(const StreamHeader& stream_header);
  SinkResult pass_between(const Event& event);
  SinkResult pass(const Event& event) { return sink_.accept(sink_.context, event); }
  SinkResult skip(uint64_t rows, Substitute substitute);
  SinkResult end(bool is_abandoned);

  Sink sink_;
  uint8_t channel_ = any_channel;
  Memory memory_;
  Decoder regions_;
  SliceDecoder slices_;
  Extractor32 extractor_;
  Status refusal_ = Status::ok;  // for a stream of slices
  bool is_known_ = false;        // whether the kind of the stream is known
  bool is_of_slices_ = false;
  uint64_t skipped_rows_ = 0;  // of consecutive lost rows
};

}  // namespace discmc

#endif

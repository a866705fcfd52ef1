// The decoder of version 1: bytes of a stream in, the events of the scan out.
//
// In version 1 a fragment, a piece of a ring that was sent early, has a number, and its ring says
// where the fragment of this number belongs. It is put back here: what comes out are whole regions.
#ifndef DISCMC_COMMAND_STREAMS_VERSION1_DECODER_HPP
#define DISCMC_COMMAND_STREAMS_VERSION1_DECODER_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/decoder.hpp>
#include <discmc/stream/normal_encoding.hpp>

#include "fragments.hpp"
#include "model.hpp"
#include "packet_reader.hpp"

namespace discmc::host::version1 {

/// Any bytes are safe. A region that lacks something is told as begun and lost.
class Decoder {
 public:
  /// About how much memory fragments and the region under way may take. What finds no room is lost.
  static constexpr std::size_t default_most_bytes = std::size_t{1} << 28;

  /// sink: it must not say "not now".
  explicit Decoder(const Sink& sink, std::size_t most_bytes = default_most_bytes)
      : sink_(sink), most_bytes_(most_bytes) {}

  /// Takes bytes, any number at a time. Errors: wrong_version; then nothing more is delivered.
  [[nodiscard]] Status push(const std::uint8_t* bytes, std::size_t count);
  /// Tells that no byte follows: an unfinished region is reported lost.
  void finish();

  const StreamHeader& header() const { return packets_.header(); }
  /// Its fragments are those that have arrived. Lost pieces are regions alone: with a fragment the
  /// one that needs it is lost.
  const StreamReport& report() const { return packets_.report(); }

 private:
  // A region, a fragment, or a part of one.
  struct Record {
    PartHead head{};
    bool is_last = true;
    Chain
        rest;  // of a fragment all, of a region what goes on with the last ring of the part before
    std::vector<Ring> rings;
    std::uint32_t words = 0;
  };

  void open(PacketReader::Arrival arrival);
  void read_records();
  bool read_record();
  bool read_region(Record& record);
  bool read_ring(Record& record);
  bool read_compact_length(std::uint32_t& length);
  bool read_part(Record& record);
  bool read_item(Item item, Record& record);
  bool read_run(Incidence incidence, Chain& chain);
  bool read_layer();
  bool read_skipped();
  bool read_extension();

  bool take(Record&& record);
  bool goes_on_with(const Record& record) const;
  bool rings_are_whole(const Record& record) const;
  bool has_room_for(const Record& record) const;
  void set_normals(Record& record) const;
  void append(Record&& record);
  void skip(const Record& record);
  void end_open();
  void lose_open();
  void forget_open();

  void tell(const Event& event) { static_cast<void>(sink_.take(sink_.context, event)); }
  void tell_start();
  void tell_open();
  void tell_open_lost();
  void tell_finish();

  Sink sink_;
  std::size_t most_bytes_;
  PacketReader packets_;
  bool start_is_told_ = false;

  Model model_;
  bool is_at_end_ = false;          // of the packet
  ToldNormals normals_{};           // of the record
  bool normals_are_ahead_ = false;  // of the next record

  Record open_;  // all parts so far of what waits for its next
  bool is_open_ = false;
  std::size_t open_bytes_ = 0;
  Fragments fragments_;
};

}  // namespace discmc::host::version1

#endif

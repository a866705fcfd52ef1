// The regions of a part of a volume, encoded beside those of other parts.
#ifndef DISCMC_MESH_EXTRACTION_ENCODED_PART_HPP
#define DISCMC_MESH_EXTRACTION_ENCODED_PART_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/encoder.hpp>

#include "host/whole_region.hpp"

namespace discmc::meshing {

/// A sink that keeps packets of records, for the encoder of the whole volume to send.
class EncodedPart {
 public:
  EncodedPart() = default;
  EncodedPart(const EncodedPart&) = delete;
  EncodedPart& operator=(const EncodedPart&) = delete;

  /// Takes a scan's start, then regions. Always takes the event.
  SinkResult accept(const Event& event);
  /// The same by the events of the region.
  void accept_region(const WholeRegion& region);

  /// Gives all packets to an encoder. Call once, after the last region. encoder: started; its
  /// output must take all.
  void append_to(Encoder& encoder);

 private:
  struct Packet {
    std::size_t end;              // of its payload
    std::uint16_t pieces_before;  // as the packet encodes them
    bool is_whole;                // only whole regions, with room for their number
  };

  std::size_t keep(const std::uint8_t* frame, std::size_t bytes);

  Encoder encoder_;
  std::vector<std::uint8_t> payloads_;  // one after another
  std::vector<Packet> packets_;
  std::uint16_t pieces_ = 0;  // taken, modulo 2^16
};

}  // namespace discmc::meshing

#endif

// Encodes the regions of a part of a volume, in parallel to other parts.
#ifndef DISCMC_MESH_EXTRACTION_ENCODED_PART_HPP
#define DISCMC_MESH_EXTRACTION_ENCODED_PART_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include <discmc/encoder.hpp>

#include "host/one_ring_region.hpp"

namespace discmc::meshing {

/// A sink that keeps packets of records until the encoder of the whole volume sends them.
class EncodedPart {
 public:
  EncodedPart() = default;
  EncodedPart(const EncodedPart&) = delete;
  EncodedPart& operator=(const EncodedPart&) = delete;

  /// Accepts the start of a scan, then regions. Always accepts the event.
  SinkResult accept(const Event& event);
  /// Likewise accepts a whole region.
  void accept_region(const OneRingRegion& region);

  /// Appends all packets to an encoder. Call it once, after the last region. encoder: started; its
  /// output must accept everything.
  void append_to(Encoder& encoder);

 private:
  struct Packet {
    std::size_t end;              // of its payload
    std::uint16_t pieces_before;  // as encoded in the packet
    bool is_whole;                // whether it has only whole regions, with room for their number
  };

  std::size_t keep(const std::uint8_t* frame, std::size_t bytes);

  Encoder encoder_;
  std::vector<std::uint8_t> payloads_;  // of all packets, one after another
  std::vector<Packet> packets_;
  std::uint16_t pieces_ = 0;  // number so far, modulo 2^16
};

}  // namespace discmc::meshing

#endif

// Packets that pass unchanged from one stream to another. Hosts use them to join the streams of
// slabs; firmware does not need them.
//
// Decoder::set_packet_passthrough() passes packets on, and Encoder::append() adds them to the
// joined stream. Their regions are not decoded, so joining slabs costs little more than the regions
// at the seams.
#ifndef DISCMC_STREAM_RECORDS_PACKET_HPP
#define DISCMC_STREAM_RECORDS_PACKET_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/base/compiler.hpp>

namespace discmc {

/// A packet that contains regions, loose fragments and marks.
struct RecordsPacket {
  const uint8_t* payload;  ///< Owner: the sender; valid during the call
  size_t bytes;            ///< of the payload
  uint32_t pieces;         ///< regions and loose fragments that end in this packet
  /// Whether the packet contains only whole regions, and no loose fragment of any stream belongs to
  /// any of these regions.
  bool is_whole;
};

/// A sink of packets: a function, and the object that it is called with. Owner: the context belongs
/// to the caller, and must exist while the sender has this sink. accept() cannot refuse a packet.
struct RecordsPacketSink {
  void* context = nullptr;
  void (*accept)(void* context, const RecordsPacket& packet) = nullptr;
};

}  // namespace discmc

#endif

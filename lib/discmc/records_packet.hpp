// Packets of records that pass unchanged from an encoder or a decoder to another encoder.
//
// The encoder of a part creates them, a Decoder passes them on, and append() of the encoder of the
// whole scan sends them. So parts are encoded in parallel, and the cost of joining slabs is that of
// the boundaries at their seams.
#ifndef DISCMC_RECORDS_PACKET_HPP
#define DISCMC_RECORDS_PACKET_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// A packet of records on its way from an encoder or a decoder to another encoder.
struct RecordsPacket {
  const uint8_t* payload;  ///< Owner: the sender
  size_t bytes;
  uint32_t pieces;  ///< regions and loose fragments that end in it
  /// Whether the packet contains only whole regions, to none of which a loose fragment of any
  /// stream belongs.
  bool is_whole;
};

/// A sink of such packets.
struct RecordsPacketSink {
  void* context = nullptr;  ///< Owner: the caller
  void (*take)(void* context, const RecordsPacket& packet) = nullptr;
};

}  // namespace discmc

#endif

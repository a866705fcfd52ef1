// Packets of records that pass from an encoder or a decoder to another encoder as they are.
//
// An encoder of a part makes them, append() of that of the whole scan sends them, and a Decoder
// passes them on: so parts are encoded side by side, and what a join of slabs costs is what crosses
// their seams.
#ifndef DISCMC_RECORDS_PACKET_HPP
#define DISCMC_RECORDS_PACKET_HPP

#include <stddef.h>
#include <stdint.h>
#include <discmc/compiler.hpp>

namespace discmc {

/// A packet of records on its way from an encoder or a decoder to another encoder.
struct RecordsPacket {
  const uint8_t* payload;  ///< Owner: who gives it
  size_t bytes;
  uint32_t pieces;  ///< regions and loose fragments that end in it
  /// Whether it holds whole regions alone, none of them in part, and no loose fragment of any
  /// stream belongs to one of them.
  bool is_whole;
};

/// Who takes such packets.
struct RecordsPacketSink {
  void* context = nullptr;  ///< Owner: the caller
  void (*take)(void* context, const RecordsPacket& packet) = nullptr;
};

}  // namespace discmc

#endif

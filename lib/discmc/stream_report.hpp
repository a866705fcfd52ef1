// What a decoder says of a stream: how much came, and how much did not.
#ifndef DISCMC_STREAM_REPORT_HPP
#define DISCMC_STREAM_REPORT_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// How a stream arrived. Lost counts grow when the next whole packet reveals the gap.
///
/// Of a stream of slices it has rows only, lost ones among them: no region or fragment, no totals
/// but skipped_rows, which are those that never came to the encoder. Count regions in the sink of a
/// SurfaceDecoder; its `finish` event has the totals of its own sweep, to which lost rows are
/// skipped ones. An application record that is lost is counted as a packet alone.
struct StreamReport {
  bool has_header = false;
  bool holds_slices = false;  ///< as its header says: a SliceDecoder or a SurfaceDecoder takes it
  bool has_trailer = false;
  bool abandoned = false;      ///< the scan was ended before its time; the surface is closed
  bool is_unreadable = false;  ///< a packet was whole, but its records are of no known kind
  bool is_mixed = false;  ///< by the trailer: packets of another scan, of the same name, were taken
  uint64_t bytes = 0;
  uint64_t packets = 0;  ///< whole ones, repeated ones not counted
  uint64_t repeated_packets = 0;
  uint64_t damaged_packets = 0;  ///< frames that are no packet, or fail their checksum
  uint64_t foreign_packets = 0;  ///< of another scan or channel; not counted above, and left alone
  uint64_t lost_packets = 0;     ///< missing by their numbers
  uint64_t regions = 0;          ///< delivered complete
  uint64_t fragments = 0;        ///< loose ones delivered complete
  uint64_t lost_pieces = 0;      ///< regions and fragments missing by the running count of both
  uint64_t rows = 0;             ///< of bits, delivered
  uint64_t lost_rows = 0;        ///< of bits, by where the next one is
  uint64_t total_rows = 0;       ///< of bits: of the trailer
  uint32_t slices = 0;           ///< of the trailer
  Statistics totals{};           ///< of the trailer

  /// Nothing is missing from header to trailer, and nothing came that the trailer does not count.
  bool is_complete() const {
    return has_header && has_trailer && lost_packets == 0 && lost_pieces == 0 && lost_rows == 0 &&
           regions == totals.regions && fragments == totals.fragments && rows == total_rows &&
           !is_unreadable && !is_mixed;
  }
};

}  // namespace discmc

#endif

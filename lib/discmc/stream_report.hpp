// The report of a decoder: what arrived of a stream, and what is missing.
#ifndef DISCMC_STREAM_REPORT_HPP
#define DISCMC_STREAM_REPORT_HPP

#include <discmc/sink.hpp>

namespace discmc {

/// The report of a stream. A loss is counted when the next intact packet reveals it.
///
/// Streams of regions set regions, fragments, lost_pieces and totals. Streams of slices set rows,
/// lost_rows and total_rows, which count a row of several surfaces once, and only skipped_rows in
/// totals. The other totals of their surface are in the `finish` event of a Receiver. A lost
/// application record counts only as a lost packet.
struct StreamReport {
  bool has_header = false;
  bool holds_slices = false;  ///< according to its header: use a Receiver or a SliceDecoder
  bool has_trailer = false;
  bool is_abandoned = false;   ///< the scan ended early; a closed border still closes the surface
  bool is_unreadable = false;  ///< an intact packet has contents that the decoder cannot read
  bool is_mixed = false;       ///< according to the trailer: packets of another scan with the same
                               ///< number were accepted
  uint64_t bytes = 0;
  uint64_t packets = 0;           ///< intact packets, without repeated ones
  uint64_t repeated_packets = 0;  ///< ignored: arrived before, after the trailer, or out of order;
                                  ///< the last kind also counts as lost
  uint64_t damaged_packets = 0;   ///< frames that are no packet, fail their checksum, or contain
                                  ///< what the decoder cannot read
  uint64_t foreign_packets = 0;   ///< of another scan or channel; ignored, and in no other count
  uint64_t lost_packets = 0;      ///< missing packet numbers
  uint64_t regions = 0;           ///< delivered complete
  uint64_t fragments = 0;         ///< loose fragments delivered complete
  uint64_t lost_pieces = 0;  ///< regions and fragments that the sender counted and that did not
                             ///< arrive complete
  uint64_t rows = 0;         ///< delivered, including skipped rows
  uint64_t lost_rows = 0;    ///< missing before a later row or the trailer
  uint64_t total_rows = 0;   ///< according to the trailer
  uint32_t slices = 0;       ///< according to the trailer
  Statistics totals{};       ///< according to the trailer

  /// Whether nothing is missing from header to trailer, and nothing arrived that the trailer does
  /// not count.
  bool is_complete() const {
    return has_header && has_trailer && lost_packets == 0 && lost_pieces == 0 && lost_rows == 0 &&
           regions == totals.regions && fragments == totals.fragments && rows == total_rows &&
           !is_unreadable && !is_mixed;
  }
};

}  // namespace discmc

#endif

// Packets of version 1 as they come in: numbers compared, losses counted, headers and trailers
// read.
#ifndef DISCMC_COMMAND_STREAMS_VERSION1_PACKET_READER_HPP
#define DISCMC_COMMAND_STREAMS_VERSION1_PACKET_READER_HPP

#include <cstdint>

#include <discmc/decoder.hpp>

#include "packets.hpp"

namespace discmc::host::version1 {

/// Any bytes are safe.
class PacketReader {
 public:
  /// What a byte has completed.
  enum class Arrival : std::uint8_t { nothing, records, trailer };
  /// Takes a byte. Limit: not is_refused().
  Arrival take(std::uint8_t byte);
  /// Tells that no byte follows.
  void finish();

  /// Whether something before the packet that has arrived, or at the end, is lost; says it once.
  bool take_gap();
  /// Whether a header is of another version: nothing more is read.
  bool is_refused() const { return is_refused_; }
  /// What has arrived, until the next byte.
  const Packet& packet() const { return unframer_.packet(); }

  /// A region has been delivered.
  void pass_region();
  /// One that ended cannot be.
  void lose_region();
  /// A packet, whole by its checksum, does not hold what it should.
  void note_unreadable();

  const StreamHeader& header() const { return header_; }
  const StreamReport& report() const { return report_; }
  StreamReport& report() { return report_; }

 private:
  Arrival open(const Packet& packet);
  bool is_expected(const Packet& packet);
  // What the next packet is to be numbered.
  std::uint64_t packets_passed() const { return report_.packets + report_.lost_packets; }
  void note_gap(std::uint64_t packets, std::uint64_t regions);
  bool take_header(const Packet& packet);
  Arrival take_trailer(const Packet& packet);

  Unframer unframer_;
  StreamHeader header_;
  StreamReport report_;
  bool is_refused_ = false;
  bool gap_is_untold_ = false;
  bool gap_is_noted_ = true;          // since the last header; what came before the start is a gap
  std::uint64_t regions_passed_ = 0;  // delivered or lost
};

}  // namespace discmc::host::version1

#endif

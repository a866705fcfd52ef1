// Which version a stream is of.
#ifndef DISCMC_COMMAND_STREAMS_VERSION_SEARCH_HPP
#define DISCMC_COMMAND_STREAMS_VERSION_SEARCH_HPP

#include <cstddef>
#include <cstdint>

#include <discmc/stream/packet_reader.hpp>

#include "streams/version1/packets.hpp"

namespace discmc::host {

/// Reads a stream up to its first whole header, which decides. What has none in `most_bytes` is
/// taken for the newest version.
class VersionSearch {
 public:
  static constexpr std::size_t most_bytes = std::size_t{1} << 20;

  VersionSearch();
  /// Limit: not is_over().
  void take(std::uint8_t byte);
  bool is_over() const { return is_over_; }
  bool is_version1() const { return is_version1_; }

 private:
  version1::HeaderSearch version1_;
  PacketReader newest_;  // for its headers alone
  std::size_t bytes_ = 0;
  bool is_over_ = false;
  bool is_version1_ = false;
};

}  // namespace discmc::host

#endif

// Lists the streams that share a link.
#ifndef DISCMC_MESH_STREAMS_STREAM_CENSUS_HPP
#define DISCMC_MESH_STREAMS_STREAM_CENSUS_HPP

#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include <discmc/sink.hpp>

#include "frames.hpp"

namespace discmc::meshing {

/// Finds the headers among the frames of a link.
class StreamCensus {
 public:
  void add(const std::uint8_t* bytes, std::size_t count);
  /// Returns one header per stream, in the order of arrival.
  const std::vector<StreamHeader>& headers() const { return headers_; }
  /// Returns the version of the last header whose version is not detail::wire::version.
  std::uint8_t other_version() const { return other_version_; }

 private:
  void look_at(const std::vector<std::uint8_t>& frame);

  Frames frames_;
  std::unordered_set<std::uint32_t> tags_;  // of known streams
  std::vector<StreamHeader> headers_;
  std::uint8_t other_version_ = 0;
};

}  // namespace discmc::meshing

#endif

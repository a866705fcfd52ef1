// What a stream says of its scan, and what an encoder has to be told of it.
#ifndef DISCMC_STREAM_HEADER_HPP
#define DISCMC_STREAM_HEADER_HPP

#include <discmc/limits.hpp>

namespace discmc {

/// For a decoder that takes the first stream that comes, of whatever channel.
constexpr uint8_t any_channel = 255;

/// What an encoder is told of a scan. The rest the extractor knows.
struct StreamLabel {
  static constexpr uint8_t max_channel = 63;

  uint32_t depth = 0;                 ///< planned slices; 0 when not known
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown;
                                      ///< not read where the extractor was told it
  uint16_t scan = 0;                  ///< a number that no other scan on the link has, such as a
                                      ///< device's own and a count of its scans
  uint8_t channel = 0;  ///< of the surface, where several share a link; Limit: at most
                        ///< max_channel
};

/// What a stream says of its scan.
struct StreamHeader {
  uint32_t width = 0;
  uint32_t height = 0;
  uint32_t depth = 0;                 ///< planned slices; 0 when not known
  int32_t spacing_nm[3] = {0, 0, 0};  ///< between voxels; negative for a mirrored axis; 0 unknown
  int32_t threshold = 0;              ///< a voxel is on where its sample is >= threshold
  Border border = Border::closed;
  uint8_t channel = 0;  ///< of the first surface, where a stream of slices has several
  uint16_t scan = 0;

  static constexpr uint8_t max_surfaces = 4;
  uint8_t further_surfaces = 0;  ///< in this stream, on the next channels; in slices alone
  /// Of the second surface on.
  int32_t further_thresholds[max_surfaces - 1] = {0, 0, 0};

  constexpr uint32_t surfaces() const { return 1U + further_surfaces; }
  constexpr int32_t threshold_of(uint32_t surface) const {
    return surface == 0 ? threshold : further_thresholds[surface - 1];
  }
  constexpr bool is_valid() const {
    return Limits{width, height, border}.is_valid() && surfaces() <= max_surfaces &&
           channel + further_surfaces <= StreamLabel::max_channel;
  }
  constexpr bool has_spacing() const {
    return spacing_nm[0] != 0 || spacing_nm[1] != 0 || spacing_nm[2] != 0;
  }
  constexpr StreamLabel label() const {
    return {depth, {spacing_nm[0], spacing_nm[1], spacing_nm[2]}, scan, channel};
  }
};

}  // namespace discmc

#endif

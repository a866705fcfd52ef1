// A corner of a chain in 64 bits: its position, and the turn of the chain.
#ifndef DISCMC_MESH_HOST_CORNER_CODE_HPP
#define DISCMC_MESH_HOST_CORNER_CODE_HPP

#include <discmc/lattice.hpp>
#include <discmc/limits.hpp>

namespace discmc::host {

/// Bits 0-4: the leaving link. 5-9: the arriving link. 10-14: the incidence. 16-31: x + 1. 32-47:
/// y + 1. 48-63: z + 1. Codes compare in the order z, y, x. A corner moves if a vector is added to
/// its code.
class CornerCode {
 public:
  /// The largest number of slices of a scan, with context slices. The remaining z are for the slice
  /// before the first, and for centroids behind the last.
  static constexpr uint32_t max_slices = 32760;
  static_assert(2 * (max_slices + 2) < 1 << 16 && 2 * Limits::max_extent + 1 < 1 << 16,
                "each coordinate and one has 16 bits");
  /// Replaces a link beyond the seam of a slab.
  static constexpr Link beyond_seam = link_codes;
  static_assert(beyond_seam < 1 << 5 && incidence_codes <= 1 << 5, "each has five bits");

  constexpr explicit CornerCode(uint64_t bits) : bits_(bits) {}

  /// The terms of a code: links, an incidence, a vector, a vertex.
  static constexpr uint64_t links(Link incoming, Link onwards) {
    return uint64_t{incoming} << 5 | onwards;
  }
  static constexpr uint32_t incidence_shift = 10;
  static constexpr uint64_t vector(const Vertex& v) {
    const auto part = [](int32_t coordinate) { return static_cast<uint64_t>(int64_t{coordinate}); };
    return (part(v.x) << 16) + (part(v.y) << 32) + (part(v.z) << 48);
  }
  static constexpr uint32_t position_shift = 16;
  static constexpr uint64_t position(const Vertex& v) {
    return vector({v.x + 1, v.y + 1, v.z + 1});
  }

  constexpr uint64_t bits() const { return bits_; }
  constexpr Link onwards() const { return bits_ & 31; }
  constexpr Link incoming() const { return bits_ >> 5 & 31; }
  constexpr Incidence incidence() const { return bits_ >> incidence_shift & 31; }
  constexpr Vertex vertex() const {
    const auto coordinate = [this](int at) {
      return static_cast<int32_t>(bits_ >> at & 0xFFFF) - 1;
    };
    return {coordinate(16), coordinate(32), coordinate(48)};
  }

 private:
  uint64_t bits_;
};

/// The constants that count the links between two corners. The difference of their positions is a
/// multiple of an odd number, shifted by some bits. It is divided exactly by a multiplication with
/// the inverse modulo 2^64 (H. Warren, Hacker's Delight, section 10-15).
struct LinkMeasure {
  uint64_t inverse;
  uint32_t shift;
};
struct LinkMeasures {
  LinkMeasure by_link[1 << 5];
};
namespace derive {
constexpr LinkMeasures link_measures() {
  LinkMeasures measures{};
  for (Link link = 0; link < link_codes; ++link) {
    uint64_t odd = CornerCode::vector(link_vector(link));
    LinkMeasure& measure = measures.by_link[link];
    for (; (odd & 1) == 0; odd >>= 1) ++measure.shift;
    // Each step doubles the number of correct bits; three are correct at first.
    measure.inverse = odd;
    for (int bits = 3; bits < 64; bits *= 2) measure.inverse *= 2 - odd * measure.inverse;
  }
  return measures;
}
}  // namespace derive
inline constexpr LinkMeasures link_measures = derive::link_measures();

/// Returns the number of links from a corner straight to the next.
inline uint32_t links_between(CornerCode from, CornerCode to) {
  constexpr uint64_t position = ~((uint64_t{1} << CornerCode::position_shift) - 1);
  const LinkMeasure& measure = link_measures.by_link[from.onwards()];
  const uint64_t difference = (to.bits() & position) - (from.bits() & position);
  return static_cast<uint32_t>(difference * measure.inverse >> measure.shift);
}

}  // namespace discmc::host

#endif

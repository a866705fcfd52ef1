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
  /// The largest number of slices. A code also has room for the slice before the first. Behind the
  /// last it has room for centroids, and for the slice above a slab.
  static constexpr int32_t max_slices = 32760;
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

/// The means to count links between two corners. The bits from `shift` on hold a coordinate that
/// changes; all higher bits are equal. A link changes the coordinate by 1 << halvings.
struct LinkMeasure {
  uint8_t shift;
  uint8_t halvings;
};
struct LinkMeasures {
  LinkMeasure by_link[link_codes];
};
namespace derive {
constexpr LinkMeasures link_measures() {
  LinkMeasures measures{};
  for (Link link = 0; link < link_codes; ++link) {
    const Vertex v = link_vector(link);
    const int32_t change = v.z != 0 ? v.z : v.y != 0 ? v.y : v.x;
    measures.by_link[link].shift = v.z != 0 ? 48 : v.y != 0 ? 32 : 16;
    measures.by_link[link].halvings = change == 2 || change == -2 ? 1 : 0;
  }
  return measures;
}
}  // namespace derive
inline constexpr LinkMeasures link_measures = derive::link_measures();

/// Returns the number of links from a corner straight to the next.
inline uint32_t links_between(CornerCode from, CornerCode to) {
  const LinkMeasure measure = link_measures.by_link[from.onwards()];
  const auto difference = static_cast<int32_t>(static_cast<uint32_t>(to.bits() >> measure.shift) -
                                               static_cast<uint32_t>(from.bits() >> measure.shift));
  return static_cast<uint32_t>(difference < 0 ? -difference : difference) >> measure.halvings;
}

}  // namespace discmc::host

#endif

// The sweep's view of the lookup table: what a cell adds to each plane, as rings of links.
//
// Neighbouring facets of one cell on one plane never need to be apart. A cell's surface falls into
// patches: at most one an incidence, at most five a cell. A patch is a ring of links, each on a
// face of the cell (where the cell on the other side may continue the plane) or, as a spoke to or
// from the centroid, inside the cell (where it never does). All 256 configurations use 222
// different patches.
#ifndef DISCMC_PATCH_TABLE_HPP
#define DISCMC_PATCH_TABLE_HPP

#include <stddef.h>

#include <discmc/cell.hpp>

namespace discmc {

/// Where a link of a patch lies: 2 * face + 0 or 1, or `spoke`. Both cells that share a face tell
/// its at most two links apart in the same way.
using Place = uint8_t;

constexpr Place behind_places = 6;  ///< places 0 to 5 are on faces towards cells already visited
constexpr Place spoke = 12;

constexpr bool is_behind(Place place) {
  return place < behind_places;
}
constexpr bool is_ahead(Place place) {
  return place >= behind_places && place < spoke;
}

/// The place of a face's link, in {0, 1} within the face: links that cut off one corner are told
/// apart by that corner's second coordinate, a link between opposite edges is alone.
constexpr int place_in_face(Point from, Point to) {
  const int face = face_of(from, to);
  const Vertex a = position(from);
  const Vertex b = position(to);
  const int a_second[] = {a.z, a.z, a.y};
  const int b_second[] = {b.z, b.z, b.y};
  const int first = a_second[face % 3];
  const int second = b_second[face % 3];
  const bool cuts_corner = (first + second) % 2 != 0;
  return cuts_corner ? (first == 1 ? second : first) / 2 : 0;
}

/// A ring of links, counter-clockwise seen from the tip of the normal. If any link is ahead, link 0
/// is. Owner: the links are the table's.
struct Patch {
  static constexpr int min_links = 3;
  static constexpr int max_links = 6;
  enum class Kind : uint8_t {
    facet,    ///< one facet: a triangle or the rectangle
    fan,      ///< a flat fan: as many facets as links
    sectors,  ///< of a fan that is not flat: two links are spokes, and each other has a facet
  };
  Kind kind;
  Incidence incidence;
  Point start;  ///< where link 0 begins
  uint8_t count;
  const uint8_t* link;  ///< place (upper 5 bits) and direction (lower 3 bits)

  constexpr Place place(int i) const { return link[i] >> 3; }
  constexpr Direction direction(int i) const { return link[i] & 7; }
  constexpr uint32_t facets() const {
    return kind == Kind::facet ? 1 : kind == Kind::fan ? count : count - 2U;
  }
};

/// The patches of every configuration, each stored once, in as many bytes as it has links and two:
/// firmware carries them. Those of c are at(first(c)) to at(first(c + 1) - 1).
struct PatchTable {
  static constexpr int total = 610;
  static constexpr int distinct = 222;
  static constexpr int distinct_links = 888;
  static constexpr int block_size = 32;  ///< configurations whose patches one byte can count
  static constexpr int counts = Patch::max_links - Patch::min_links + 1;
  uint16_t block[configurations / block_size + 1];
  uint8_t within[configurations + 1];
  uint8_t index[total];
  uint8_t of_count[counts];  ///< how many have 3, 4, 5, 6 links, in this order
  uint8_t
      patch[2 * distinct + distinct_links];  ///< kind (upper 3 bits) and incidence, start, links
  uint8_t
      below[16];  ///< by the four lower corner bits: bits 0 and 1 tell which links face_below has

  constexpr uint32_t first(int c) const { return uint32_t{block[c / block_size]} + within[c]; }
  constexpr Patch at(uint32_t i) const {
    const uint8_t* place = patch;
    uint8_t count = Patch::min_links;
    int number = index[i];
    for (const uint8_t* same = of_count; number >= *same; ++same, ++count) {
      number -= *same;
      place += size_t{*same} * (2 + count);
    }
    place += static_cast<size_t>(number) * (2 + count);
    return {static_cast<Patch::Kind>(place[0] >> 5), static_cast<Incidence>(place[0] & 31),
            place[1], count, place + 2};
  }
};

extern const PatchTable patch_table;

/// What one cell can need at worst, derived from the table: the basis of every reserve.
struct CellBounds {
  int patches;       ///< patches of a cell
  int links;         ///< links of all its patches together, spokes included
  int behind_links;  ///< of them on faces towards cells already visited
  int ahead_links;   ///< of them on faces towards cells not yet visited
};

constexpr CellBounds cell_bounds = {5, 17, 6, 6};

}  // namespace discmc

#endif

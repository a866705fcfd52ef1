// Counts of a surface, as in Table 1 of the paper.
#ifndef DISCMC_MESH_SURFACE_COUNTS_HPP
#define DISCMC_MESH_SURFACE_COUNTS_HPP

#include <cstdint>

namespace discmc::meshing {

/// Counts of regions, and of their simple rings and corners.
struct Counts {
  std::uint64_t regions = 0;
  std::uint64_t rings = 0;
  std::uint64_t holes = 0;
  std::uint64_t links = 0;
  std::uint64_t corners = 0;
  std::uint64_t of_three_corners = 0;  ///< regions
  std::uint64_t of_four_corners = 0;
  std::uint64_t of_more_corners = 0;
  std::uint64_t normals = 0;  ///< corners with a normal
};

inline Counts& operator+=(Counts& sum, const Counts& other) {
  for (auto count : {&Counts::regions, &Counts::rings, &Counts::holes, &Counts::links,
                     &Counts::corners, &Counts::of_three_corners, &Counts::of_four_corners,
                     &Counts::of_more_corners, &Counts::normals})
    sum.*count += other.*count;
  return sum;
}

}  // namespace discmc::meshing

#endif

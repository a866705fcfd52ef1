// What a surface consists of, as the paper's Table 1 counts it.
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
  std::uint64_t three = 0;    ///< regions with three corners in all
  std::uint64_t four = 0;     ///< with four
  std::uint64_t more = 0;     ///< with more
  std::uint64_t normals = 0;  ///< corners that have one
};

inline Counts& operator+=(Counts& sum, const Counts& more) {
  for (auto count :
       {&Counts::regions, &Counts::rings, &Counts::holes, &Counts::links, &Counts::corners,
        &Counts::three, &Counts::four, &Counts::more, &Counts::normals})
    sum.*count += more.*count;
  return sum;
}

}  // namespace discmc::meshing

#endif

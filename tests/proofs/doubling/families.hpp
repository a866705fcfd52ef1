// Families of volumes with the same structure at every size. Twice the size means two, four or
// eight times the work.
#pragma once

#include "oracle/volume.hpp"

namespace discmc::doubling {

struct Family {
  const char* name;
  uint32_t size;  ///< the smaller size; the other one is twice as large
  reference::BitVolume (*make)(uint32_t size);
};

/// Returns all families.
extern const Family families[];
extern const size_t family_count;

}  // namespace discmc::doubling

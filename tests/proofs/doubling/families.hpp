// Families of volumes: the same structure at every size, so that twice the size is twice, four
// times or eight times the work.
#pragma once

#include "oracle/volume.hpp"

namespace discmc::doubling {

struct Family {
  const char* name;
  uint32_t size;  ///< the first; the second is twice as large
  reference::BitVolume (*make)(uint32_t size);
};

/// All of them.
extern const Family families[];
extern const size_t family_count;

}  // namespace discmc::doubling

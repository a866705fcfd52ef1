// Flash: the patch table alone.
#include <discmc/patch_table.hpp>

extern "C" const discmc::PatchTable* run() {
  return &discmc::patch_table;
}

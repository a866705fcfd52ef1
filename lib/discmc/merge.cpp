// Merge without normals, but for what is in delivery.cpp.
#include <discmc/merge_definitions.hpp>

namespace discmc {

template class Merge<uint16_t>;
template class Merge<uint32_t>;

}  // namespace discmc

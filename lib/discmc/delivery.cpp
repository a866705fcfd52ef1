// The side of Merge towards the sink, without normals.
#include <discmc/delivery_definitions.hpp>

namespace discmc {

template class Merge<uint16_t>;
template class Merge<uint32_t>;

}  // namespace discmc

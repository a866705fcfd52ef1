// The encoder without normals.
#include <discmc/encoder_definitions.hpp>

namespace discmc {

template class BasicEncoder<NoRecordNormals>;

}  // namespace discmc

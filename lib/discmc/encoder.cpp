// The encoder without normals.
#include <discmc/stream/encoder_definitions.hpp>

namespace discmc {

template class BasicEncoder<NoRecordNormals>;

}  // namespace discmc

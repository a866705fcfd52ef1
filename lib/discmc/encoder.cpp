// The encoders without normals.
#include <discmc/stream/encoder_definitions.hpp>

namespace discmc {

template class BasicEncoder<NoRecordNormals>;
template class BasicEncoder<NoRecordNormals, wire::max_appended>;

}  // namespace discmc

// The encoder with normals, apart from the other, which costs what it costs without.
#include <discmc/stream/encoder_definitions.hpp>

namespace discmc {

template class BasicEncoder<RecordNormals>;

}  // namespace discmc

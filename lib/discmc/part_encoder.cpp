// The encoder of parts. Beside the others in one file it would make them slower: a compiler that
// saves space inlines what is called once.
#include <discmc/stream/encoder_definitions.hpp>

namespace discmc {

template class BasicEncoder<NoRecordNormals, wire::max_appended>;

}  // namespace discmc

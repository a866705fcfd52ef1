// The kind of encoders that encode normals, too. A file of its own: see c_normal_kinds.cpp.
#include <discmc/c/encoder_kind.hpp>

const discmc_encoder_kind discmc_regions_with_normals =
    discmc::encoder_kind(1, [](discmc::Encoder& encoder) { encoder.encode_normals(); });

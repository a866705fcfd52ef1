// The kind of encoders that encode normals, too. A file of its own: see c_normal_kinds.cpp.
#include <discmc/c/encoder_kind.hpp>

static_assert(DISCMC_NORMAL_ENCODER_BYTES >=
                  discmc::bytes_with_object(
                      discmc::EncoderKind<discmc::NormalEncoder>::functions.object_bytes, 0),
              "the size in sizes.h suffices");

const discmc_encoder_kind discmc_regions_with_normals =
    discmc::EncoderKind<discmc::NormalEncoder>::functions;

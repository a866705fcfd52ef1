// RAM: arrays with the sizes of the types in their names. The symbols of the object file show the
// sizes.
#include <discmc/byte_output.hpp>
#include <discmc/decoder.hpp>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <discmc/fraction_slice_encoder.hpp>
#include <discmc/joiner.hpp>
#include <discmc/receiver.hpp>
#include <discmc/slice_encoder.hpp>

using namespace discmc;

using Quarters = FractionSliceEncoder<uint16_t>;

#define DISCMC_OBJECT(Class) uint8_t object_##Class[sizeof(Class)];
#define DISCMC_ARENA(size)                                                 \
  uint8_t least_##size[Extractor16::minimum_bytes({size, size})];          \
  uint8_t slices_##size[SliceEncoder::minimum_bytes({{size, size}})];      \
  uint8_t keys_##size[SliceEncoder::minimum_bytes({{size, size}, {}, 1})]; \
  uint8_t quarters_##size[Quarters::minimum_bytes({{size, size}, {}, 0, 1, {}, 4})];
#define DISCMC_SURFACES(count, size)                                                          \
  uint8_t encoder##count##_##size[SliceEncoder::minimum_bytes({{size, size}, {}, 0, count})]; \
  uint8_t rows##count##_##size[SliceDecoder::minimum_bytes({size, size}, count)];             \
  uint8_t sweep##count##_##size[Receiver::minimum_bytes({size, size}, count)];

extern "C" {
DISCMC_OBJECT(Extractor16)
DISCMC_OBJECT(Encoder)
DISCMC_OBJECT(Decoder)
DISCMC_OBJECT(SliceEncoder)
uint8_t object_FractionSliceEncoder[sizeof(Quarters)];
DISCMC_OBJECT(SliceDecoder)
DISCMC_OBJECT(Receiver)
DISCMC_OBJECT(Joiner)
DISCMC_OBJECT(SharedOutput)

DISCMC_ARENA(32)
DISCMC_ARENA(64)
DISCMC_ARENA(128)
DISCMC_ARENA(256)
DISCMC_ARENA(512)

DISCMC_SURFACES(1, 64)
DISCMC_SURFACES(2, 64)
DISCMC_SURFACES(4, 64)
DISCMC_SURFACES(1, 256)
DISCMC_SURFACES(2, 256)
DISCMC_SURFACES(4, 256)
}

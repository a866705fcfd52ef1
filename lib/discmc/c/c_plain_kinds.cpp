// The kinds of extractors that make no normals, for firmware.
#include <discmc/c/extractor_kind.hpp>

namespace discmc {

template <class Sample>
using PlainKind = ExtractorKind<Extractor16, Sample>;

static_assert(red_zone_bytes > 0 || DISCMC_EXTRACTOR_BYTES(31, 7, 5) >=
                                        bytes_with_object(PlainKind<Bits>::functions.object_bytes,
                                                          Extractor16::bytes_for({31, 7}, {5, 0})),
              "the size in sizes.h suffices");
static_assert(DISCMC_MIN_SLOTS == minimum_capacities().slots &&
                  detail::sizing::is_valid<uint16_t>({DISCMC_MAX_SLOTS, 0}) &&
                  !detail::sizing::is_valid<uint16_t>({DISCMC_MAX_SLOTS + 1, 0}),
              "constants are the same");

}  // namespace discmc

// These must be outside the namespace, because discmc.h declares them.
const discmc_extractor_kind discmc_plain_bits = discmc::PlainKind<discmc::Bits>::functions;
const discmc_extractor_kind discmc_plain_u8 = discmc::PlainKind<uint8_t>::functions;
const discmc_extractor_kind discmc_plain_u16 = discmc::PlainKind<uint16_t>::functions;
const discmc_extractor_kind discmc_plain_i16 = discmc::PlainKind<int16_t>::functions;

// The kinds of extractors that make normals. A file of its own, so that plain scanners do not link
// them even if the linker drops whole files alone.
#include <discmc/c/extractor_kind.hpp>

namespace discmc {

template <class Sample>
using NormalKind = ExtractorKind<NormalExtractor16<Sample>, Sample>;

template <class Sample>
constexpr bool size_suffices =
    red_zone_bytes > 0 ||
    DISCMC_NORMAL_EXTRACTOR_BYTES(31, 7, sizeof(Sample), 5) >=
        bytes_with_object(
            NormalKind<Sample>::functions.object_bytes,
            detail::sizing::bytes_for<uint16_t, detail::trace::GradientIntake<Sample>>({31, 7},
                                                                                       {5, 0}));
static_assert(size_suffices<uint8_t> && size_suffices<uint16_t> && size_suffices<int16_t>,
              "the sizes in sizes.h suffice");

}  // namespace discmc

const discmc_extractor_kind discmc_normals_u8 = discmc::NormalKind<uint8_t>::functions;
const discmc_extractor_kind discmc_normals_u16 = discmc::NormalKind<uint16_t>::functions;
const discmc_extractor_kind discmc_normals_i16 = discmc::NormalKind<int16_t>::functions;

// Objects that use the caller's memory, or point into themselves, cannot be copied.
#include <discmc/discmc.hpp>
#include "host/host_extractor.hpp"
#include "test.hpp"

#include <type_traits>

using namespace discmc;

namespace {

template <class Object>
constexpr bool stays_where_it_is =
    !std::is_copy_constructible_v<Object> && !std::is_move_constructible_v<Object> &&
    !std::is_copy_assignable_v<Object> && !std::is_move_assignable_v<Object>;

}  // namespace

TEST_CASE("types that use the caller's memory or point into themselves cannot be copied") {
  static_assert(stays_where_it_is<Extractor16> && stays_where_it_is<Extractor32> &&
                    stays_where_it_is<HostExtractor> &&
                    stays_where_it_is<NormalExtractor16<int16_t>>,
                "two extractors would write to one memory");
  static_assert(stays_where_it_is<Encoder> && stays_where_it_is<SliceEncoder> &&
                    stays_where_it_is<Decoder> && stays_where_it_is<SliceDecoder> &&
                    stays_where_it_is<SurfaceDecoder>,
                "a copy would point into the original");
  static_assert(stays_where_it_is<Joiner> && stays_where_it_is<MajorityFilter> &&
                    stays_where_it_is<RowRing> && stays_where_it_is<Downsampler<uint8_t>> &&
                    stays_where_it_is<SampleWindow<uint8_t>>,
                "two would write to one memory");
  static_assert(stays_where_it_is<CheckpointStore>, "its parts would be those of the original");
  static_assert(stays_where_it_is<SharedOutput>, "encoders would go on with the original");
  static_assert(stays_where_it_is<SurfaceGroup<Extractor16>>, "each would miss rows");
}

TEST_CASE("savable objects are trivially copyable") {
  static_assert(std::is_trivially_copyable_v<Extractor16> &&
                    std::is_trivially_copyable_v<NormalExtractor16<int16_t>> &&
                    std::is_trivially_copyable_v<Encoder> &&
                    std::is_trivially_copyable_v<SliceEncoder>,
                "checkpoints copy the bytes of objects");
}

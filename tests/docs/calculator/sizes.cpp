// Prints sizes of some hundred scans from the library: width, height, memory and bytes per index,
// then the expected results of calculator.js.
#include <cstdint>
#include <cstdio>
#include <discmc/extractor.hpp>
#include <discmc/slice_encoder.hpp>
#include <initializer_list>

using namespace discmc;

namespace {

template <class Index>
void print(const Limits& limits, std::uint64_t memory) {
  const Capacities capacities = discmc::Extractor<Index>::default_capacities(limits, memory);
  const std::uint64_t sizes[] = {limits.width,
                                 limits.height,
                                 memory,
                                 sizeof(Index),
                                 discmc::Extractor<Index>::minimum_bytes(limits),
                                 capacities.slots,
                                 capacities.holes,
                                 discmc::Extractor<Index>::bytes_for(limits, capacities),
                                 SliceEncoder::minimum_bytes({limits, {}, 16}),
                                 SliceEncoder::minimum_bytes({limits, {}, 1})};
  for (const std::uint64_t size : sizes)
    std::printf("%llu ", static_cast<unsigned long long>(size));
  std::printf("\n");
}

}  // namespace

int main() {
  for (const std::uint32_t width : {1U, 29U, 30U, 59U, 64U, 100U, 256U, 32766U})
    for (const std::uint32_t height : {1U, 2U, 31U, 32U, 63U, 64U, 256U, 5000U})
      for (const std::uint64_t more : {0U, 3U, 4U, 12U, 1000U, 24576U, 1U << 20}) {
        const Limits limits{width, height};
        print<std::uint16_t>(limits, Extractor16::minimum_bytes(limits) + more);
        print<std::uint32_t>(limits, Extractor32::minimum_bytes(limits) + more);
      }
}

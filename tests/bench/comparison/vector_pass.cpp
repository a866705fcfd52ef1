#include "contenders.hpp"

namespace discmc::bench {

namespace {

int32_t all_or_ed(const Samples& samples) {
  return std::visit(
      [](const auto& values) {
        int32_t bits = 0;
        for (const int32_t value : values) bits |= value;
        return bits;
      },
      samples);
}

}  // namespace

Contender vector_pass(const Volume& volume) {
  return {"vector pass", "bits or-ed together",
          [&volume] { return static_cast<uint64_t>(all_or_ed(volume.samples)); }};
}

}  // namespace discmc::bench

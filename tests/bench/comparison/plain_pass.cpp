#include "contenders.hpp"

namespace discmc::bench {

namespace {

int32_t greatest(const Samples& samples) {
  return std::visit(
      [](const auto& values) {
        int32_t greatest = INT32_MIN;
        for (const int32_t value : values) greatest = value > greatest ? value : greatest;
        return greatest;
      },
      samples);
}

}  // namespace

Contender plain_pass(const Volume& volume) {
  return {"plain pass", "greatest sample",
          [&volume] { return static_cast<uint64_t>(greatest(volume.samples)); }};
}

}  // namespace discmc::bench

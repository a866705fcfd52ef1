// The kinds of encoders, with or without normals. A program links only the kinds that it names.
#ifndef DISCMC_C_ENCODER_KIND_HPP
#define DISCMC_C_ENCODER_KIND_HPP

#include <discmc/c/object.hpp>
#include <discmc/encoder.hpp>

struct discmc_encoder : discmc::KindObject {
  discmc::Encoder encoder;
};

struct discmc_encoder_kind : discmc::Kind {
  void (*prepare)(discmc::Encoder& encoder);  // before start() and after restore()
};

namespace discmc {

constexpr discmc_encoder_kind encoder_kind(uint32_t number, void (*prepare)(Encoder& encoder)) {
  constexpr uint32_t bytes = sizeof(discmc_encoder);
  return {{bytes | number << 16 | Encoder::layout << 20, bytes}, prepare};
}

}  // namespace discmc

#endif

// The kinds of encoders: tables of what an encoder of a C++ type does. A program links those that
// it names.
#ifndef DISCMC_C_ENCODER_KIND_HPP
#define DISCMC_C_ENCODER_KIND_HPP

#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/encoder.hpp>

struct discmc_encoder {
  discmc::Seal seal;
  const discmc_encoder_kind* kind;
};

struct discmc_encoder_kind {
  uint32_t layout;
  uint32_t object_bytes;
  discmc::Status (*start)(discmc_encoder& encoder, const discmc::StreamLabel& label,
                          const discmc::ByteOutput& output);
  discmc::Status (*restore)(discmc_encoder& encoder, const discmc::ByteOutput& output);
  discmc::Answer (*take)(discmc_encoder& encoder, const discmc::Event& event);
  discmc::Status (*tell)(discmc_encoder& encoder, const discmc::ApplicationRecord& record);
  bool (*flush)(discmc_encoder& encoder);
  void (*set_output)(discmc_encoder& encoder, const discmc::ByteOutput& output);
  uint64_t (*stream_bytes)(const discmc_encoder& encoder);
};

namespace discmc {

inline StreamLabel cpp(const discmc_stream_label& from) {
  return {from.depth,
          {from.spacing_nm[0], from.spacing_nm[1], from.spacing_nm[2]},
          from.scan,
          from.channel};
}

template <class EncoderOfCpp>
struct EncoderKind {
  struct Stored : discmc_encoder {
    EncoderOfCpp encoder;
  };
  static EncoderOfCpp& in(discmc_encoder& encoder) { return static_cast<Stored&>(encoder).encoder; }

  static constexpr discmc_encoder_kind functions = {
      sizeof(Stored) | EncoderOfCpp::layout << 20,
      sizeof(Stored),
      [](discmc_encoder& encoder, const StreamLabel& label, const ByteOutput& output) {
        return in(encoder).start(label, output);
      },
      [](discmc_encoder& encoder, const ByteOutput& output) {
        return in(encoder).continue_to(output);
      },
      [](discmc_encoder& encoder, const Event& event) { return in(encoder).take(event); },
      [](discmc_encoder& encoder, const ApplicationRecord& record) {
        return in(encoder).tell(record);
      },
      [](discmc_encoder& encoder) { return in(encoder).flush(); },
      [](discmc_encoder& encoder, const ByteOutput& output) { in(encoder).set_output(output); },
      [](const discmc_encoder& encoder) {
        return static_cast<const Stored&>(encoder).encoder.bytes();
      },
  };
};

}  // namespace discmc

#endif

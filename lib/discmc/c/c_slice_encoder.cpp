#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/fraction_slice_encoder.hpp>

struct discmc_slice_encoder : discmc::KindObject {
  discmc::SliceEncoder encoder;
};

struct discmc_slice_kind : discmc::Kind {
  discmc_sample_type type;
  discmc_push_result (*push)(discmc::SliceEncoder& encoder, const void* samples, uint32_t count,
                             uint32_t stride);
  // 0 for levels that the kind lacks.
  uint64_t (*minimum_bytes)(const discmc::SliceEncoderConfig& config);
  discmc::Status (*start)(discmc::SliceEncoder& encoder, const discmc::SliceEncoderConfig& config,
                          discmc::Memory memory, const discmc::ByteOutput& output);
  discmc::Status (*restore)(discmc::SliceEncoder& encoder, discmc::Memory memory,
                            const discmc::ByteOutput& output);
};

namespace discmc {

namespace {

static_assert(red_zone_bytes > 0 ||
                  DISCMC_SLICE_ENCODER_BYTES(31, 7, 2) >=
                      bytes_with_object(sizeof(discmc_slice_encoder),
                                        SliceEncoder::minimum_bytes({{31, 7}, {}, 0, 2})),
              "the size in sizes.h suffices");

SliceEncoderConfig config_of(const discmc_slice_encoder_config& from) {
  const int32_t(&thresholds)[StreamHeader::max_surfaces] = from.thresholds;
  return {cpp(from.limits),        {thresholds[0], thresholds[1], thresholds[2], thresholds[3]},
          from.key_slice_interval, from.surface_count == 0 ? uint8_t{1} : from.surface_count,
          cpp(from.label),         from.levels};
}

template <class Sample>
constexpr discmc_slice_kind slice_kind = {
    {sizeof(discmc_slice_encoder) | type_of<Sample> << 16 | SliceEncoder::layout << 20,
     sizeof(discmc_slice_encoder)},
    type_of<Sample>,
    push_as<Sample, SliceEncoder>,
    SliceEncoder::minimum_bytes,
    [](SliceEncoder& encoder, const SliceEncoderConfig& config, Memory memory,
       const ByteOutput& output) { return encoder.start(config, memory, output); },
    [](SliceEncoder& encoder, Memory memory, const ByteOutput& output) {
      return encoder.restore(memory, output);
    }};

// An object whose encoder is one with fractions. The functions of all kinds use its base class.
template <class Sample>
struct FractionObject : KindObject {
  FractionSliceEncoder<Sample> encoder;
};

static_assert(red_zone_bytes > 0 ||
                  DISCMC_FRACTION_SLICE_ENCODER_BYTES(31, 7, 2, 4, 2) >=
                      bytes_with_object(sizeof(FractionObject<uint16_t>),
                                        FractionSliceEncoder<uint16_t>::minimum_bytes(
                                            {{31, 7}, {}, 0, 2, {}, 4})),
              "the size in sizes.h suffices");

template <class Sample>
FractionSliceEncoder<Sample>& with_fractions(SliceEncoder& encoder) {
  static_assert(sizeof(FractionObject<Sample>) - sizeof(FractionSliceEncoder<Sample>) ==
                    sizeof(discmc_slice_encoder) - sizeof(SliceEncoder),
                "the encoders of both objects are at one place");
  return static_cast<FractionSliceEncoder<Sample>&>(encoder);
}

template <class Sample>
constexpr discmc_slice_kind fraction_kind = {
    {sizeof(FractionObject<Sample>) | type_of<Sample> << 16 | SliceEncoder::layout << 20,
     sizeof(FractionObject<Sample>)},
    type_of<Sample>,
    [](SliceEncoder& encoder, const void* samples, uint32_t count, uint32_t stride) {
      return push_as<Sample>(with_fractions<Sample>(encoder), samples, count, stride);
    },
    [](const SliceEncoderConfig& config) {
      const bool has_levels = config.levels == 2 || config.levels == 4;
      return has_levels ? FractionSliceEncoder<Sample>::minimum_bytes(config) : 0;
    },
    [](SliceEncoder& encoder, const SliceEncoderConfig& config, Memory memory,
       const ByteOutput& output) {
      return with_fractions<Sample>(encoder).start(config, memory, output);
    },
    [](SliceEncoder& encoder, Memory memory, const ByteOutput& output) {
      return with_fractions<Sample>(encoder).restore(memory, output);
    }};

}  // namespace

extern "C" {

uint64_t discmc_slice_encoder_bytes(const discmc_slice_encoder_config* config) {
  const discmc_slice_kind* const kind = config->kind;
  if (kind == nullptr || !cpp(config->limits).is_valid() ||
      config->surface_count > StreamHeader::max_surfaces)
    return 0;
  const uint64_t encoder_bytes = kind->minimum_bytes(config_of(*config));
  return encoder_bytes == 0 ? 0 : bytes_with_object(kind->object_bytes, encoder_bytes);
}

discmc_status discmc_slice_encoder_start(discmc_slice_encoder** encoder,
                                         const discmc_slice_encoder_config* config) {
  return start<discmc_slice_encoder>(
      encoder, *config, [&](discmc_slice_encoder& object, Memory rest) {
        return config->kind->start(object.encoder, config_of(*config), rest, cpp(config->output));
      });
}
discmc_status discmc_slice_encoder_restore(discmc_slice_encoder** encoder,
                                           const discmc_slice_encoder_config* config) {
  return restore<discmc_slice_encoder>(
      encoder, *config, [&](discmc_slice_encoder& object, Memory rest) {
        return config->kind->restore(object.encoder, rest, cpp(config->output));
      });
}

discmc_status discmc_slice_encoder_save(discmc_slice_encoder* encoder, discmc_memory* part) {
  Memory parts[2];
  const Status status = encoder->encoder.save(parts);
  if (status == Status::ok) *part = encoder->part_with(parts[1].bytes);
  return c(status);
}

discmc_push_result discmc_slice_encoder_push(discmc_slice_encoder* encoder, discmc_sample_type type,
                                             const void* samples, uint32_t count, uint32_t stride) {
  const auto& kind = static_cast<const discmc_slice_kind&>(*encoder->kind);
  if (type != kind.type) return {DISCMC_BAD_SAMPLES, 0};
  return kind.push(encoder->encoder, samples, count, stride);
}
discmc_push_result discmc_slice_encoder_skip_row(discmc_slice_encoder* encoder,
                                                 uint8_t substitute) {
  return c(encoder->encoder.skip_row(static_cast<Substitute>(substitute)));
}
discmc_status discmc_slice_encoder_resume(discmc_slice_encoder* encoder) {
  return c(encoder->encoder.resume());
}
discmc_status discmc_slice_encoder_finish(discmc_slice_encoder* encoder) {
  return c(encoder->encoder.finish());
}
discmc_status discmc_slice_encoder_abandon(discmc_slice_encoder* encoder) {
  return c(encoder->encoder.abandon());
}
discmc_status discmc_slice_encoder_write_record(discmc_slice_encoder* encoder,
                                                const discmc_application_record* record) {
  return c(encoder->encoder.write_record(cpp(*record)));
}
discmc_status discmc_slice_encoder_flush(discmc_slice_encoder* encoder) {
  return c(encoder->encoder.flush());
}
void discmc_slice_encoder_set_output(discmc_slice_encoder* encoder, discmc_byte_output output) {
  encoder->encoder.set_output(cpp(output));
}
discmc_slice_encoder_info discmc_slice_encoder_get_info(const discmc_slice_encoder* encoder) {
  return {encoder->encoder.bytes(), encoder->encoder.slices(), encoder->encoder.rows()};
}

}  // extern "C"

}  // namespace discmc

const discmc_slice_kind discmc_slices_bits = discmc::slice_kind<discmc::Bits>;
const discmc_slice_kind discmc_slices_u8 = discmc::slice_kind<uint8_t>;
const discmc_slice_kind discmc_slices_u16 = discmc::slice_kind<uint16_t>;
const discmc_slice_kind discmc_slices_i16 = discmc::slice_kind<int16_t>;
const discmc_slice_kind discmc_fraction_slices_u8 = discmc::fraction_kind<uint8_t>;
const discmc_slice_kind discmc_fraction_slices_u16 = discmc::fraction_kind<uint16_t>;
const discmc_slice_kind discmc_fraction_slices_i16 = discmc::fraction_kind<int16_t>;

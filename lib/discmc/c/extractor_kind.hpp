// The kinds of extractors: tables of the functions of a C++ type. A program links only the kinds
// that it names.
#ifndef DISCMC_C_EXTRACTOR_KIND_HPP
#define DISCMC_C_EXTRACTOR_KIND_HPP

#include <discmc/c/object.hpp>
#include <discmc/c/values.hpp>
#include <discmc/normal_extractor.hpp>

namespace discmc {

/// The queries of an extractor of any type.
struct ExtractorView {
  const Statistics* statistics;
  const Capacities* capacities;
  Peaks peaks;
  uint32_t slices, rows;
  size_t bytes_used;
};

/// The properties that determine the memory of a scan, besides limits and slots.
struct ScanSizes {
  uint8_t slot_bytes;
  uint8_t sample_bytes;  ///< of the samples kept for normals, or 0
};

/// As bytes_for(), in one function for all types.
constexpr uint64_t bytes_of_scan(const ScanSizes& sizes, const Limits& limits, uint32_t slots) {
  uint64_t bytes =
      Extractor16::bytes_for(limits, {0, 0}) + Arena::aligned(uint64_t{slots} * sizes.slot_bytes);
  const uint32_t rows = detail::trace::GradientIntake<uint8_t>::ring_rows(limits);
  if (sizes.sample_bytes > 0)
    bytes += Arena::bytes_of(rows * limits.width, sizes.sample_bytes) +
             Arena::bytes_of(rows, sizeof(uint16_t));
  return bytes;
}

}  // namespace discmc

struct discmc_extractor : discmc::KindObject {};

struct discmc_extractor_kind : discmc::Kind {
  discmc::ScanSizes sizes;
  /// The scan uses the rest of the memory. `restores`: the object is a saved one.
  discmc::Status (*start)(discmc_extractor& extractor, const discmc_extractor_config& config,
                          discmc::Memory memory, bool restores);
  discmc_push_result (*push)(discmc_extractor& extractor, discmc_sample_type type,
                             const void* samples, uint32_t count, uint32_t stride);
  discmc::PushResult (*skip_row)(discmc_extractor& extractor, discmc::Substitute substitute);
  discmc::Status (*resume)(discmc_extractor& extractor);
  discmc::Status (*finish)(discmc_extractor& extractor);
  discmc::Status (*abandon)(discmc_extractor& extractor);
  discmc::Status (*save)(discmc_extractor& extractor, discmc::Memory* parts);
  void (*look)(const discmc_extractor& extractor, discmc::ExtractorView& view);
};

namespace discmc {

/// The properties of an extractor's type.
template <class Index, class Intake, class Sweep>
struct ExtractorType {
  static constexpr ScanSizes sizes = {detail::sizing::slot_bytes<Index, Intake>, Intake::type / 2};
  static_assert(bytes_of_scan(sizes, {31, 7}, 5) ==
                    detail::sizing::bytes_for<Index, Intake>({31, 7}, {5, 0}),
                "it is as many bytes");
  static constexpr bool has_normals = Intake::holds_samples;
  static Capacities capacities(const Limits& limits, uint64_t bytes) {
    return detail::sizing::default_capacities<Index, Intake>(limits, bytes);
  }
};
template <class Index, class Intake, class Sweep>
ExtractorType<Index, Intake, Sweep> type_of_extractor(
    const BasicExtractor<Index, Intake, Sweep>& extractor);

template <class Scanner, class Sample>
struct ExtractorKind {
  using Type = decltype(type_of_extractor(*static_cast<const Scanner*>(nullptr)));
  struct Stored : discmc_extractor {
    WithSink<Scanner> with_sink;
  };

  static Scanner& in(discmc_extractor& extractor) {
    return static_cast<Stored&>(extractor).with_sink.object;
  }

  static Status start(discmc_extractor& extractor, const discmc_extractor_config& config,
                      Memory memory, bool restores) {
    Scanner& scanner = in(extractor);
    const Sink sink = static_cast<Stored&>(extractor).with_sink.set_sink(config.sink);
    if (restores) return scanner.restore(memory, sink);
    if constexpr (Type::has_normals) scanner.set_spacing(config.spacing_nm);
    Limits limits = cpp(config.limits);
    limits.slab = {config.slab.first, config.slab.continues_below != 0,
                   config.slab.continues_above != 0};
    const Capacities capacities = config.slots == 0 ? Type::capacities(limits, memory.bytes)
                                                    : Capacities{config.slots, config.slots / 16};
    return scanner.start(limits, capacities, config.threshold, memory, sink);
  }

  static discmc_push_result push(discmc_extractor& extractor, discmc_sample_type type,
                                 const void* samples, uint32_t count, uint32_t stride) {
    if (type != type_of<Sample>) return {DISCMC_BAD_SAMPLES, 0};
    return push_as<Sample>(in(extractor), samples, count, stride);
  }

  template <auto method>
  static Status call(discmc_extractor& extractor) {
    return (in(extractor).*method)();
  }

  static void look(const discmc_extractor& extractor, ExtractorView& view) {
    const Scanner& scanner = static_cast<const Stored&>(extractor).with_sink.object;
    view.statistics = &scanner.statistics();
    view.capacities = &scanner.capacities();
    view.peaks = scanner.peaks();
    view.slices = scanner.slices();
    view.rows = scanner.rows();
    view.bytes_used = scanner.bytes_used();
  }

  static constexpr discmc_extractor_kind functions = {
      {sizeof(Stored) | type_of<Sample> << 16 | Scanner::layout << 20, sizeof(Stored)},
      Type::sizes,
      start,
      push,
      [](discmc_extractor& extractor, Substitute substitute) {
        return in(extractor).skip_row(substitute);
      },
      call<&Scanner::resume>,
      call<&Scanner::finish>,
      call<&Scanner::abandon>,
      [](discmc_extractor& extractor, Memory* parts) { return in(extractor).save(parts); },
      look,
  };
};

}  // namespace discmc

#endif

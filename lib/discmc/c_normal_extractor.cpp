// discmc.h in terms of the C++ library: extractors that make normals. A file of its own, so that
// plain scanners do not link them.
//
// A C object is storage, and its start says what kind of extractor lies in it. A kind is what such
// an extractor does, as a table of functions: so a program links the kinds that it names, and no
// other.
#include <discmc/discmc.h>

#include <discmc/c_extractors.hpp>
#include <discmc/gradient_normals.hpp>

struct discmc_normal_kind {
  using Limits = discmc::Limits;
  using Capacities = discmc::Capacities;
  using Object = discmc_normal_extractor;

  uint32_t sample_type;
  uint64_t (*bytes_for)(const Limits& limits, const Capacities& capacities);
  Capacities (*default_capacities)(const Limits& limits, uint64_t bytes);
  void (*set_spacing)(Object& object, const int32_t (&spacing_nm)[3]);
  discmc_status (*start)(Object& object, const discmc_limits* limits,
                         const discmc_capacities* capacities, int32_t threshold,
                         discmc_memory memory, const discmc_sink* sink);
  discmc_push_result (*push)(Object& object, const void* samples, uint32_t count, uint32_t stride);
  discmc_push_result (*skip_row)(Object& object, uint8_t substitute);
  discmc_status (*reset)(Object& object);
  discmc_status (*resume)(Object& object);
  discmc_status (*finish)(Object& object);
  discmc_status (*abandon)(Object& object);
  discmc_status (*save)(const Object& object, discmc_normal_extractor_checkpoint* checkpoint);
  discmc_status (*restore)(Object& object, const discmc_normal_extractor_checkpoint* checkpoint,
                           discmc_memory memory, const discmc_sink* sink);
  discmc_statistics (*statistics)(const Object& object);
  discmc_limits (*limits)(const Object& object);
  discmc_capacities (*capacities)(const Object& object);
  discmc_high_water (*high_water)(const Object& object);
  size_t (*bytes_used)(const Object& object);
  uint32_t (*slices)(const Object& object);
  uint32_t (*rows)(const Object& object);
};

namespace discmc {

namespace {

// An extractor in storage of C's, and before it of which kind it is; null before any start.
struct NormalHead {
  const discmc_normal_kind* kind;
};
template <class AnyExtractor>
struct StoredNormals : NormalHead {
  SinkAdapter<AnyExtractor> adapter;
};

const discmc_normal_kind* kind_of(const discmc_normal_extractor* extractor) {
  return reinterpret_cast<const NormalHead*>(extractor)->kind;
}

// Makes it one of this kind; another is forgotten.
void become(discmc_normal_extractor* extractor, const discmc_normal_kind* kind) {
  if (kind_of(extractor) == kind) return;
  *extractor = {};
  reinterpret_cast<NormalHead*>(extractor)->kind = kind;
  kind->set_spacing(*extractor, {0, 0, 0});
}

// The functions of a kind.
template <class Index, class Sample>
struct NormalKind {
  using Normals = GradientNormals<Sample>;
  using Scanner = NormalExtractor<Index, Sample>;
  using Object = discmc_normal_extractor;

  static_assert(fits<StoredNormals<Scanner>, discmc_normal_extractor> &&
                    fits<Checkpoint<Scanner>, discmc_normal_extractor_checkpoint>,
                "the sizes in discmc.h are enough and not much more");

  static SinkAdapter<Scanner>& adapter(Object& object) {
    return reinterpret_cast<StoredNormals<Scanner>&>(object).adapter;
  }
  static Scanner& in(Object& object) { return adapter(object).object; }
  static const Scanner& in(const Object& object) {
    return reinterpret_cast<const StoredNormals<Scanner>&>(object).adapter.object;
  }

  static void set_spacing(Object& object, const int32_t (&spacing_nm)[3]) {
    in(object).set_spacing(spacing_nm);
  }
  static discmc_status start(Object& object, const discmc_limits* limits,
                             const discmc_capacities* capacities, int32_t threshold,
                             discmc_memory memory, const discmc_sink* sink) {
    return discmc::start(adapter(object), limits, capacities, threshold, memory, sink);
  }
  static discmc_push_result push(Object& object, const void* samples, uint32_t count,
                                 uint32_t stride) {
    return c(in(object).push(static_cast<const Sample*>(samples), count, stride));
  }
  static discmc_push_result skip_row(Object& object, uint8_t substitute) {
    return c(in(object).skip_row(static_cast<Substitute>(substitute)));
  }
  template <auto method>
  static discmc_status call(Object& object) {
    return c((in(object).*method)());
  }
  static discmc_status save(const Object& object, discmc_normal_extractor_checkpoint* checkpoint) {
    return discmc::save(in(object), checkpoint);
  }
  static discmc_status restore(Object& object, const discmc_normal_extractor_checkpoint* checkpoint,
                               discmc_memory memory, const discmc_sink* sink) {
    return discmc::restore(adapter(object), checkpoint, memory, sink);
  }
  static discmc_statistics statistics(const Object& object) { return c(in(object).statistics()); }
  static discmc_limits limits(const Object& object) { return c(in(object).limits()); }
  static discmc_capacities capacities(const Object& object) { return c(in(object).capacities()); }
  static discmc_high_water high_water(const Object& object) { return c(in(object).high_water()); }
  static size_t bytes_used(const Object& object) { return in(object).bytes_used(); }
  static uint32_t slices(const Object& object) { return in(object).slices(); }
  static uint32_t rows(const Object& object) { return in(object).rows(); }

  static constexpr discmc_normal_kind functions = {
      sample_type<Sample>,
      discmc::bytes_for<Index, Normals>,
      discmc::default_capacities<Index, Normals>,
      set_spacing,
      start,
      push,
      skip_row,
      call<&Scanner::reset>,
      call<&Scanner::resume>,
      call<&Scanner::finish>,
      call<&Scanner::abandon>,
      save,
      restore,
      statistics,
      limits,
      capacities,
      high_water,
      bytes_used,
      slices,
      rows,
  };
};

static_assert(DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(31, 7, 1) ==
                      minimum_bytes<uint16_t, GradientNormals<uint8_t>>({31, 7}) &&
                  DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(31, 7, 2) ==
                      minimum_bytes<uint16_t, GradientNormals<int16_t>>({31, 7}) &&
                  DISCMC_NORMAL_DEFAULT_RECORDS_(31, 7, 1, 5000) ==
                      default_capacities<uint16_t, GradientNormals<uint8_t>>({31, 7}, 5000).records,
              "the constants of sizes.h are what the functions give; the tests have many more");

constexpr discmc_status not_started = DISCMC_NOT_STARTED;

template <class Sample>
discmc_push_result push_to(discmc_normal_extractor* extractor, const Sample* samples,
                           uint32_t count, uint32_t stride) {
  const discmc_normal_kind* const kind = kind_of(extractor);
  if (kind == nullptr || kind->sample_type != sample_type<Sample>) return {not_started, 0};
  return kind->push(*extractor, samples, count, stride);
}

// The result of a function of the extractor's kind, or one for an extractor that was not started.
template <class Result, class Object, class... Arguments>
Result call_kind(Result (*discmc_normal_kind::*function)(Object&, Arguments...), Object* extractor,
                 Result otherwise, Arguments... arguments) {
  const discmc_normal_kind* const kind = kind_of(extractor);
  return kind == nullptr ? otherwise : (kind->*function)(*extractor, arguments...);
}

}  // namespace

extern "C" {

uint64_t discmc_normal_extractor_minimum_bytes(const discmc_normal_kind* kind,
                                               const discmc_limits* limits) {
  return kind->bytes_for(cpp(*limits), minimum_capacities());
}
uint64_t discmc_normal_extractor_bytes_for(const discmc_normal_kind* kind,
                                           const discmc_limits* limits,
                                           const discmc_capacities* capacities) {
  return kind->bytes_for(cpp(*limits), cpp(*capacities));
}
discmc_capacities discmc_normal_extractor_default_capacities(const discmc_normal_kind* kind,
                                                             const discmc_limits* limits,
                                                             uint64_t bytes) {
  return c(kind->default_capacities(cpp(*limits), bytes));
}

void discmc_normal_extractor_set_spacing(discmc_normal_extractor* extractor,
                                         const discmc_normal_kind* kind,
                                         const int32_t spacing_nm[3]) {
  become(extractor, kind);
  kind->set_spacing(*extractor, {spacing_nm[0], spacing_nm[1], spacing_nm[2]});
}
discmc_status discmc_normal_extractor_start(discmc_normal_extractor* extractor,
                                            const discmc_normal_kind* kind,
                                            const discmc_limits* limits,
                                            const discmc_capacities* capacities, int32_t threshold,
                                            discmc_memory memory, const discmc_sink* sink) {
  become(extractor, kind);
  return kind->start(*extractor, limits, capacities, threshold, memory, sink);
}
discmc_push_result discmc_normal_extractor_push_u8(discmc_normal_extractor* extractor,
                                                   const uint8_t* samples, uint32_t count,
                                                   uint32_t stride) {
  return push_to(extractor, samples, count, stride);
}
discmc_push_result discmc_normal_extractor_push_u16(discmc_normal_extractor* extractor,
                                                    const uint16_t* samples, uint32_t count,
                                                    uint32_t stride) {
  return push_to(extractor, samples, count, stride);
}
discmc_push_result discmc_normal_extractor_push_i16(discmc_normal_extractor* extractor,
                                                    const int16_t* samples, uint32_t count,
                                                    uint32_t stride) {
  return push_to(extractor, samples, count, stride);
}
discmc_push_result discmc_normal_extractor_skip_row(discmc_normal_extractor* extractor,
                                                    uint8_t substitute) {
  return call_kind(&discmc_normal_kind::skip_row, extractor, {not_started, 0}, substitute);
}
discmc_status discmc_normal_extractor_reset(discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::reset, extractor, not_started);
}
discmc_status discmc_normal_extractor_resume(discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::resume, extractor, not_started);
}
discmc_status discmc_normal_extractor_finish(discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::finish, extractor, not_started);
}
discmc_status discmc_normal_extractor_abandon(discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::abandon, extractor, not_started);
}
discmc_status discmc_normal_extractor_save(const discmc_normal_extractor* extractor,
                                           discmc_normal_extractor_checkpoint* checkpoint) {
  return call_kind(&discmc_normal_kind::save, extractor, not_started, checkpoint);
}
discmc_status discmc_normal_extractor_restore(discmc_normal_extractor* extractor,
                                              const discmc_normal_kind* kind,
                                              const discmc_normal_extractor_checkpoint* checkpoint,
                                              discmc_memory memory, const discmc_sink* sink) {
  become(extractor, kind);
  return kind->restore(*extractor, checkpoint, memory, sink);
}
discmc_statistics discmc_normal_extractor_statistics(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::statistics, extractor, {});
}
discmc_limits discmc_normal_extractor_limits(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::limits, extractor, {});
}
discmc_capacities discmc_normal_extractor_capacities(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::capacities, extractor, {});
}
discmc_high_water discmc_normal_extractor_high_water(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::high_water, extractor, {});
}
size_t discmc_normal_extractor_bytes_used(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::bytes_used, extractor, {});
}
uint32_t discmc_normal_extractor_slices(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::slices, extractor, {});
}
uint32_t discmc_normal_extractor_rows(const discmc_normal_extractor* extractor) {
  return call_kind(&discmc_normal_kind::rows, extractor, {});
}

}  // extern "C"

}  // namespace discmc

// Outside the namespace, where they are those that discmc.h declares.
const discmc_normal_kind discmc_normals_u8 = discmc::NormalKind<uint16_t, uint8_t>::functions;
const discmc_normal_kind discmc_normals_u16 = discmc::NormalKind<uint16_t, uint16_t>::functions;
const discmc_normal_kind discmc_normals_i16 = discmc::NormalKind<uint16_t, int16_t>::functions;
const discmc_normal_kind discmc_host_normals_u8 = discmc::NormalKind<uint32_t, uint8_t>::functions;
const discmc_normal_kind discmc_host_normals_u16 =
    discmc::NormalKind<uint32_t, uint16_t>::functions;
const discmc_normal_kind discmc_host_normals_i16 = discmc::NormalKind<uint32_t, int16_t>::functions;

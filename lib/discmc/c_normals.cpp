// discmc.h in terms of the C++ library: normals, and those of a second pass. A file of its own, so
// that firmware which only scans does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/normal.hpp>
#include <discmc/sample_window.hpp>

using namespace discmc;

namespace {

LongVector cpp(const discmc_long_vector& from) {
  return {from.x, from.y, from.z};
}
Vertex cpp(const discmc_vertex& from) {
  return {from.x, from.y, from.z};
}
discmc_long_vector c(const LongVector& from) {
  return {from.x, from.y, from.z};
}
discmc_unit_normal c(const UnitNormal& from) {
  return {from.x, from.y, from.z};
}

// A window in storage of C's. What it does depends on the type of its samples, which start tells:
// so a program links that of its types alone.
struct Functions;
struct Head {
  const Functions* functions;  // null before the start
};
struct Functions {
  uint32_t sample_type;
  void (*end)(Head& window);
  bool (*covers)(const Head& window, const Vertex& vertex);
  LongVector (*downhill)(const Head& window, const Vertex& vertex);
};
template <class Sample>
struct Window : Head {
  SampleWindow<Sample> window;
};

template <class Sample>
constexpr Functions functions_of = {
    sample_type<Sample>,
    [](Head& head) { static_cast<Window<Sample>&>(head).window.end(); },
    [](const Head& head, const Vertex& vertex) {
      return static_cast<const Window<Sample>&>(head).window.covers(vertex);
    },
    [](const Head& head, const Vertex& vertex) {
      return static_cast<const Window<Sample>&>(head).window.downhill(vertex);
    },
};

Head& head(discmc_sample_window* window) {
  return *reinterpret_cast<Head*>(window);
}
const Head& head(const discmc_sample_window* window) {
  return *reinterpret_cast<const Head*>(window);
}

template <class Sample>
discmc_status start(discmc_sample_window* window, const discmc_limits* limits,
                    discmc_memory memory) {
  static_assert(fits<Window<Sample>, discmc_sample_window>, "the size in discmc.h is enough");
  auto& of_type = static_cast<Window<Sample>&>(head(window));
  const Status status = of_type.window.start(discmc::cpp(*limits), discmc::cpp(memory));
  if (status == Status::ok) of_type.functions = &functions_of<Sample>;
  return discmc::c(status);
}

template <class Sample>
discmc_status push(discmc_sample_window* window, const Sample* samples, uint32_t count,
                   uint32_t stride) {
  Head& any = head(window);
  if (any.functions == nullptr || any.functions->sample_type != sample_type<Sample>)
    return DISCMC_NOT_STARTED;
  return discmc::c(static_cast<Window<Sample>&>(any).window.push(samples, count, stride));
}

}  // namespace

discmc_axis_weights discmc_axis_weights_of(const int32_t spacing[3]) {
  const AxisWeights weights = axis_weights({spacing[0], spacing[1], spacing[2]});
  return {weights.x, weights.y, weights.z};
}
discmc_long_vector discmc_weighted(discmc_long_vector vector, discmc_axis_weights weights) {
  return c(weighted(cpp(vector), {weights.x, weights.y, weights.z}));
}
discmc_unit_normal discmc_unit_normal_along(discmc_long_vector direction) {
  return c(unit_normal(cpp(direction)));
}
discmc_octahedral_normal discmc_octahedral_normal_along(discmc_long_vector direction) {
  const OctahedralNormal normal = octahedral_normal(cpp(direction));
  return {normal.u, normal.v};
}
discmc_unit_normal discmc_unit_normal_of(discmc_octahedral_normal normal) {
  return c(unit_normal(OctahedralNormal{normal.u, normal.v}));
}
discmc_long_vector discmc_area_vector(uint8_t incidence, int64_t twice_area) {
  return c(area_vector(incidence, twice_area));
}

uint64_t discmc_sample_window_bytes_for(const discmc_limits* limits, uint32_t sample_bytes) {
  const Limits size = discmc::cpp(*limits);
  return sample_bytes == 1 ? SampleWindow<uint8_t>::bytes_for(size)
                           : SampleWindow<uint16_t>::bytes_for(size);
}
discmc_status discmc_sample_window_start_u8(discmc_sample_window* window,
                                            const discmc_limits* limits, discmc_memory memory) {
  return start<uint8_t>(window, limits, memory);
}
discmc_status discmc_sample_window_start_u16(discmc_sample_window* window,
                                             const discmc_limits* limits, discmc_memory memory) {
  return start<uint16_t>(window, limits, memory);
}
discmc_status discmc_sample_window_start_i16(discmc_sample_window* window,
                                             const discmc_limits* limits, discmc_memory memory) {
  return start<int16_t>(window, limits, memory);
}
discmc_status discmc_sample_window_push_u8(discmc_sample_window* window, const uint8_t* samples,
                                           uint32_t count, uint32_t stride) {
  return push(window, samples, count, stride);
}
discmc_status discmc_sample_window_push_u16(discmc_sample_window* window, const uint16_t* samples,
                                            uint32_t count, uint32_t stride) {
  return push(window, samples, count, stride);
}
discmc_status discmc_sample_window_push_i16(discmc_sample_window* window, const int16_t* samples,
                                            uint32_t count, uint32_t stride) {
  return push(window, samples, count, stride);
}
void discmc_sample_window_end(discmc_sample_window* window) {
  Head& any = head(window);
  if (any.functions != nullptr) any.functions->end(any);
}
uint8_t discmc_sample_window_covers(const discmc_sample_window* window, discmc_vertex vertex) {
  const Head& any = head(window);
  return any.functions != nullptr && any.functions->covers(any, cpp(vertex)) ? 1 : 0;
}
discmc_long_vector discmc_sample_window_downhill(const discmc_sample_window* window,
                                                 discmc_vertex vertex) {
  const Head& any = head(window);
  return any.functions == nullptr ? discmc_long_vector{0, 0, 0}
                                  : c(any.functions->downhill(any, cpp(vertex)));
}

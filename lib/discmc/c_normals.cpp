// discmc.h in terms of the C++ library: normals, and those of a second pass. A file of its own, so
// that firmware which only scans does not carry it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/normal.hpp>
#include <discmc/sample_window.hpp>

namespace discmc {

namespace {

LongVector cpp(const discmc_long_vector& from) {
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
struct WindowFunctions;
struct WindowHead {
  const WindowFunctions* functions;  // null before the start
};
struct WindowFunctions {
  uint32_t sample_type;
  void (*end)(WindowHead& window);
  bool (*covers)(const WindowHead& window, const Vertex& vertex);
  LongVector (*downhill)(const WindowHead& window, const Vertex& vertex);
};
template <class Sample>
struct Window : WindowHead {
  SampleWindow<Sample> window;
};

template <class Sample>
constexpr WindowFunctions window_functions = {
    sample_type<Sample>,
    [](WindowHead& head) { static_cast<Window<Sample>&>(head).window.end(); },
    [](const WindowHead& head, const Vertex& vertex) {
      return static_cast<const Window<Sample>&>(head).window.covers(vertex);
    },
    [](const WindowHead& head, const Vertex& vertex) {
      return static_cast<const Window<Sample>&>(head).window.downhill(vertex);
    },
};

WindowHead& head(discmc_sample_window* window) {
  return *reinterpret_cast<WindowHead*>(window);
}
const WindowHead& head(const discmc_sample_window* window) {
  return *reinterpret_cast<const WindowHead*>(window);
}

template <class Sample>
discmc_status start_window(discmc_sample_window* window, const discmc_limits* limits,
                           discmc_memory memory) {
  static_assert(fits<Window<Sample>, discmc_sample_window>, "the size in discmc.h is enough");
  auto& of_type = static_cast<Window<Sample>&>(head(window));
  const Status status = of_type.window.start(discmc::cpp(*limits), discmc::cpp(memory));
  if (status == Status::ok) of_type.functions = &window_functions<Sample>;
  return discmc::c(status);
}

template <class Sample>
discmc_status push_to(discmc_sample_window* window, const Sample* samples, uint32_t count,
                      uint32_t stride) {
  WindowHead& any = head(window);
  if (any.functions == nullptr || any.functions->sample_type != sample_type<Sample>)
    return DISCMC_NOT_STARTED;
  return discmc::c(static_cast<Window<Sample>&>(any).window.push(samples, count, stride));
}

}  // namespace

extern "C" {

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
  const Limits size = cpp(*limits);
  return sample_bytes == 1 ? SampleWindow<uint8_t>::bytes_for(size)
                           : SampleWindow<uint16_t>::bytes_for(size);
}
discmc_status discmc_sample_window_start_u8(discmc_sample_window* window,
                                            const discmc_limits* limits, discmc_memory memory) {
  return start_window<uint8_t>(window, limits, memory);
}
discmc_status discmc_sample_window_start_u16(discmc_sample_window* window,
                                             const discmc_limits* limits, discmc_memory memory) {
  return start_window<uint16_t>(window, limits, memory);
}
discmc_status discmc_sample_window_start_i16(discmc_sample_window* window,
                                             const discmc_limits* limits, discmc_memory memory) {
  return start_window<int16_t>(window, limits, memory);
}
discmc_status discmc_sample_window_push_u8(discmc_sample_window* window, const uint8_t* samples,
                                           uint32_t count, uint32_t stride) {
  return push_to(window, samples, count, stride);
}
discmc_status discmc_sample_window_push_u16(discmc_sample_window* window, const uint16_t* samples,
                                            uint32_t count, uint32_t stride) {
  return push_to(window, samples, count, stride);
}
discmc_status discmc_sample_window_push_i16(discmc_sample_window* window, const int16_t* samples,
                                            uint32_t count, uint32_t stride) {
  return push_to(window, samples, count, stride);
}
void discmc_sample_window_end(discmc_sample_window* window) {
  WindowHead& any = head(window);
  if (any.functions != nullptr) any.functions->end(any);
}
uint8_t discmc_sample_window_covers(const discmc_sample_window* window, discmc_vertex vertex) {
  const WindowHead& any = head(window);
  return any.functions != nullptr && any.functions->covers(any, discmc::cpp(vertex)) ? 1 : 0;
}
discmc_long_vector discmc_sample_window_downhill(const discmc_sample_window* window,
                                                 discmc_vertex vertex) {
  const WindowHead& any = head(window);
  return any.functions == nullptr ? discmc_long_vector{0, 0, 0}
                                  : c(any.functions->downhill(any, discmc::cpp(vertex)));
}

}  // extern "C"

}  // namespace discmc

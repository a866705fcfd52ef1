// discmc.h in terms of the C++ library: a link for several encoders. A file of its own, so that
// scanners with one do not link it.
#include <discmc/discmc.h>

#include <discmc/c_sink.hpp>
#include <discmc/c_values.hpp>
#include <discmc/shared_output.hpp>

namespace discmc {

namespace {

static_assert(fits<SharedOutput, discmc_shared_output>, "the size in discmc.h is enough");

SharedOutput& cpp(discmc_shared_output* shared) {
  return *reinterpret_cast<SharedOutput*>(shared);
}

}  // namespace

extern "C" {

void discmc_shared_output_start(discmc_shared_output* shared, discmc_byte_output output) {
  cpp(shared).start(cpp(output));
}
discmc_byte_output discmc_shared_output_output(discmc_shared_output* shared) {
  return c(cpp(shared).output());
}
uint8_t discmc_shared_output_flush(discmc_shared_output* shared) {
  return cpp(shared).flush() ? 1 : 0;
}

}  // extern "C"

}  // namespace discmc

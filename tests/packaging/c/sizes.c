/* The sizes of sizes.h are constants in C, and those that the functions give. */
#include <discmc/discmc.h>

/* An array's size has to be a constant, and so have the members of a static object. */
uint8_t minimum[DISCMC_MINIMUM_BYTES(64, 48)];
uint8_t some_bytes[DISCMC_BYTES_FOR(64, 48, 101)];
static const discmc_capacities some = {101, 7};
static const discmc_capacities least = DISCMC_MINIMUM_CAPACITIES;
static const discmc_capacities split = DISCMC_DEFAULT_CAPACITIES(64, 48, 20000);

static int are_equal(discmc_capacities a, discmc_capacities b) {
  return a.records == b.records && a.holes == b.holes;
}

int main(void) {
  const discmc_limits limits = {.width = 64, .height = 48, .border = DISCMC_CLOSED};
  if (sizeof minimum != discmc_minimum_bytes(&limits)) return 1;
  if (sizeof some_bytes != discmc_bytes_for(&limits, &some)) return 2;
  if (!are_equal(least, discmc_minimum_capacities())) return 3;
  if (!are_equal(split, discmc_default_capacities(&limits, 20000))) return 4;
  return 0;
}

/* The sizes of sizes.h are constants in C, and those that the functions give. */
#include <discmc/discmc.h>

/* An array's size has to be a constant, and so have the members of a static object. */
uint8_t minimum[DISCMC_MINIMUM_BYTES(64, 48)];
uint8_t some_bytes[DISCMC_BYTES_FOR(64, 48, 101)];
static const discmc_capacities some = {101, 7};
static const discmc_capacities least = DISCMC_MINIMUM_CAPACITIES;
static const discmc_capacities split = DISCMC_DEFAULT_CAPACITIES(64, 48, 20000);

uint8_t join_some[DISCMC_JOINER_BYTES_FOR(101, 151)];
uint8_t join_least[DISCMC_JOINER_MINIMUM_BYTES];
static const discmc_join_capacities join_fragments = {101, 151};
static const discmc_join_capacities join_split = DISCMC_JOINER_DEFAULT_CAPACITIES(20000);

uint8_t slice_encoder[DISCMC_SLICE_ENCODER_BYTES_FOR(64, 48, 16, 2)];
uint8_t slice_decoder[DISCMC_SLICE_DECODER_BYTES_FOR(64, 48, 2)];
uint8_t surface_decoder[DISCMC_MINIMUM_SURFACE_BYTES(64, 48, 2)];

static int are_equal(discmc_capacities a, discmc_capacities b) {
  return a.records == b.records && a.holes == b.holes;
}

int main(void) {
  const discmc_limits limits = {.width = 64, .height = 48, .border = DISCMC_CLOSED};
  if (sizeof minimum != discmc_minimum_bytes(&limits)) return 1;
  if (sizeof some_bytes != discmc_bytes_for(&limits, &some)) return 2;
  if (!are_equal(least, discmc_minimum_capacities())) return 3;
  if (!are_equal(split, discmc_default_capacities(&limits, 20000))) return 4;
  if (sizeof join_some != discmc_joiner_bytes_for(&join_fragments)) return 5;
  if (sizeof join_least != discmc_joiner_minimum_bytes()) return 6;
  if (join_split.fragments != discmc_joiner_default_capacities(20000).fragments) return 7;
  if (join_split.runs != discmc_joiner_default_capacities(20000).runs) return 8;
  if (sizeof slice_encoder != discmc_slice_encoder_bytes_for(&limits, 16, 2)) return 9;
  if (sizeof slice_decoder != discmc_slice_decoder_bytes_for(&limits, 2)) return 10;
  if (sizeof surface_decoder != discmc_minimum_surface_bytes(&limits, 2)) return 11;
  return 0;
}

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

uint8_t normals[DISCMC_NORMAL_EXTRACTOR_MINIMUM_BYTES(64, 48, sizeof(uint8_t))];
uint8_t some_normals[DISCMC_NORMAL_EXTRACTOR_BYTES_FOR(64, 48, 2, 101)];
static const discmc_capacities normal_split =
    DISCMC_NORMAL_EXTRACTOR_DEFAULT_CAPACITIES(64, 48, 1, 40000);
uint8_t window[DISCMC_SAMPLE_WINDOW_BYTES_FOR(64, 48, sizeof(int16_t))];

uint8_t learning[DISCMC_LEARNING_EXTRACTOR_MINIMUM_BYTES(64, 48)];
uint8_t some_learning[DISCMC_LEARNING_EXTRACTOR_BYTES_FOR(64, 48, 101)];
static const discmc_capacities learning_split =
    DISCMC_LEARNING_EXTRACTOR_DEFAULT_CAPACITIES(64, 48, 3000000);

uint8_t row_ring[DISCMC_ROW_RING_BYTES_FOR(37, 5)];
uint8_t majority_filter[DISCMC_MAJORITY_FILTER_BYTES_FOR(64, 48)];
uint8_t block_means[DISCMC_BLOCK_MEANS_BYTES_FOR(64, 48, 3, 2)];

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
  if (sizeof normals != discmc_normal_extractor_minimum_bytes(&discmc_normals_u8, &limits))
    return 12;
  if (sizeof some_normals != discmc_normal_extractor_bytes_for(&discmc_normals_i16, &limits, &some))
    return 13;
  if (!are_equal(normal_split,
                 discmc_normal_extractor_default_capacities(&discmc_normals_u8, &limits, 40000)))
    return 14;
  if (sizeof window != discmc_sample_window_bytes_for(&limits, 2)) return 15;
  if (sizeof learning != discmc_learning_extractor_minimum_bytes(&limits)) return 16;
  if (sizeof some_learning != discmc_learning_extractor_bytes_for(&limits, &some)) return 17;
  if (!are_equal(learning_split, discmc_learning_extractor_default_capacities(&limits, 3000000)))
    return 18;
  if (sizeof row_ring != discmc_row_ring_bytes_for(37, 5)) return 19;
  if (sizeof majority_filter != discmc_majority_filter_bytes_for(&limits)) return 20;
  if (sizeof block_means != discmc_block_means_bytes_for(&limits, 3, 2)) return 21;
  return 0;
}

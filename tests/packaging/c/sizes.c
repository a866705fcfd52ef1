/* The sizes of sizes.h are constants in C, and those that the functions give. */
#include <discmc/discmc.h>

/* An array's size has to be a constant, and so have the members of a static object. */
static uint8_t minimum16[DISCMC_MINIMUM_BYTES16(64, 48, DISCMC_CLOSED)];
static uint8_t minimum32[DISCMC_MINIMUM_BYTES32(31, 7, DISCMC_OPEN)];
static uint8_t worst16[DISCMC_WORST_CASE_BYTES16(9, 5, DISCMC_OPEN)];
static uint8_t worst32[DISCMC_WORST_CASE_BYTES32(8, 8, DISCMC_CLOSED)];
static uint8_t some16[DISCMC_BYTES_FOR16(64, 48, DISCMC_CLOSED, 101, 151, 21, 61, 129)];
static uint8_t some32[DISCMC_BYTES_FOR32(64, 48, DISCMC_CLOSED, 101, 151, 21, 61, 129)];
static const discmc_capacities some = {101, 151, 21, 61, 129};
static const discmc_capacities least = DISCMC_MINIMUM_CAPACITIES;
static const discmc_capacities worst = DISCMC_WORST_CASE_CAPACITIES(9, 5, DISCMC_OPEN);
static const discmc_capacities split16 = DISCMC_DEFAULT_CAPACITIES16(64, 48, DISCMC_CLOSED, 20000);
static const discmc_capacities split32 = DISCMC_DEFAULT_CAPACITIES32(64, 48, DISCMC_CLOSED, 20000);

static uint8_t join_some[DISCMC_JOINER_BYTES_FOR(101, 151)];
static uint8_t join_least[DISCMC_JOINER_MINIMUM_BYTES];
static const discmc_join_capacities join_fragments = {101, 151};
static const discmc_join_capacities join_split = DISCMC_JOINER_DEFAULT_CAPACITIES(20000);

static int are_equal(discmc_capacities a, discmc_capacities b) {
  return a.edges == b.edges && a.runs == b.runs && a.rings == b.rings && a.regions == b.regions &&
         a.slots == b.slots;
}

int main(void) {
  const discmc_limits slice = {64, 48, DISCMC_CLOSED};
  const discmc_limits narrow = {31, 7, DISCMC_OPEN};
  const discmc_limits square = {8, 8, DISCMC_CLOSED};
  const discmc_limits small = {9, 5, DISCMC_OPEN};
  if (sizeof minimum16 != discmc_minimum_bytes16(&slice)) return 1;
  if (sizeof minimum32 != discmc_minimum_bytes32(&narrow)) return 2;
  if (sizeof worst16 != discmc_worst_case_bytes16(&small)) return 3;
  if (sizeof worst32 != discmc_worst_case_bytes32(&square)) return 4;
  if (sizeof some16 != discmc_bytes_for16(&slice, &some)) return 5;
  if (sizeof some32 != discmc_bytes_for32(&slice, &some)) return 6;
  if (!are_equal(least, discmc_minimum_capacities())) return 7;
  if (!are_equal(worst, discmc_worst_case_capacities(&small))) return 8;
  if (!are_equal(split16, discmc_default_capacities16(&slice, 20000))) return 9;
  if (!are_equal(split32, discmc_default_capacities32(&slice, 20000))) return 10;
  if (sizeof join_some != discmc_joiner_bytes_for(&join_fragments)) return 11;
  if (sizeof join_least != discmc_joiner_minimum_bytes()) return 12;
  if (join_split.fragments != discmc_joiner_default_capacities(20000).fragments) return 13;
  if (join_split.runs != discmc_joiner_default_capacities(20000).runs) return 14;
  return 0;
}

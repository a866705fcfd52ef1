// discmc.h is C99 by itself, and its constants and sizes equal those of C++.
#include <discmc/discmc.h>

#include <discmc/chain.hpp>
#include <discmc/normal.hpp>
#include <discmc/status.hpp>
#include <regex>

#include "project_text.hpp"
#include "test.hpp"

using namespace discmc;
using discmc::test::text_of;

namespace {

void check_size(uint64_t constant, uint64_t needed) {
  CHECK(constant >= needed);
  CHECK(constant <= needed + needed / 8 + 64);
}

}  // namespace

TEST_CASE("every function of the C headers has a comment or shares the preceding comment") {
  const std::string header = text_of("lib/discmc/discmc.h") + text_of("lib/discmc/front.h");
  const std::regex bare("\n\n(?!/\\*|typedef|#|enum|extern)[^\n]*\\bdiscmc_[a-z0-9_]+\\(");
  CHECK(!std::regex_search(header, bare));
}

TEST_CASE("every status in C has a unique text") {
  std::set<std::string> texts;
  for (int status = DISCMC_OK; status <= DISCMC_NO_KIND; ++status)
    texts.insert(discmc_status_string(static_cast<discmc_status>(status)));
  CHECK(texts.size() == DISCMC_NO_KIND + 1);
  CHECK(texts.count(to_string(Status::device_error)) == 1);
}

TEST_CASE("the constants in sizes.h are at least, and close to, the true sizes") {
  const discmc_extractor_kind* const plain[] = {&discmc_plain_bits, &discmc_plain_u8,
                                                &discmc_plain_u16, &discmc_plain_i16};
  for (const uint32_t width : {1U, 29U, 30U, 31U, 64U, 256U, 32766U})
    for (const uint32_t height : {1U, 2U, 31U, 32U, 200U, 32766U}) {
      const discmc_limits limits = {width, height, DISCMC_CLOSED};
      for (const uint32_t slots : {4U, 5U, 100U, 32759U}) {
        discmc_extractor_config config{};
        config.limits = limits;
        config.slots = slots;
        for (const discmc_extractor_kind* kind : plain) {
          config.kind = kind;
          check_size(DISCMC_EXTRACTOR_BYTES(width, height, slots), discmc_extractor_bytes(&config));
        }
        config.kind = &discmc_normals_u8;
        check_size(DISCMC_NORMAL_EXTRACTOR_BYTES(width, height, sizeof(uint8_t), slots),
                   discmc_extractor_bytes(&config));
        for (const discmc_extractor_kind* kind : {&discmc_normals_u16, &discmc_normals_i16}) {
          config.kind = kind;
          check_size(DISCMC_NORMAL_EXTRACTOR_BYTES(width, height, sizeof(int16_t), slots),
                     discmc_extractor_bytes(&config));
        }
      }
      for (uint8_t surfaces = 1; surfaces <= DISCMC_MAX_SURFACES; ++surfaces) {
        discmc_slice_encoder_config config{};
        config.limits = limits;
        config.surface_count = surfaces;
        config.kind = &discmc_slices_u8;
        check_size(DISCMC_SLICE_ENCODER_BYTES(width, height, surfaces),
                   discmc_slice_encoder_bytes(&config));
        check_size(DISCMC_RECEIVER_BYTES(width, height, surfaces),
                   discmc_receiver_bytes(&limits, surfaces, 0));
        for (const uint8_t levels : std::initializer_list<uint8_t>{2, 4}) {
          config.levels = levels;
          config.kind = &discmc_fraction_slices_u8;
          check_size(DISCMC_FRACTION_SLICE_ENCODER_BYTES(width, height, surfaces, levels, 1),
                     discmc_slice_encoder_bytes(&config));
          config.kind = &discmc_fraction_slices_i16;
          check_size(DISCMC_FRACTION_SLICE_ENCODER_BYTES(width, height, surfaces, levels, 2),
                     discmc_slice_encoder_bytes(&config));
          check_size(DISCMC_FRACTION_RECEIVER_BYTES(width, height, surfaces, levels),
                     discmc_receiver_bytes(&limits, surfaces, levels));
        }
      }
    }
}

TEST_CASE(
    "a config without slots needs the minimum memory, and an invalid config needs zero bytes") {
  discmc_extractor_config config{};
  config.kind = &discmc_plain_u8;
  config.limits = {10, 10, DISCMC_CLOSED};
  const uint64_t minimum = discmc_extractor_bytes(&config);
  config.slots = DISCMC_MIN_SLOTS;
  CHECK(discmc_extractor_bytes(&config) == minimum);
  config.kind = nullptr;
  CHECK(discmc_extractor_bytes(&config) == 0);
  config.kind = &discmc_plain_u8;
  config.limits.width = 0;
  CHECK(discmc_extractor_bytes(&config) == 0);
  discmc_slice_encoder_config slices{};
  slices.limits = {10, 10, DISCMC_CLOSED};
  CHECK(discmc_slice_encoder_bytes(&slices) == 0);
  slices.kind = &discmc_slices_u8;
  const uint64_t one = discmc_slice_encoder_bytes(&slices);
  CHECK(one > 0);
  slices.surface_count = 5;
  CHECK(discmc_slice_encoder_bytes(&slices) == 0);
  slices.surface_count = 1;
  const uint64_t many = discmc_slice_encoder_bytes(&slices);
  CHECK(many == one);
  slices.key_slice_interval = 1;
  CHECK(discmc_slice_encoder_bytes(&slices) < many);
  slices.limits.width = 0;
  CHECK(discmc_slice_encoder_bytes(&slices) == 0);
}

TEST_CASE("a sink in C receives the corners and normals of polygons") {
  for (Incidence incidence = 0; incidence < incidence_codes; ++incidence) {
    const discmc_vertex in_c = discmc_incidence_normal(incidence);
    CHECK(Vertex{in_c.x, in_c.y, in_c.z} == incidence_normal(incidence));
    for (Direction direction = 0; direction < direction_count(incidence); ++direction) {
      const Run run = Run::straight(direction, 1000 + direction);
      const discmc_vertex vector = discmc_run_vector(incidence, run.code());
      CHECK(Vertex{vector.x, vector.y, vector.z} == displacement(incidence, &run, 1));
    }
  }
  for (int u = 0; u < 256; ++u) {
    const uint8_t bytes[2] = {static_cast<uint8_t>(u), static_cast<uint8_t>(255 - u)};
    const discmc_vertex in_c = discmc_unit_normal(bytes);
    const UnitNormal in_cpp = unit_normal(OctahedralNormal{bytes[0], bytes[1]});
    CHECK((in_c.x == in_cpp.x && in_c.y == in_cpp.y && in_c.z == in_cpp.z));
  }
}

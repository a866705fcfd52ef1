// Crossings from a stream of slices with fractions.
#include "streams/sent_fractions.hpp"

#include <discmc/fraction_slice_encoder.hpp>

#include "received_fractions.hpp"
#include "sampled_field.hpp"
#include "smoothing/relaxed_crossings.hpp"
#include "test.hpp"

namespace {

using namespace sampled_field;
using Bytes = std::vector<std::uint8_t>;

template <class Sample>
Bytes encoded(const Field& field, std::uint8_t levels) {
  Bytes bytes;
  discmc::SliceEncoderConfig config;
  config.limits = {field.size.width, field.size.height};
  config.thresholds[0] = static_cast<std::int32_t>(threshold);
  config.levels = levels;
  std::vector<std::uint8_t> memory(discmc::FractionSliceEncoder<Sample>::minimum_bytes(config));
  discmc::FractionSliceEncoder<Sample> encoder;
  REQUIRE(encoder.start(config, {memory.data(), memory.size()}, output_to(bytes)) ==
          discmc::Status::ok);
  const std::vector<Sample> samples(field.samples.begin(), field.samples.end());
  REQUIRE(encoder.push(samples.data(), static_cast<std::uint32_t>(samples.size())).status ==
          discmc::Status::ok);
  REQUIRE(encoder.finish() == discmc::Status::ok);
  return bytes;
}

// Along z, the encoder stores only the octave of the distance of the sample before.
constexpr double rounding_along_z = 0.11;

template <class Sample>
void check_near_samples(const Field& field, std::uint8_t levels) {
  const Extracted of = extracted(field);
  const ReceivedFractions received(encoded<Sample>(field, levels));
  CHECK(received.is_complete());
  REQUIRE(received.surface().polygons.size() == of.surface.polygons.size());
  const Crossings crossings = received.crossings();
  const Crossings& exact = of.finder.crossings();
  std::size_t sent = 0;
  crossings.for_each([&](Crossings::Id id, const Vertex& middle) {
    const auto same = exact.find(middle);
    REQUIRE(same);
    const double apart =
        std::abs(static_cast<double>(crossings.at(id)) - static_cast<double>(exact.at(*same)));
    const double rounding = id.axis == 2 ? rounding_along_z : 1e-6;
    REQUIRE(apart / 2 <= 0.5 / levels + rounding);
    if (crossings.intervals(id) == levels) ++sent;
  });
  CHECK(sent == exact.count(0) + exact.count(1) + exact.count(2));
}

}  // namespace

TEST_CASE("crossings in a stream with levels are within half a level of the samples' crossings") {
  for (const std::uint8_t levels : {std::uint8_t{2}, std::uint8_t{4}})
    for (const Field& field : {ball(15, 5.2), noise({11, 9, 8}, 6), noise({33, 3, 4}, 7)}) {
      check_near_samples<std::uint8_t>(field, levels);
      check_near_samples<std::uint16_t>(field, levels);
      check_near_samples<std::int16_t>(field, levels);
    }
}

TEST_CASE(
    "relaxed crossings of a stream with levels stay in their level's interval and are more "
    "accurate") {
  const Field field = ball(24, 9.3);
  const Extracted of = extracted(field);
  const ReceivedFractions received(encoded<std::uint8_t>(field, 2));
  CHECK(received.is_complete());
  const Crossings sent = received.crossings();
  Crossings relaxed = received.crossings();
  relax(relaxed, received.surface(), {});
  const Crossings& exact = of.finder.crossings();
  double of_sent = 0, of_relaxed = 0;
  sent.for_each([&](Crossings::Id id, const Vertex& middle) {
    const auto at = [id](const Crossings& crossings) {
      return static_cast<double>(crossings.at(id));
    };
    REQUIRE(std::abs(at(relaxed) - at(sent)) <= 0.5 + 1e-6);
    const double true_at = static_cast<double>(exact.at(*exact.find(middle)));
    of_sent += std::abs(at(sent) - true_at);
    of_relaxed += std::abs(at(relaxed) - true_at);
  });
  CHECK(of_relaxed < 0.9 * of_sent);
}

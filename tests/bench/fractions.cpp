// What fractions add to a stream of slices, and what they gain, for a volume of 8 or 16 bits:
//
//   bench_fractions FILE THRESHOLD
//
// Prints a row of a table per kind of stream: levels, interval of key slices, bytes, mean distance.
// The distance is that along crossing edges to the interpolated surface. Units: edges.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <vector>

#include <discmc/discmc.hpp>

#include "volumes/volume.hpp"

using namespace discmc;

namespace {

void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

template <class Sample>
struct Volume {
  uint32_t width, height, depth;
  std::vector<Sample> at;
};

// Receives a stream, and compares it with the samples.
template <class Sample>
class Comparison {
 public:
  Comparison(const Volume<Sample>& volume, int32_t threshold)
      : volume_(volume), isovalue_(threshold - 0.5) {}
  SinkResult accept(const RowEvent& event) {
    if (event.kind == RowEvent::Kind::fractions)
      for (uint32_t x = 0; x < volume_.width; ++x) compare(event, x);
    return SinkResult::accepted;
  }
  double mean_fraction() const { return fractions_ / edges_; }
  double mean_midpoint() const { return midpoints_ / edges_; }

 private:
  void compare(const RowEvent& event, uint32_t x) {
    const size_t row = size_t{volume_.width}, slice = row * volume_.height;
    const size_t step[] = {1, row, slice};
    const size_t at = event.slice * slice + event.row * row + x;
    for (uint32_t axis = 0; axis < 3; ++axis) {
      const uint32_t eighths = fraction_of(event.fractions[x], axis);
      if (eighths == 0) continue;
      const double lower = volume_.at[at - step[axis]], upper = volume_.at[at];
      const double place = (isovalue_ - lower) / (upper - lower);
      fractions_ += std::abs(place - eighths / 8.0);
      midpoints_ += std::abs(place - 0.5);
      ++edges_;
    }
  }

  const Volume<Sample>& volume_;
  double isovalue_;
  double fractions_ = 0, midpoints_ = 0, edges_ = 0;
};

template <class AnyEncoder, class Sample>
std::vector<uint8_t> encode(const Volume<Sample>& volume, const SliceEncoderConfig& config) {
  std::vector<uint8_t> stream;
  const ByteOutput output{&stream, [](void* context, const uint8_t* bytes, size_t count) {
                            auto& to = *static_cast<std::vector<uint8_t>*>(context);
                            to.insert(to.end(), bytes, bytes + count);
                            return count;
                          }};
  std::vector<uint8_t> memory(AnyEncoder::minimum_bytes(config));
  AnyEncoder encoder;
  require(encoder.start(config, memory_of(memory), output));
  for (uint32_t row = 0; row < volume.height * volume.depth; ++row)
    require(encoder.push(&volume.at[size_t{row} * volume.width], volume.width).status);
  require(encoder.finish());
  return stream;
}

template <class Sample>
void print_rows(command::VolumeReader& reader, int32_t threshold) {
  const auto [width, height, depth] = reader.info().dims;
  Volume<Sample> volume{width, height, depth, std::vector<Sample>(size_t{width} * height * depth)};
  for (uint32_t z = 0; z < depth; ++z) reader.read_slice(&volume.at[size_t{z} * width * height]);
  std::puts("| levels | key slices | bytes | mean distance |\n|--:|--:|--:|--:|");
  for (const uint8_t levels : std::initializer_list<uint8_t>{0, 2, 4})
    for (const uint32_t interval : {0U, 16U}) {
      SliceEncoderConfig config{{width, height}, {threshold}, interval};
      config.levels = levels;
      // Without fractions, the distance of midpoints is that of the stream with them.
      SliceEncoderConfig compared = config;
      if (levels == 0) compared.levels = 2;
      const std::vector<uint8_t> with = encode<FractionSliceEncoder<Sample>>(volume, compared);
      Comparison<Sample> comparison(volume, threshold);
      std::vector<uint8_t> memory(SliceDecoder::minimum_bytes(config.limits, 1, compared.levels));
      SliceDecoder decoder;
      require(decoder.start(memory_of(memory), make_row_sink(comparison)));
      require(decoder.push(with.data(), with.size()).status);
      require(decoder.finish());
      std::printf("| %u | %s | %zu | %.3f |\n", levels, interval == 0 ? "first" : "every 16th",
                  levels == 0 ? encode<SliceEncoder>(volume, config).size() : with.size(),
                  levels == 0 ? comparison.mean_midpoint() : comparison.mean_fraction());
    }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("usage: bench_fractions FILE THRESHOLD\n", stderr);
    return 2;
  }
  const auto reader = command::open_volume(arguments[1]);
  const int32_t threshold = std::atoi(arguments[2]);
  switch (reader->info().type) {
    case command::SampleType::u8:
      print_rows<uint8_t>(*reader, threshold);
      break;
    case command::SampleType::u16:
      print_rows<uint16_t>(*reader, threshold);
      break;
    case command::SampleType::i16:
      print_rows<int16_t>(*reader, threshold);
      break;
    default:
      std::fputs("bench_fractions: samples must have 8 or 16 bits\n", stderr);
      return 1;
  }
}

// Prints the probabilities of region_model.cpp, trained on the streams named on the command line:
//   train_region_model STREAM.dmc...
// Every stream counts the same, however long, so that no single scan sets the tone. Take streams of
// scans with memory to spare, which tell of regions, and of scans in little memory, which tell of
// loose fragments too.
#include <discmc/decoder.hpp>
#include <discmc/stream/record_encoding.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

using Counts = std::array<std::array<double, 2>, discmc::context::count>;

struct CountingCoder {
  Counts* counts;
  bool code_bit(uint32_t context, bool bit) {
    if (context != discmc::context::even) ++(*counts)[context][bit ? 1 : 0];
    return bit;
  }
};

// Tells every record to a counting model, which starts anew about as often as packets do.
class Trainer {
 public:
  discmc::SinkResult take(const discmc::Event& event) {
    using Kind = discmc::Event::Kind;
    switch (event.kind) {
      case Kind::region:
        record_.begin(event.incidence);
        break;
      case Kind::fragment:
        record_.begin(event.incidence);
        record_.begin_fragment(event.incoming_direction, event.start);
        break;
      case Kind::ring:
        make_room(discmc::Record::ring_words);
        record_.add_ring(event.start);
        break;
      case Kind::run:
        make_room(1);
        record_.add_run(event.run);
        break;
      case Kind::region_end:
      case Kind::fragment_end:
        end_record();
        break;
      case Kind::layer:
        model_.record_kind(discmc::RecordKind::layer);
        model_.layer(event.slice);
        break;
      default:
        break;
    }
    return discmc::SinkResult::accepted;
  }
  const Counts& counts() const { return counts_; }

 private:
  // What does not fit a record is told in parts.
  void make_room(uint32_t words) {
    if (record_.has_room(words)) return;
    encode_part(false);
    record_.count = 0;
    record_.continues = true;
  }
  void end_record() {
    if (record_.is_fragment ? !encode_fragment(model_, record_) : !encode_whole_region())
      encode_part(true);
    if (++records_ % records_a_packet != 0) return;
    model_.record_kind(discmc::RecordKind::end);
    model_ = discmc::RegionModel<CountingCoder>(CountingCoder{&counts_});
  }
  // What a region has told that then turned out not to be compact is forgotten.
  bool encode_whole_region() {
    const Counts counts = counts_;
    const discmc::RegionModel<CountingCoder> model = model_;
    if (encode_region(model_, record_)) return true;
    counts_ = counts;
    model_ = model;
    return false;
  }
  void encode_part(bool is_last) {
    model_.record_kind(discmc::RecordKind::part);
    model_.part(record_);
    for (uint32_t i = 0; i < record_.count;) i += encode_item(model_, record_, i);
    model_.item_kind(discmc::Item::end);
    model_.end_part(is_last);
  }

  static constexpr int records_a_packet = 60;
  Counts counts_{};
  discmc::RegionModel<CountingCoder> model_{CountingCoder{&counts_}};
  discmc::Record record_;
  int records_ = 0;
};

Counts counts_of(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
  Trainer trainer;
  discmc::Decoder decoder;
  const auto status = decoder.start(discmc::make_sink(trainer));
  const auto decoded = decoder.push(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
  if (status != discmc::Status::ok || decoded.status != discmc::Status::ok ||
      !decoder.report().is_complete())
    std::fprintf(stderr, "%s: no complete stream\n", path);
  return trainer.counts();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_region_model STREAM.dmc...\n");
    return 2;
  }
  std::vector<double> ones(discmc::context::count, 0.5), all(discmc::context::count, 1.0);
  for (int i = 1; i < argc; ++i) {
    const Counts counts = counts_of(argv[i]);
    double total = 0;
    for (const auto& count : counts) total += count[0] + count[1];
    for (size_t c = 0; c < counts.size(); ++c) {
      constexpr double decisions = 100000;
      ones[c] += counts[c][1] * decisions / total;
      all[c] += (counts[c][0] + counts[c][1]) * decisions / total;
    }
  }
  for (size_t c = 0; c < ones.size(); ++c) {
    const long p = std::clamp(std::lround(256 * ones[c] / all[c]), 1L, 255L);
    std::printf("%ld,%s", p, c % 20 == 19 ? "\n" : " ");
  }
  std::printf("\n");
}

// Prints the probabilities of slice_model.cpp, trained on the streams of slices named on the
// command line:
//   train_slice_model STREAM.dmc...
// Every stream has equal weight for any length, so that no single scan dominates.
#include <discmc/slice_decoder.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

using discmc::RowEvent;
namespace slices = discmc::detail::slices;

using Counts = std::array<std::array<double, 2>, slices::context::count>;

// A model that counts. Its probabilities represent their contexts.
struct CountingCoder {
  discmc::LearntProbability* first;
  Counts* counts;
  bool code_bit(discmc::LearntProbability& probability, bool bit) {
    ++(*counts)[static_cast<size_t>(&probability - first)][bit ? 1 : 0];
    return bit;
  }
  uint32_t raw_bits(uint32_t, uint32_t value) { return value; }
};

// Encodes rows in order, as rows of one kind of slice.
class Trainer {
 public:
  Trainer(const discmc::Limits& limits, slices::SliceKind kind)
      : limits_(limits), kind_(kind), memory_(discmc::SliceDecoder::minimum_bytes(limits)) {
    discmc::Arena arena({memory_.data(), memory_.size()});
    rows_.start(arena, limits, slices::rows_kept(limits.height, false));
    rows_.clear();
    model_.start(arena, false);
  }

  void count_row(const uint8_t* bits) {
    rows_.append_bits(bits);
    if (kind_ == slices::SliceKind::key || rows_.slices() > 0) count();
    rows_.next_row();
    if (rows_.rows() == limits_.height) rows_.next_slice();
  }
  const Counts& counts() const { return counts_; }

 private:
  void count() {
    CountingCoder coder{&model_[0], &counts_};
    slices::RowCode row;
    row.begin(rows_.arriving(), slices::rows_before(rows_, limits_.height, kind_), limits_.width);
    while (!row.is_done()) row.step(coder, model_);
  }

  discmc::Limits limits_;
  slices::SliceKind kind_;
  std::vector<uint8_t> memory_;
  discmc::detail::trace::BitRows rows_;
  slices::SliceModel model_;
  Counts counts_{};
};

struct RowCollector {
  std::vector<std::vector<uint8_t>> rows;
  size_t row_bytes = 0;
  discmc::SinkResult accept(const RowEvent& event) {
    if (event.kind == RowEvent::Kind::row) rows.emplace_back(event.bits, event.bits + row_bytes);
    return discmc::SinkResult::accepted;
  }
};

bool read_stream(const char* path, RowCollector& collector, discmc::Limits& limits) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  discmc::SliceDecoder decoder;
  if (decoder.start({}, discmc::make_row_sink(collector)) != discmc::Status::ok) return false;
  const size_t header_bytes = decoder.push(bytes.data(), bytes.size()).bytes;
  limits = {decoder.header().width, decoder.header().height};
  if (!limits.is_valid()) return false;
  std::vector<uint8_t> memory(discmc::SliceDecoder::minimum_bytes(limits));
  collector.row_bytes = (limits.width + 7) / 8;
  return decoder.set_memory({memory.data(), memory.size()}) == discmc::Status::ok &&
         decoder.push(bytes.data() + header_bytes, bytes.size() - header_bytes).status ==
             discmc::Status::ok &&
         decoder.report().is_complete();
}

void print(const char* name, const Counts& shares) {
  std::printf("    {  // %s\n", name);
  for (size_t context = slices::context::run; context < shares.size(); ++context) {
    const auto& share = shares[context];
    const double one = (share[1] + 1) / (share[0] + share[1] + 2);
    std::printf("%d, ", std::clamp(static_cast<int>(std::floor(256 * one)), 0, 255));
  }
  std::printf("},\n");
}

}  // namespace

int main(int argument_count, char** arguments) {
  if (argument_count < 2) {
    std::fprintf(stderr, "usage: train_slice_model STREAM.dmc...\n");
    return 2;
  }
  for (const auto kind : {slices::SliceKind::key, slices::SliceKind::follows}) {
    Counts shares{};
    for (int i = 1; i < argument_count; ++i) {
      RowCollector collector;
      discmc::Limits limits{};
      if (!read_stream(arguments[i], collector, limits)) {
        std::fprintf(stderr, "%s: no whole stream of slices\n", arguments[i]);
        return 1;
      }
      Trainer trainer(limits, kind);
      for (const auto& row : collector.rows) trainer.count_row(row.data());
      double all = 0;
      for (const auto& count : trainer.counts()) all += count[0] + count[1];
      constexpr double decisions = 20000;
      for (size_t context = 0; context < shares.size(); ++context)
        for (size_t bit = 0; bit < 2; ++bit)
          shares[context][bit] += trainer.counts()[context][bit] * decisions / all;
    }
    print(kind == slices::SliceKind::key ? "of key slices" : "of slices that follow others",
          shares);
  }
  return 0;
}

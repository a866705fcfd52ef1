// Prints the frequencies of frequencies.cpp, trained on the streams named on the command line:
//   train_record_model STREAM.dmc...
// Every stream has equal weight for any length, so that no single scan dominates. Use streams of
// scans in ample memory, with whole regions, and in little memory, with loose fragments. Use
// streams of volumes, and of balls, whose regions are smaller.
#include <discmc/decoder.hpp>
#include <discmc/stream/record_writing.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "oracle/symbol_contexts.hpp"

namespace {

using discmc::detail::stream::Record;
using discmc::detail::stream::RecordKind;
using Counts = std::array<double, discmc::detail::stream::contexts::end>;

struct CountingCoder {
  static constexpr bool writes = true;
  Counts* counts;
  uint32_t symbol(uint32_t row, uint32_t symbol) {
    ++(*counts)[row + symbol];
    return symbol;
  }
  uint32_t raw_bits(uint32_t, uint32_t value) { return value; }
};

// Encodes every record with a counting model, which restarts about as often as packets.
class Trainer {
 public:
  discmc::SinkResult accept(const discmc::Event& event) {
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
        make_room(Record::ring_words + 1);
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
        model_.record_kind(RecordKind::layer);
        model_.layer(event.slice);
        break;
      default:
        break;
    }
    return discmc::SinkResult::accepted;
  }
  const Counts& counts() const { return counts_; }

 private:
  using Model = discmc::detail::stream::RecordModel<CountingCoder>;

  void make_room(uint32_t words) {
    if (!record_.has_room(words)) encode_parts(false);
  }
  void end_record() {
    if (record_.continues || !encode_whole()) encode_parts(true);
    if (++records_ % records_per_packet != 0) return;
    model_.record_kind(RecordKind::end);
    model_ = Model({&counts_});
  }
  // Discards a region that is not closed.
  bool encode_whole() {
    const Counts counts = counts_;
    const Model model = model_;
    if (encode_record(model_, record_)) return true;
    counts_ = counts;
    model_ = model;
    return false;
  }
  void encode_parts(bool is_end) {
    while (record_.count > 0) {
      const uint32_t words = record_.words_of_part(record_.count);
      record_.is_last = is_end && words == record_.count;
      encode_part(model_, record_, words);
      record_.count -= words;
      for (uint32_t i = 0; i < record_.count; ++i) record_.word[i] = record_.word[i + words];
      record_.continues = true;
    }
  }

  static constexpr int records_per_packet = 60;
  Counts counts_{};
  Model model_{{&counts_}};
  Record record_;
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

// The frequencies of a context. They add up to 256: at least one for each valid symbol; the rest
// where it saves the most bits.
std::vector<uint32_t> frequencies_of(const double* counts, const std::vector<bool>& is_valid) {
  const auto symbols = is_valid.size();
  std::vector<uint32_t> frequencies(symbols);
  uint32_t left = 256;
  double total = 0;
  for (size_t i = 0; i < symbols; ++i) {
    frequencies[i] = is_valid[i] ? 1 : 0;
    left -= frequencies[i];
    total += counts[i];
  }
  const double unseen = total * 1e-5 + 1e-9;
  for (; left > 0; --left) {
    size_t best = 0;
    double max_saved = -1;
    for (size_t i = 0; i < symbols; ++i) {
      if (!is_valid[i]) continue;
      const double saved =
          (counts[i] + unseen) * std::log2((frequencies[i] + 1.0) / frequencies[i]);
      if (saved > max_saved) {
        best = i;
        max_saved = saved;
      }
    }
    ++frequencies[best];
  }
  return frequencies;
}

// In lines like those of the source.
void print(const std::vector<uint32_t>& numbers) {
  std::string line;
  for (const uint32_t number : numbers) {
    const std::string word = std::to_string(number) + ",";
    if (line.size() + 1 + word.size() > 100) {
      std::printf("%s\n", line.c_str());
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
  }
  std::printf("%s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: train_record_model STREAM.dmc...\n");
    return 2;
  }
  Counts all{};
  for (int i = 1; i < argc; ++i) {
    const Counts counts = counts_of(argv[i]);
    double total = 0;
    for (const double count : counts) total += count;
    for (size_t symbol = 0; symbol < all.size(); ++symbol)
      all[symbol] += counts[symbol] / total * 100000;
  }
  std::vector<uint32_t> below;
  for (const discmc::reference::SymbolContexts& of : discmc::reference::symbol_contexts())
    for (uint32_t context = 0; context < of.count; ++context) {
      std::vector<bool> is_valid(of.symbols, true);
      const uint32_t link_class = of.symbols == 2 ? 0 : of.symbols == 9 ? 1 : 2;
      if (of.name == std::string("corners"))
        for (uint32_t i = 0; i < of.symbols; ++i)
          is_valid[i] = discmc::reference::has_corners(link_class, i);
      uint32_t sum = 0;
      const double* const counts = &all[of.first + context * of.symbols];
      for (const uint32_t frequency : frequencies_of(counts, is_valid)) {
        below.push_back(sum & 0xFF);
        sum += frequency;
      }
    }
  below.push_back(0);
  print(below);
}

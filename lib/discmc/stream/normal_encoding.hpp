// The normals of a record's runs, as an extension record before the record.
// The first normal is stored in full, every other as the difference to the one before, in as few
// bits as the largest difference needs.
#ifndef DISCMC_STREAM_NORMAL_ENCODING_HPP
#define DISCMC_STREAM_NORMAL_ENCODING_HPP

#include <discmc/normal.hpp>
#include <discmc/stream/record_model.hpp>

namespace discmc::detail::stream {

/// The types of extensions that contain normals: the first for differences of 0 bits, the last for
/// 8.
constexpr uint32_t first_normals_extension = 1;
constexpr uint32_t last_normals_extension = first_normals_extension + 8;

/// The normals of an extension, in the order of the record's runs.
class RecordNormals {
 public:
  void clear() { count_ = 0; }
  /// The normal of run number `i`; none beyond those in the extension.
  OctahedralNormal at(uint32_t i) const {
    return i < count_ && !normal_[i].is_none() ? normal_[i] : OctahedralNormal{0, 0};
  }
  /// Reads an extension of `bytes` bytes. Limit: its type is one of those for normals.
  template <class Model>
  void decode(Model& model, uint32_t type, uint32_t bytes);

 private:
  OctahedralNormal normal_[Record::max_words];
  uint32_t count_ = 0;
};

// ---- implementation ----

namespace normal_difference {

// Small differences of either sign as small numbers: 0, -1, 1, -2, 2, ...
constexpr uint32_t number_of(uint8_t from, uint8_t to) {
  const uint32_t difference = (uint32_t{to} - from) & 0xFF;
  return difference < 128 ? 2 * difference : 2 * (255 - difference) + 1;
}
constexpr uint8_t sum(uint8_t from, uint32_t number) {
  return static_cast<uint8_t>(from + (number % 2 == 0 ? number / 2 : 255 - number / 2));
}

}  // namespace normal_difference

/// Encodes the normals of the runs among the record's first words; normals has one entry per word.
/// Encodes nothing if there is no normal.
template <class Model>
void encode_normals(Model& model, const Record& record, const OctahedralNormal* normals,
                    uint32_t words) {
  using namespace normal_difference;
  // Calls visit(normal, previous normal, is first) for every run.
  const auto for_each = [&](auto visit) {
    const OctahedralNormal* before = nullptr;
    for (uint32_t i = 0; i < words;) {
      if (record.word[i] == Record::ring_mark) {
        i += Record::ring_words;
        continue;
      }
      visit(normals[i], before == nullptr ? normals[i] : *before, before == nullptr);
      before = &normals[i++];
    }
  };
  uint32_t differences = 0, runs = 0;
  bool has_normals = false;
  for_each([&](OctahedralNormal normal, OctahedralNormal before, bool) {
    differences |= number_of(before.u, normal.u) | number_of(before.v, normal.v);
    has_normals = has_normals || !normal.is_none();
    ++runs;
  });
  if (!has_normals) return;
  uint32_t bits = 0;
  while (differences >> bits != 0) ++bits;
  const uint32_t total = 16 + 2 * bits * (runs - 1);
  const uint32_t bytes = (total + 7) / 8;
  model.record_kind(RecordKind::extension);
  model.raw_bits(8, first_normals_extension + bits);
  model.raw_bits(8, bytes);
  for_each([&](OctahedralNormal normal, OctahedralNormal before, bool is_first) {
    model.raw_bits(is_first ? 8 : bits, is_first ? normal.u : number_of(before.u, normal.u));
    model.raw_bits(is_first ? 8 : bits, is_first ? normal.v : number_of(before.v, normal.v));
  });
  model.raw_bits(8 * bytes - total, 0);
}

template <class Model>
void RecordNormals::decode(Model& model, uint32_t type, uint32_t bytes) {
  using namespace normal_difference;
  count_ = 0;
  uint32_t left = 8 * bytes;
  const uint32_t bits = type - first_normals_extension;
  if (left >= 16) {
    left -= 16;
    const auto u = static_cast<uint8_t>(model.raw_bits(8, 0));
    normal_[count_++] = {u, static_cast<uint8_t>(model.raw_bits(8, 0))};
  }
  for (; count_ > 0 && count_ < Record::max_words && left >= 2 * bits; left -= 2 * bits) {
    const OctahedralNormal before = normal_[count_ - 1];
    const uint8_t u = sum(before.u, model.raw_bits(bits, 0));
    normal_[count_++] = {u, sum(before.v, model.raw_bits(bits, 0))};
  }
  for (; left > 0; --left) model.raw_bits(1, 0);
}

}  // namespace discmc::detail::stream

#endif

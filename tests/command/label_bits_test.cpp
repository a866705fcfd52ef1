// The labels of a voxel in all layers, as bits.
#include "volumes/filters/filters.hpp"

#include "sample_reader.hpp"
#include "volume_files.hpp"

namespace {

using discmc::command::label_bits;
using discmc::command::LabelSet;
using discmc::command::VolumeReader;
using discmc::meshing::SampleType;
using sample_reader::SampleReader;

const std::vector<std::vector<int>> layers = {{0, 1, 1, 2, 0, 3, 3, 0}, {0, 1, 0, -5, -5, 0, 2, 2}};

std::unique_ptr<VolumeReader> bits_of(const std::vector<LabelSet>& sets) {
  std::map<std::uint32_t, std::unique_ptr<VolumeReader>> readers;
  for (const LabelSet& set : sets)
    for (const auto& [layer, values] : set)
      readers[layer] = std::make_unique<SampleReader>(
          discmc::reference::Size{2, 2, 2}, layers[layer], discmc::meshing::Point{1, 2, 3},
          layer == 0 ? SampleType::u16 : SampleType::i64);
  return label_bits(std::move(readers), sets);
}

}  // namespace

TEST_CASE("a label set's bit is on if the voxel has a label of the set in any layer") {
  const auto volume = bits_of({{{0, {1}}},
                               {{0, {2, 3}}, {1, {-5}}},
                               {{1, {}}},
                               {{1, {0}}},
                               {{0, {99}}},
                               {{0, {}}, {1, {2}}}});
  CHECK(volume->info().type == SampleType::u8);
  CHECK(volume->info().spacing_mm == discmc::meshing::Point{1, 2, 3});
  CHECK(volume_files::read_all(*volume) == std::vector<double>{8, 1 + 4 + 32, 1 + 8 + 32,
                                                               2 + 4 + 32, 2 + 4, 2 + 8 + 32,
                                                               2 + 4 + 32, 4 + 32});
}

TEST_CASE("the sample type of label bits has one bit per label set") {
  const std::pair<std::size_t, SampleType> types[] = {{8, SampleType::u8},
                                                      {9, SampleType::u16},
                                                      {17, SampleType::u32},
                                                      {33, SampleType::u64},
                                                      {64, SampleType::u64}};
  for (const auto& [count, type] : types) {
    std::vector<LabelSet> sets(count, LabelSet{{0, {7}}});
    sets.back() = {{0, {1}}};
    const auto volume = bits_of(sets);
    CHECK(volume->info().type == type);
    const double last = static_cast<double>(std::uint64_t{1} << (count - 1));
    CHECK(volume_files::read_all(*volume) == std::vector<double>{0, last, last, 0, 0, 0, 0, 0});
  }
}

TEST_CASE("skipping a slice of label bits skips the slice in every layer") {
  const auto volume = bits_of({{{0, {3}}}, {{1, {2}}}});
  volume->skip_slice();
  std::vector<std::uint8_t> slice(4);
  volume->read_slice(slice.data());
  CHECK(slice == std::vector<std::uint8_t>{0, 1, 3, 2});
}

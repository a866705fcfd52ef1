// How often which samples are there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// Counts samples of one type. Up to max_bins different samples have a bin each; this always holds
/// for 8 or 16 bits. Beyond, samples that differ only in their last bits share a bin, with as few
/// such bits as possible. Whole numbers are then counted to 2^n, floating point to a share of 2^-n,
/// mostly less than a thousandth.
/// Memory: 2 MiB, whatever comes.
class Histogram {
 public:
  static constexpr std::size_t max_bins = 65536;

  explicit Histogram(SampleType type);

  /// Takes finite samples, and counts the others. samples: of the type, aligned.
  void add(const void* samples, std::size_t count);

  struct Bin {
    double sample;  ///< the least that it can hold, or that has come
    std::uint64_t count;
    LabelValue whole;  ///< the same, exactly, where samples are whole numbers
  };
  /// All that are not empty, in the order of their samples.
  std::vector<Bin> bins() const;

  /// Whether every bin is of one sample.
  bool is_exact() const { return dropped_bits_ == 0; }

  /// The figures of the finite samples; 0 if there are none. Exact, except that a mean is rounded.
  double least() const;
  double greatest() const;
  double mean() const;
  /// The first two exactly. Limit: samples are whole numbers.
  LabelValue min_whole() const { return whole_of(min_key_); }
  LabelValue max_whole() const { return whole_of(max_key_); }

  std::uint64_t finite() const { return finite_; }
  std::uint64_t not_numbers() const { return not_numbers_; }
  std::uint64_t infinite() const { return infinite_; }

 private:
  // Open addressing. Keys are samples as whole numbers of the same order.
  struct Slot {
    std::uint64_t key;
    std::uint64_t count;  // 0: free
  };

  static constexpr double small_unit = 0x1p-64;  // so that no sum is infinite

  template <class Sample>
  void add_all(const Sample* samples, std::size_t count);
  void add_key(std::uint64_t key);
  Slot& slot_of(std::uint64_t key);
  void drop_a_bit();
  double sample_of(std::uint64_t key) const;
  LabelValue whole_of(std::uint64_t key) const;

  SampleType type_;
  std::vector<Slot> slots_;
  std::size_t used_ = 0;
  unsigned dropped_bits_ = 0;
  std::uint64_t min_key_;
  std::uint64_t max_key_ = 0;
  double sum_ = 0;
  double small_sum_ = 0;  // of samples of 64-bit floating point, each times small_unit
  std::uint64_t finite_ = 0;
  std::uint64_t not_numbers_ = 0;
  std::uint64_t infinite_ = 0;
};

}  // namespace discmc::command

// A histogram of samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meshing.hpp"
#include "samples/label_value.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// Counts samples of one type. Up to max_bins different samples have a bin each, which is always
/// enough for 8 or 16 bits. Beyond that, samples that differ only in their last bits share a bin,
/// with as few such bits as possible. Whole numbers are then counted in steps of 2^n, floating
/// point in relative steps of 2^-n, mostly below a thousandth. Memory: 2 MiB in all cases.
class Histogram {
 public:
  static constexpr std::size_t max_bins = 65536;

  explicit Histogram(SampleType type);

  /// Adds finite samples to the bins, and counts the others apart. samples: of the type, aligned.
  void add(const void* samples, std::size_t count);

  struct Bin {
    double sample;  ///< the least sample that the bin can hold, or has received
    std::uint64_t count;
    LabelValue whole;  ///< `sample`, exactly, if samples are whole numbers
  };
  /// Returns all bins that are not empty, in the order of their samples.
  std::vector<Bin> bins() const;

  /// Whether every bin holds one sample value.
  bool is_exact() const { return dropped_bits_ == 0; }

  /// These describe the finite samples; 0 if there are none. All are exact, but the mean is
  /// rounded.
  double least() const;
  double greatest() const;
  double mean() const;
  /// Exact bounds. Limit: samples are whole numbers.
  LabelValue min_whole() const { return whole_of(min_key_); }
  LabelValue max_whole() const { return whole_of(max_key_); }

  std::uint64_t finite() const { return finite_; }
  std::uint64_t not_numbers() const { return not_numbers_; }
  std::uint64_t infinite() const { return infinite_; }

 private:
  // A slot of the hash table, with open addressing. Keys are samples as whole numbers of the same
  // order.
  struct Slot {
    std::uint64_t key;
    std::uint64_t count;  // 0: free
  };

  static constexpr double small_unit = 0x1p-64;  // keeps every sum finite

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
  double small_sum_ = 0;  // sum of doubles, each times small_unit
  std::uint64_t finite_ = 0;
  std::uint64_t not_numbers_ = 0;
  std::uint64_t infinite_ = 0;
};

}  // namespace discmc::command

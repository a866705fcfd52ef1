// A scan whose rows come one at a time from a device, and whose surface leaves as a stream.
#pragma once

#include <array>
#include <cstdint>
#include <discmc/encoder.hpp>
#include <discmc/extractor.hpp>
#include <ostream>
#include <variant>
#include <vector>

#include "samples/sample_type.hpp"

namespace discmc::device {

/// What is scanned, and how.
struct ScanPlan {
  /// Samples per row, rows per slice, and slices at most.
  std::array<std::uint32_t, 3> dims{};
  /// Limit: is_scanner_type(type).
  meshing::SampleType type = meshing::SampleType::u8;
  /// The distance between voxels. Units: millimetres.
  std::array<double, 3> spacing_mm{1, 1, 1};
  std::int32_t threshold = 0;  ///< a voxel is on if its sample is >= threshold
  Border border = Border::closed;
  /// The size of the arena. Units: bytes.
  std::uint64_t memory = std::uint64_t{16} << 20;

  /// Units: bytes.
  std::size_t row_bytes() const { return dims[0] * meshing::sample_bytes(type); }
  /// Limit: dims[1] * dims[2] fit into 32 bits.
  std::uint32_t rows() const { return dims[1] * dims[2]; }
};

/// Rows are counted over all slices from 0. Every row is pushed or skipped, once and in order.
class RowScan {
 public:
  /// Begins the stream. output: takes everything at once. Throws std::invalid_argument when the
  /// memory is too small (the text names the least), and where the plan makes no stream.
  RowScan(const ScanPlan& plan, const ByteOutput& output);
  RowScan(const RowScan&) = delete;
  RowScan& operator=(const RowScan&) = delete;

  /// Takes the next row. Size: row_bytes() of the plan, 16-bit samples with the low byte first.
  /// Limit: not after the last row, as with skip().
  void push(const std::uint8_t* row);

  /// Replaces rows that never came: the previous row is repeated, and the stream marks this. No
  /// more than the plan has left.
  void skip(std::uint32_t rows);

  /// Ends the scan: whole where a slice is, else abandoned in the middle of it.
  void finish();

  /// Ends a scan that broke off. The stream is valid and marked as abandoned.
  void abandon();

  /// Rows so far, skipped ones included.
  std::uint32_t rows() const { return rows_; }
  bool has_all_rows() const { return rows_ == plan_.rows(); }
  /// Nothing was skipped and no row of the plan is missing.
  bool is_whole() const { return has_all_rows() && statistics().skipped_rows == 0; }
  Statistics statistics() const;

  /// One key and value a line, for people and programs.
  void report(std::ostream& out) const;

 private:
  template <class Sample>
  Status push_samples(const std::uint8_t* row);

  ScanPlan plan_;
  std::vector<std::uint8_t> memory_;
  Encoder encoder_;
  // Indices as wide as `discmc extract` takes for as much memory, so that the streams are the same.
  std::variant<Extractor16, Extractor32> extractor_;
  std::uint32_t rows_ = 0;
};

}  // namespace discmc::device

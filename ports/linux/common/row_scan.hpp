// A scan with rows from a device, one at a time, and its surface as a stream.
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

/// The parameters of a scan.
struct ScanPlan {
  /// Samples per row, rows per slice, and the maximum number of slices.
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
  /// Begins the stream. output: accepts everything at once. Throws std::invalid_argument if the
  /// memory is too small (the text names the minimum), or if the plan is invalid.
  RowScan(const ScanPlan& plan, const ByteOutput& output);
  RowScan(const RowScan&) = delete;
  RowScan& operator=(const RowScan&) = delete;

  /// Accepts the next row. Size: row_bytes() of the plan; 16-bit samples are little-endian. Limit:
  /// not after the last row, as for skip().
  void push(const std::uint8_t* row);

  /// Replaces missing rows by the previous row, and marks them in the stream. Limit: the rows that
  /// are left in the plan.
  void skip(std::uint32_t rows);

  /// Ends the scan: completes it after a whole slice, else abandons it.
  void finish();

  /// Ends an interrupted scan. The stream is valid and marked as abandoned.
  void abandon();

  /// Rows so far, including skipped ones.
  std::uint32_t rows() const { return rows_; }
  bool has_all_rows() const { return rows_ == plan_.rows(); }
  /// Whether no row was skipped and no row of the plan is missing.
  bool is_whole() const { return has_all_rows() && statistics().skipped_rows == 0; }
  Statistics statistics() const;

  /// Prints one key and value per line.
  void report(std::ostream& out) const;

 private:
  template <class Sample>
  Status push_samples(const std::uint8_t* row);

  ScanPlan plan_;
  std::vector<std::uint8_t> memory_;
  Encoder encoder_;
  // Indices as wide as those of `discmc extract` for this memory, so that the streams are equal.
  std::variant<Extractor16, Extractor32> extractor_;
  std::uint32_t rows_ = 0;
};

}  // namespace discmc::device

// Assembles rows from the reports of a scanner, and detects lost and repeated reports.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "report.hpp"

namespace discmc::device {

/// A row with a missing report is lost. HID keeps the order of reports, so an earlier report is a
/// repeated one.
class RowAssembler {
 public:
  /// The result of a report. The lost rows come before the row.
  struct Received {
    std::uint32_t lost_rows = 0;
    bool has_row = false;  ///< row() is whole
    bool has_ended = false;
  };

  /// row_bytes: Limit: 1 to 65,532.
  RowAssembler(std::size_t row_bytes, std::uint32_t rows);

  /// Adds a report of any bytes. The lost and received rows are never more than the rows of the
  /// scan.
  Received add(const std::uint8_t* report, std::size_t count);

  /// Valid until the next add().
  const std::uint8_t* row() const { return row_.data(); }

  /// Prints one key and value per line.
  void report(std::ostream& out) const;

  std::uint64_t lost_reports() const { return lost_; }
  std::uint64_t repeated_reports() const { return repeated_; }
  std::uint64_t unreadable_reports() const { return unreadable_; }

 private:
  Received add_chunk(const Report& report);
  Received add_end(std::uint32_t rows);
  bool is_valid(const Report& report) const;
  std::uint64_t chunks() const {
    return (row_.size() + Report::payload_bytes - 1) / Report::payload_bytes;
  }

  std::vector<std::uint8_t> row_;
  std::uint32_t rows_;
  std::uint32_t next_row_ = 0;       // the first that has not been reported
  std::uint64_t next_position_ = 0;  // of a report among those of all rows
  bool is_damaged_ = false;          // the next row lacks a report
  std::uint64_t reports_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t repeated_ = 0;
  std::uint64_t unreadable_ = 0;
};

}  // namespace discmc::device

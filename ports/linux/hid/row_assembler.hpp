// Rows from the reports of a scanner: lost and repeated ones are noticed.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "report.hpp"

namespace discmc::device {

/// A row of which a report is missing is lost as a whole. Reports come in their order, as HID keeps
/// it: one from before is a repeated one.
class RowAssembler {
 public:
  /// What a report came to. The lost rows come before the row.
  struct Taken {
    std::uint32_t lost_rows = 0;
    bool has_row = false;  ///< row() is whole
    bool has_ended = false;
  };

  /// row_bytes: Limit: 1 to 65,532.
  RowAssembler(std::size_t row_bytes, std::uint32_t rows);

  /// Takes any bytes. The lost and received rows are never more than the rows of the scan.
  Taken take(const std::uint8_t* report, std::size_t count);

  /// Valid until the next take().
  const std::uint8_t* row() const { return row_.data(); }

  /// One key and value a line, for people and programs.
  void report(std::ostream& out) const;

  std::uint64_t lost_reports() const { return lost_; }
  std::uint64_t repeated_reports() const { return repeated_; }
  std::uint64_t unreadable_reports() const { return unreadable_; }

 private:
  Taken take_chunk(const Report& report);
  Taken take_end(std::uint32_t rows);
  bool is_valid(const Report& report) const;
  std::uint64_t chunks() const {
    return (row_.size() + Report::payload_bytes - 1) / Report::payload_bytes;
  }

  std::vector<std::uint8_t> row_;
  std::uint32_t rows_;
  std::uint32_t next_row_ = 0;       // the first that is not reported yet
  std::uint64_t next_position_ = 0;  // of a report among those of all rows
  bool is_damaged_ = false;          // the next row lacks a report
  std::uint64_t reports_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t repeated_ = 0;
  std::uint64_t unreadable_ = 0;
};

}  // namespace discmc::device

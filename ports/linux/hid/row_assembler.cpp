#include "row_assembler.hpp"

#include <algorithm>

namespace discmc::device {

RowAssembler::RowAssembler(std::size_t row_bytes, std::uint32_t rows)
    : row_(row_bytes), rows_(rows) {}

RowAssembler::Received RowAssembler::add(const std::uint8_t* report, std::size_t count) {
  ++reports_;
  const auto read = Report::read(report, count);
  if (!read || !is_valid(*read)) {
    ++unreadable_;
    return {};
  }
  return read->kind == Report::Kind::end ? add_end(read->number) : add_chunk(*read);
}

bool RowAssembler::is_valid(const Report& report) const {
  if (report.kind == Report::Kind::end) return report.number <= rows_;
  if (report.kind != Report::Kind::row || report.number >= rows_ || report.chunk >= chunks())
    return false;
  const std::size_t begin = report.chunk * Report::payload_bytes;
  return report.length == std::min(row_.size() - begin, Report::payload_bytes);
}

RowAssembler::Received RowAssembler::add_chunk(const Report& report) {
  const std::uint64_t position = report.number * chunks() + report.chunk;
  if (position < next_position_) {
    ++repeated_;
    return {};
  }
  const bool follows_loss = position > next_position_;
  lost_ += position - next_position_;
  next_position_ = position + 1;

  Received received;
  received.lost_rows = report.number - next_row_;
  next_row_ = report.number;
  if (received.lost_rows > 0) is_damaged_ = false;
  if (follows_loss && report.chunk > 0) is_damaged_ = true;
  std::copy_n(report.payload, report.length,
              row_.begin() + report.chunk * static_cast<std::ptrdiff_t>(Report::payload_bytes));

  if (report.chunk + 1U < chunks()) return received;
  ++next_row_;
  received.has_row = !is_damaged_;
  if (is_damaged_) ++received.lost_rows;
  is_damaged_ = false;
  return received;
}

RowAssembler::Received RowAssembler::add_end(std::uint32_t rows) {
  const std::uint64_t position = rows * chunks();
  Received received;
  received.has_ended = true;
  if (position < next_position_) return received;
  lost_ += position - next_position_;
  received.lost_rows = rows - next_row_;
  next_row_ = rows;
  next_position_ = position;
  return received;
}

void RowAssembler::report(std::ostream& out) const {
  out << "reports " << reports_ << '\n'
      << "reports_lost " << lost_ << '\n'
      << "reports_repeated " << repeated_ << '\n'
      << "reports_unreadable " << unreadable_ << '\n';
}

}  // namespace discmc::device

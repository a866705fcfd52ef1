// The scan driven by the lines of a stage: the rows of edges, and the state of the scan.
#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <vector>

#include "button.hpp"
#include "common/row_scan.hpp"
#include "edge_counter.hpp"
#include "row_source.hpp"

namespace discmc::device {

/// Every edge of the sync line is a row while the scan runs, and none while it waits or is paused.
/// A missed edge is a skipped row.
///
///   brief press     the scan starts, pauses, continues, pauses, ...
///   lengthy press   the scan ends
///   end-stop        the scan ends
class TriggeredScan {
 public:
  enum class State : std::uint8_t { waiting, running, paused, ended };

  /// Without a button the scan runs at once. Owner: scan and source outlive this object.
  TriggeredScan(RowScan& scan, RowSource& source, std::size_t row_bytes, bool has_button)
      : scan_(scan),
        source_(source),
        row_(row_bytes),
        state_(has_button ? State::waiting : State::running) {}

  /// Processes the next event. After the end of the scan, has no effect.
  void process(const LineEvent& event);

  State state() const { return state_; }
  /// The number of edges missed while the scan ran.
  std::uint64_t missed() const { return missed_; }

  /// The row of the first missed edge; none if no edge was missed.
  std::optional<std::uint32_t> first_missed_row() const { return first_missed_row_; }

  /// Prints the counts of edges like RowScan::report().
  void report(std::ostream& out) const;

 private:
  void process_edge(const LineEvent& edge);
  void press(Button::Press press);

  RowScan& scan_;
  RowSource& source_;
  std::vector<std::uint8_t> row_;
  State state_;
  Button button_;
  EdgeCounter counter_;
  std::uint64_t edges_ = 0;
  std::uint64_t missed_ = 0;
  std::optional<std::uint32_t> first_missed_row_;
  std::uint64_t unused_ = 0;  // edges while the scan was not running
};

}  // namespace discmc::device

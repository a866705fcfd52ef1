// Checks the tracer's table so that any wrong byte is detected. The facets of a cell are the
// reference: the sectors of a vertex in its four cells are looked up in the table of facets. This
// uses only geometry, and none of the code that derives the sectors.
#pragma once

#include <discmc/trace/sector_table.hpp>

namespace discmc::reference {

/// Returns the first statement that a table breaks, or nullptr. The table may have any bytes.
const char* broken(const detail::trace::SectorTable& table);

}  // namespace discmc::reference

// The checks of the tracer's table, so that any wrong byte is detected. The facets of a cell are
// the authority: the sectors of a vertex in its four cells are looked up in the table of facets.
// This uses geometry alone, and none of the code that derives the sectors.
#pragma once

#include <discmc/trace/sector_table.hpp>

namespace discmc::reference {

/// The first statement that a table breaks, in words, or nullptr. Any bytes may be in the table.
const char* broken(const detail::trace::SectorTable& table);

}  // namespace discmc::reference

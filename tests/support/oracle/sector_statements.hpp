// What must hold of the table of the tracer, so that any wrong byte breaks it. The facets of a
// cell are the authority: what a vertex sees of each of its four cells is looked up in the table of
// facets, by geometry alone, with nothing of the code that derives the sectors.
#ifndef DISCMC_TESTS_ORACLE_SECTOR_STATEMENTS_HPP
#define DISCMC_TESTS_ORACLE_SECTOR_STATEMENTS_HPP

#include <discmc/trace/sector_table.hpp>

namespace discmc::reference {

/// The first statement that a table breaks, in words, or nullptr. Any bytes may be in the table.
const char* broken(const detail::trace::SectorTable& table);

}  // namespace discmc::reference

#endif

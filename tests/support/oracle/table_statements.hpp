// Statements about the derived tables, so that any wrong byte breaks one. They treat the tables as
// data. None uses the code that derives them, except the loops of cell.hpp, which cell_test.cpp
// tests.
#pragma once

#include <discmc/geometry/facet_table.hpp>
#include <discmc/stream/frequencies.hpp>

#include <iterator>

namespace discmc::reference {

/// The three tables of facets.
struct FacetTables {
  FacetTable table;
  FacetRings rings;
  CellFacts facts;
};

/// The cumulative frequencies of the stream's symbols.
struct ModelTable {
  uint8_t frequencies[std::size(detail::stream::cumulative_frequencies)];
};

/// Returns the tables of the library.
FacetTables facet_tables();
ModelTable model_table();

/// Returns the first statement that a table breaks, or nullptr. The table may have any bytes.
const char* broken(const LinkTable& links);
const char* broken(const FacetTables& facets);
const char* broken(const ModelTable& model);

}  // namespace discmc::reference

// Changes every byte of every derived table to every other value, one at a time. The statements
// about the tables (oracle/*_statements.hpp, asserted by properties/tables_test.cpp) must detect
// each change. Exceptions are listed below, with their reasons. Prints a line per field and per
// statement; the exit code is 1 if a change survives. An address sanitizer reduces the values to
// one in 37.
#include <cinttypes>
#include <cstddef>
#include <cstdio>
#include <map>
#include <string>

#include "oracle/sector_statements.hpp"
#include "oracle/table_statements.hpp"
#include "oracle/thinned.hpp"

using namespace discmc;
using namespace discmc::reference;
using namespace discmc::detail::trace;

namespace {

/// A field of a table, as bytes.
struct Field {
  const char* name;
  size_t offset;
  size_t bytes;
  /// Returns the reason why a change of a byte of the field has no effect, or nullptr.
  const char* (*equivalent)(size_t byte);
};

const char* never(size_t) {
  return nullptr;
}

// ---- all equivalent mutants ----

const char* beyond_directions(size_t byte) {
  constexpr size_t places = max_directions / 2;
  const auto incidence = static_cast<Incidence>(byte / places);
  return byte % places >= direction_count(incidence) / 2U
             ? "a direction that the plane does not have is never read"
             : nullptr;
}

const char* beyond_ring(size_t byte) {
  const FacetRing& ring = facet_rings.ring[byte / sizeof(FacetRing)];
  const size_t within = byte % sizeof(FacetRing);
  return within >= offsetof(FacetRing, point) + ring.count
             ? "a point beyond the count of the ring is never read"
             : nullptr;
}

// ---- the tables ----

#define DISCMC_FIELD(Table, member, equivalent) \
  { #Table "::" #member, offsetof(Table, member), sizeof(Table::member), equivalent }

constexpr Field link_fields[] = {DISCMC_FIELD(LinkTable, vector, never),
                                 DISCMC_FIELD(LinkTable, direction_count, never),
                                 DISCMC_FIELD(LinkTable, link, beyond_directions)};

constexpr Field facet_fields[] = {
    DISCMC_FIELD(FacetTables, table.first, never), DISCMC_FIELD(FacetTables, table.facet, never),
    DISCMC_FIELD(FacetTables, rings, beyond_ring), DISCMC_FIELD(FacetTables, facts, never)};

constexpr Field sector_fields[] = {
    DISCMC_FIELD(SectorTable, cell, never), DISCMC_FIELD(SectorTable, axis, never),
    DISCMC_FIELD(SectorTable, face_way, never), DISCMC_FIELD(SectorTable, edges, never),
    DISCMC_FIELD(SectorTable, part, never)};

constexpr Field model_fields[] = {DISCMC_FIELD(ModelTable, frequencies, never)};
#undef DISCMC_FIELD

struct Tally {
  uint64_t killed = 0, equivalent = 0, survivors = 0;
  std::map<std::string, uint64_t> killed_by;  // by statement

  void print(const char* name) const {
    std::printf("%-28s %8" PRIu64 " mutants  %8" PRIu64 " killed  %5" PRIu64 " equivalent  %" PRIu64
                " survived\n",
                name, killed + equivalent + survivors, killed, equivalent, survivors);
  }
};

template <class Table>
void mutate(const Table& right, const Field& field, Tally& tally) {
  Table table = right;
  auto* const bytes = reinterpret_cast<unsigned char*>(&table) + field.offset;
  for (size_t at = 0; at < field.bytes; ++at) {
    const unsigned char was = bytes[at];
    for (int value = 0; value < 256; value += static_cast<int>(step(37))) {
      if (value == was) continue;
      bytes[at] = static_cast<unsigned char>(value);
      if (const char* statement = broken(table)) {
        ++tally.killed;
        ++tally.killed_by[statement];
      } else if (field.equivalent(at) != nullptr) {
        ++tally.equivalent;
      } else {
        ++tally.survivors;
        std::printf("survivor: byte %zu of %s, %d instead of %d\n", at, field.name, value, was);
      }
    }
    bytes[at] = was;
  }
}

template <class Table, size_t fields>
Tally mutate_all(const Table& right, const Field (&all)[fields]) {
  Tally sum;
  if (const char* statement = broken(right)) {
    std::printf("the table itself breaks: %s\n", statement);
    ++sum.survivors;
    return sum;
  }
  for (const Field& field : all) {
    Tally tally;
    mutate(right, field, tally);
    tally.print(field.name);
    sum.killed += tally.killed;
    sum.equivalent += tally.equivalent;
    sum.survivors += tally.survivors;
    for (const auto& [statement, count] : tally.killed_by) sum.killed_by[statement] += count;
  }
  for (const auto& [statement, count] : sum.killed_by)
    std::printf("  %8" PRIu64 " by: %s\n", count, statement.c_str());
  return sum;
}

}  // namespace

int main() {
  uint64_t survivors = 0;
  survivors += mutate_all(detail::link_table, link_fields).survivors;
  survivors += mutate_all(facet_tables(), facet_fields).survivors;
  survivors += mutate_all(sector_table, sector_fields).survivors;
  survivors += mutate_all(model_table(), model_fields).survivors;
  return survivors == 0 ? 0 : 1;
}

// Derives the tracer's tables again at run time. They equal the tables that the compiler derived,
// and the coverage of the source can be measured.
//
// Includes the source, so the linker omits the library's object of it.
#include <discmc/trace/sector_table.cpp>

#include <string.h>
#include <discmc/trace/fragments.hpp>
#include <discmc/trace/neighbourhood.hpp>

#include "oracle/sector_statements.hpp"
#include "test.hpp"

namespace discmc::detail::trace {
namespace {

TEST_CASE("the sector table derived at run time equals the compile-time table") {
  SectorTable table{};
  table = derive::sector_table();  // a constant would be derived by the compiler
  CHECK(reference::broken(table) == nullptr);
  CHECK(are_all_queues_used());
  CHECK(memcmp(table.cell, sector_table.cell, sizeof table.cell) == 0);
  CHECK(memcmp(table.axis, sector_table.axis, sizeof table.axis) == 0);
  CHECK(memcmp(table.face_way, sector_table.face_way, sizeof table.face_way) == 0);
  CHECK(memcmp(table.edges, sector_table.edges, sizeof table.edges) == 0);
  CHECK(memcmp(table.part, sector_table.part, sizeof table.part) == 0);
}

TEST_CASE("row lines derived at run time equal the compile-time row lines") {
  LineBits bits{};
  bits = derive::line_bits(6, 8, 2);
  for (int row = 0; row < 8; ++row) CHECK(bits.by_row[row] == lines_of_y[1].by_row[row]);
  CHECK(bits.by_row[7] == (1 << 12 | 1 << 4));
}

TEST_CASE("link steps derived at run time equal the compile-time link steps") {
  LinkSteps again{};
  again = derive::link_steps();
  CHECK(memcmp(&again, &link_steps, sizeof again) == 0);  // the numbers have no gaps
}

TEST_CASE("cell edge numbers derived at run time equal the compile-time numbers") {
  derive::EdgeNumbers again{};
  again = derive::number_edges();
  for (int i = 0; i < cell_edges; ++i) {
    CHECK(again.point[i] == derive::edges.point[i]);
    CHECK(again.number[again.point[i]] == i);
  }
}

}  // namespace
}  // namespace discmc::detail::trace

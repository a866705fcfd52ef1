// Edges are collected in batches.
#include "host/edges.hpp"
#include "test.hpp"

using namespace discmc;
using host::Edges;

namespace {

constexpr uint32_t words = 1;
constexpr uint32_t on[] = {4}, off[] = {0};  // the first voxel of a row

// A row of a slice with one on voxel.
detail::trace::SweptRow row_of(int32_t z) {
  detail::trace::SweptRow row{};
  for (auto& slice : row.around.row)
    for (const uint32_t*& each : slice) each = off;
  row.around.row[1][1] = on;
  row.words = words;
  row.width = 20;
  row.z = z;
  row.role = detail::trace::SlabRole::inside;
  row.set_absent_quadrants();
  return row;
}

}  // namespace

TEST_CASE("a batch contains edges of several rows") {
  Edges edges;
  edges.clear();
  CHECK_FALSE(edges.collect(row_of(3), 3));
  const uint32_t of_row = edges.count();
  CHECK(of_row == 4);
  CHECK_FALSE(edges.collect(row_of(3), 3));
  CHECK(edges.count() == 2 * of_row);
  edges.discard_all();
  CHECK(edges.is_empty());
}

// Flash: a gradient of 8-bit samples as an octahedral normal and as one in Q1.14.
#include <discmc/trace/sample_rows.hpp>

using namespace discmc;

extern "C" UnitNormal run(const detail::trace::SampleRows<uint8_t>& rows, const Vertex& vertex,
                          const AxisWeights& weights, OctahedralNormal& octahedral) {
  const LongVector down = weighted(rows.negative_gradient(vertex), weights);
  octahedral = octahedral_normal(down);
  return unit_normal(down);
}

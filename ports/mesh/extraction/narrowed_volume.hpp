// A volume of any sample type in 16 bits, for what takes no others: gradients.
#ifndef DISCMC_MESH_EXTRACTION_NARROWED_VOLUME_HPP
#define DISCMC_MESH_EXTRACTION_NARROWED_VOLUME_HPP

#include <memory>

#include "samples/sample_bounds.hpp"
#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// The volume as 16-bit samples with sign, whose values are counted from iso. They are negative
/// exactly if the value is below iso, and in proportion as far as 16 bits allow.
/// So the surface at 0 is that of the volume at iso. A sample that is not a number is just below
/// it. bounds: of the volume.
std::unique_ptr<SliceReader> narrowed(std::unique_ptr<SliceReader> volume,
                                      const SampleBounds& bounds, double iso);

}  // namespace discmc::meshing

#endif

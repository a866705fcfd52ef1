// Converts a volume of any sample type to 16 bits, which gradients need.
#ifndef DISCMC_MESH_EXTRACTION_NARROWED_VOLUME_HPP
#define DISCMC_MESH_EXTRACTION_NARROWED_VOLUME_HPP

#include <memory>

#include "samples/sample_bounds.hpp"
#include "samples/slice_reader.hpp"

namespace discmc::meshing {

/// Returns the volume as signed 16-bit samples, with values relative to iso. They are negative
/// exactly if the value is below iso, and proportional as far as 16 bits allow. The surface at 0 is
/// therefore the volume's at iso. NaN becomes a sample just below 0. bounds: of the volume.
std::unique_ptr<SliceReader> narrowed(std::unique_ptr<SliceReader> volume,
                                      const SampleBounds& bounds, double iso);

}  // namespace discmc::meshing

#endif

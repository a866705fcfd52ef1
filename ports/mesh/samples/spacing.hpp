// Converts the spacing between the forms of volumes and streams.
#ifndef DISCMC_MESH_SAMPLES_SPACING_HPP
#define DISCMC_MESH_SAMPLES_SPACING_HPP

#include <array>
#include <cstdint>

#include <discmc/sink.hpp>

namespace discmc::meshing {

/// Returns the spacing in the form of headers. Throws std::invalid_argument beyond their range.
std::array<std::int32_t, 3> spacing_nm(const std::array<double, 3>& spacing_mm);

/// Returns the header's spacing, or 1 if the stream has none. Units: millimetres.
std::array<double, 3> spacing_mm(const StreamHeader& header);

}  // namespace discmc::meshing

#endif

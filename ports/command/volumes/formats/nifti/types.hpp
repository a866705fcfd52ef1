// The types of samples that NIfTI files have.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_NIFTI_TYPES_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_NIFTI_TYPES_HPP

#include <cstdint>
#include <optional>

#include "meshing.hpp"
#include "samples/sample_type.hpp"

namespace discmc::command {

/// The field `datatype` of their headers. Nothing where it is of no samples that are taken.
std::optional<SampleType> type_of_nifti(int datatype);
std::int16_t nifti_type_of(SampleType type);

}  // namespace discmc::command

#endif

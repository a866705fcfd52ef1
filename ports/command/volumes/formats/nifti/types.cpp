#include "types.hpp"

#include <nifti1.h>

#include <cstddef>

namespace discmc::command {
namespace {

// By the numbers of the sample types.
constexpr std::int16_t datatypes[] = {DT_UINT8, DT_INT8,   DT_UINT16, DT_INT16,   DT_UINT32,
                                      DT_INT32, DT_UINT64, DT_INT64,  DT_FLOAT32, DT_FLOAT64};

}  // namespace

std::optional<SampleType> type_of_nifti(int datatype) {
  for (const auto& [called, type] : sample_types)
    if (nifti_type_of(type) == datatype) return type;
  return std::nullopt;
}

std::int16_t nifti_type_of(SampleType type) {
  return datatypes[static_cast<std::size_t>(type)];
}

}  // namespace discmc::command

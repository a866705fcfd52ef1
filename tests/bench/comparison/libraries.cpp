// Settings of the other libraries.
#include <malloc.h>
#include <meshoptimizer.h>
#include <openvdb/version.h>
#include <tbb/global_control.h>
#include <vtkLogger.h>
#include <vtkSMPTools.h>
#include <vtkVersion.h>

#include <climits>
#include <stdexcept>

#include "contenders.hpp"

namespace discmc::bench {

void settle() {
  mallopt(M_MMAP_THRESHOLD, INT_MAX);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  static const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_WARNING);
  if (!vtkSMPTools::SetBackend("Sequential")) throw std::runtime_error("VTK insists on threads");
}

std::string versions() {
  constexpr int version = MESHOPTIMIZER_VERSION;
  return std::string("VTK ") + vtkVersion::GetVTKVersion() + ", OpenVDB " +
         openvdb::getLibraryVersionString() + ", meshoptimizer " + std::to_string(version / 1000) +
         "." + std::to_string(version % 1000 / 10);
}

}  // namespace discmc::bench

// The private header that Siemens scanners write into MR images.
#ifndef DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_CSA_HEADER_HPP
#define DISCMC_COMMAND_VOLUMES_FORMATS_DICOM_CSA_HEADER_HPP

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace discmc::command {

/// The values of each element, as text without blanks.
using CsaHeader = std::map<std::string, std::vector<std::string>>;

/// Reads a CSA image header, of the newer kind (SV10) or the older. Any bytes have a content: what
/// is before the first damage.
CsaHeader read_csa_header(std::string_view bytes);

}  // namespace discmc::command

#endif

// Values in the text of headers.
#ifndef DISCMC_COMMAND_VOLUMES_HEADER_TEXT_HPP
#define DISCMC_COMMAND_VOLUMES_HEADER_TEXT_HPP

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace discmc::command {

/// Return the number when the text is one and nothing else; a real may be nan or infinite. The file
/// and the name of the field are for the VolumeError thrown otherwise.
std::int64_t integer(const std::filesystem::path& file, std::string_view field,
                     std::string_view text);
double real(const std::filesystem::path& file, std::string_view field, std::string_view text);

/// Returns the file beside the header that its text names. Throws when that is no name.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace discmc::command

#endif

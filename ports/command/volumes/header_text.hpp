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

/// Whether a name is not of something in a folder or the folders in it.
bool leads_out(std::string_view name);

/// Returns the file or folder that the text of a header names, beside the header or in a folder
/// there. Throws when that is no name, or one that leads out: headers come from strangers, who must
/// not choose among all files of the user.
std::filesystem::path beside(const std::filesystem::path& header, std::string_view name);

}  // namespace discmc::command

#endif

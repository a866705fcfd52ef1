// Files that commands take and that are no volumes, by their names.
#ifndef DISCMC_COMMAND_VOLUMES_OTHER_KINDS_HPP
#define DISCMC_COMMAND_VOLUMES_OTHER_KINDS_HPP

#include <filesystem>

namespace discmc::host {

bool is_stream_name(const std::filesystem::path& file);
bool is_mesh_name(const std::filesystem::path& file);

}  // namespace discmc::host

#endif

// Formats by the first bytes of their files.
#ifndef DISCMC_COMMAND_VOLUMES_MAGIC_HPP
#define DISCMC_COMMAND_VOLUMES_MAGIC_HPP

#include <cstddef>
#include <optional>
#include <string_view>

namespace discmc::command {

/// Units: bytes from the beginning of a file that tell its format.
constexpr std::size_t magic_bytes = 348;

/// The name of the format that begins so, of those known to have a header; nothing otherwise.
/// head: the first magic_bytes, fewer where there are no more.
std::optional<std::string_view> format_of_head(std::string_view head);

/// Whether bytes begin like a file of a format with a header, or of one that is packed; of volumes
/// that is, and streams never do.
inline bool is_volume_head(std::string_view head) {
  return format_of_head(head).has_value();
}

}  // namespace discmc::command

#endif

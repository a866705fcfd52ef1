// The message for a failed write.
#pragma once

#include <cerrno>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace discmc::command {

/// Returns a message such as "writing failed (No space left on device); free space, or write to
/// another disk". Call it soon after the write, because the reason is in errno. The message omits
/// the reason if errno has another origin.
inline std::string write_failure() {
  std::string reason;
  for (const int write_error : {ENOSPC, EDQUOT, EFBIG, EIO, EPIPE})
    if (errno == write_error) reason = " (" + std::generic_category().message(write_error) + ")";
  return "writing failed" + reason + "; free space, or write to another disk";
}

inline void require_written(std::ostream& out) {
  if (!out.flush()) throw std::runtime_error("standard output: " + write_failure());
}

}  // namespace discmc::command

// Standard output that must be written; otherwise the command fails.
#ifndef DISCMC_COMMAND_FILES_REQUIRE_WRITTEN_HPP
#define DISCMC_COMMAND_FILES_REQUIRE_WRITTEN_HPP

#include <ostream>
#include <stdexcept>

#include "write_failure.hpp"

namespace discmc::command {

inline void require_written(std::ostream& out) {
  if (!out.flush()) throw std::runtime_error("standard output: " + write_failure());
}

}  // namespace discmc::command

#endif

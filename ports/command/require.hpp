// Calls that must succeed; otherwise the command fails.
#ifndef DISCMC_COMMAND_REQUIRE_HPP
#define DISCMC_COMMAND_REQUIRE_HPP

#include <discmc/status.hpp>
#include <ostream>
#include <stdexcept>

#include "files/write_failure.hpp"

namespace discmc::command {

inline void require(Status status) {
  if (status != Status::ok) throw std::runtime_error(to_string(status));
}

inline void require_written(std::ostream& out) {
  if (!out.flush()) throw std::runtime_error("standard output: " + write_failure());
}

}  // namespace discmc::command

#endif

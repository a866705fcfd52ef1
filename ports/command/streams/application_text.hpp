// What application records say, in words.
#ifndef DISCMC_COMMAND_STREAMS_APPLICATION_TEXT_HPP
#define DISCMC_COMMAND_STREAMS_APPLICATION_TEXT_HPP

#include <string>

#include <discmc/sink.hpp>

namespace discmc::command {

/// A record in one line: its kind, where it was told, and its bytes; of a placement what it says.
std::string text(const ApplicationRecord& record);

}  // namespace discmc::command

#endif
